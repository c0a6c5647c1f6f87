package dev.lazyz.scenes.fuzz

import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.images.PngFile
import java.nio.file.Files
import java.nio.file.Path

/** The files beside an input, which it may refer to. */
internal object Companions {
    /** Name of the material library that is an input itself. */
    const val LIBRARY = "input.mtl"

    /** A model that uses the materials of [LIBRARY], with and without textures. */
    const val OBJ = "mtllib input.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\n" +
        "usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/2\nusemtl c d\nf 1 2 4\n"

    /** A grey picture of 2 x 2 texels. */
    val png: ByteArray = PngFile.of(2, 2, 8, PngFile.GREY, List(2) { PngFile.bytes(9, 200) })

    /** Three positions as floats, which glTF files refer to. */
    const val BUFFER = "triangle.bin"

    fun write(folder: Path) {
        Files.write(folder.resolve("t.png"), png)
        Files.writeString(folder.resolve("a.mtl"), "newmtl a\nKd 1 0.5 0\nmap_Kd t.png\n")
        Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        val corners = GltfFiles().encode(GltfFiles.FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        Files.write(folder.resolve(BUFFER), corners)
    }
}
