package dev.lazyz.scenes

import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.images.PngFile
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Files of some megabytes, read in virtual machines whose heaps are measured by the files' sizes. */
class LoadingMemoryTest {
    @TempDir
    lateinit var folder: Path

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun closedMeshesFitIntoTheMemoryThatIsPromised() {
        val ply = Files.write(folder.resolve("a.ply"), grid(PLY_SIDE))
        assertEquals("loaded", LoadInChild.run(ply, Files.size(ply) * 11 / 2))
        val stl = Files.write(
            folder.resolve("a.stl"),
            stl(STL_FACETS) { facet, corner ->
                (facet + corner) / 2 %
                    STL_FACETS
            }
        )
        assertEquals("loaded", LoadInChild.run(stl, Files.size(stl) * 7 / 2))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whatDoesNotFitIsRefusedAndDoesNotExhaustTheMemory() {
        // No corner is shared, so that each facet has three vertices
        val random = Random(1)
        val path = Files.write(folder.resolve("a.stl"), stl(STL_FACETS) { _, _ -> random.nextInt() })
        val results = listOf(20, 32, 40, 48, 56, 90).map { LoadInChild.run(path, Files.size(path) * it / 10) }
        assertTrue(results.all { it == "loaded" || "raise -Xmx" in it }, "$results")
        assertEquals(listOf(false, true), listOf(results.first(), results.last()).map { it == "loaded" })
    }

    /** The memory for decoding is that of one texture. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun severalLargeTexturesFitOrAreRefused() {
        val side = 1024
        val names = List(5) { "$it.png" }
        for (name in names) {
            val rows = List(side) { ByteArray(3 * side) }
            Files.write(folder.resolve(name), PngFile.of(side, side, 8, PngFile.RGB, rows))
        }
        val materials = names.joinToString("\n") { "newmtl $it\nmap_Kd $it" }
        Files.writeString(folder.resolve("a.mtl"), materials)
        val faces = names.joinToString("\n") { "usemtl $it\nf 1/1 2/1 3/1" }
        val path = folder.resolve("a.obj")
        Files.writeString(path, "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n$faces\n")
        assertEquals("loaded", LoadInChild.run(path, 96L shl 20, decodedBytes = null))
        val refused = LoadInChild.run(path, 64L shl 20, decodedBytes = null)
        assertTrue("bytes of decoded data" in refused && "-Xmx" in refused, refused)
    }

    /** A mesh of triangles whose corners are where their [number]s say, in the plane of x and y. */
    private fun stl(facets: Int, number: (Int, Int) -> Int): ByteArray {
        val bytes = ByteBuffer.allocate(84 + 50 * facets).order(ByteOrder.LITTLE_ENDIAN)
        bytes.position(80).putInt(facets)
        for (facet in 0 until facets) {
            repeat(3) { bytes.putFloat(0f) }
            for (corner in 0 until 3) {
                val place = number(facet, corner)
                bytes.putFloat((place and 0xFFFF).toFloat()).putFloat((place ushr 16).toFloat()).putFloat(0f)
            }
            bytes.putShort(0)
        }
        return bytes.array()
    }

    private fun grid(side: Int): ByteArray {
        val header = "ply\nformat binary_little_endian 1.0\nelement vertex ${(side + 1) * (side + 1)}\n" +
            "property float x\nproperty float y\nproperty float z\nelement face ${2 * side * side}\n" +
            "property list uchar int vertex_indices\nend_header\n"
        val bytes = ByteBuffer.allocate(header.length + 12 * (side + 1) * (side + 1) + 26 * side * side)
            .order(ByteOrder.LITTLE_ENDIAN).put(header.toByteArray())
        for (y in 0..side) {
            for (x in 0..side) {
                bytes.putFloat(x.toFloat()).putFloat(y.toFloat()).putFloat(0.01f * x * y / side)
            }
        }
        for (y in 0 until side) {
            for (x in 0 until side) {
                val at = y * (side + 1) + x
                bytes.put(3).putInt(at).putInt(at + 1).putInt(at + side + 2)
                bytes.put(3).putInt(at).putInt(at + side + 2).putInt(at + side + 1)
            }
        }
        return bytes.array()
    }

    private companion object {
        const val PLY_SIDE = 600
        const val STL_FACETS = 300_000
    }
}

/** Reads a file in a Java of its own. */
internal object LoadInChild {
    @JvmStatic
    fun main(args: Array<String>) {
        try {
            Scenes.load(Path.of(args[0]), LoadLimits(decodedBytes = args[1].toLongOrNull()))
            println("loaded")
        } catch (e: SceneFormatException) {
            println(e.message)
        }
    }

    /** Returns what [main] says in a heap of so many [bytes], with a limit for decoded data. */
    fun run(path: Path, bytes: Long, decodedBytes: Long? = Long.MAX_VALUE): String {
        val flags = listOf("-Xmx${bytes shr 10}k", "-XX:+UseG1GC")
        return ChildJava.run(LoadInChild::class.java, flags, "$path", "$decodedBytes")
    }
}
