package dev.lazyz.spark

import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.world.surface.Mesh
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** Model files for tests. */
object Models {
    /** Returns the teapot as a binary STL file. */
    fun stl(segments: Int = 6): ByteArray {
        val meshes = Scenes.teapot(segments).surfaces.filterIsInstance<Mesh>()
        val count = meshes.sumOf { it.triangleCount }
        val bytes = ByteBuffer.allocate(84 + 50 * count).order(ByteOrder.LITTLE_ENDIAN).putInt(80, count).position(84)
        for (mesh in meshes) {
            for ((i, vertex) in mesh.triangles.withIndex()) {
                if (i % 3 == 0) for (zero in 0 until 3) bytes.putFloat(0f)

                // z points up in STL files
                bytes.putFloat(mesh.positions[3 * vertex]).putFloat(-mesh.positions[3 * vertex + 2])
                bytes.putFloat(mesh.positions[3 * vertex + 1])
                if (i % 3 == 2) bytes.putShort(0)
            }
        }
        return bytes.array()
    }

    /** A tetrahedron. */
    const val OBJ: String = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"

    /** Writes a small collection with bad models to [folder]. */
    @JvmStatic
    fun collection(folder: Path): Path {
        folder.createDirectories()
        folder.resolve("teapot.stl").writeBytes(stl())
        folder.resolve("tetrahedron.obj").writeText(OBJ)
        folder.resolve("cut.stl").writeBytes(stl().copyOf(1000))
        folder.resolve("missing.obj").writeText("f 1 2 3\n")
        folder.resolve("words.ply").writeText("no model at all\n")
        return folder
    }
}
