package dev.lazyz.scenes

import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.surface.Mesh
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.time.Duration
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTimeoutPreemptively
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/** Files made to take long are read in time: what was quadratic would take minutes. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class LinearTimeTest {
    private fun meshes(bytes: ByteArray, format: SceneFormat): List<Mesh> =
        assertTimeoutPreemptively<List<Mesh>>(Duration.ofSeconds(10)) {
            Scenes.load(bytes.inputStream(), format).scene.surfaces.map { it as Mesh }
        }

    private fun obj(text: String): List<Mesh> = meshes(text.toByteArray(), SceneFormat.OBJ)

    @Test
    fun faceOfManyCornersOnOneLineOrOnMany() {
        // A square with corners all along its sides
        val side = 50_000
        val text = buildString {
            for (i in 0 until side) append("v $i 0 0\n")
            for (i in 0 until side) append("v $side $i 0\n")
            for (i in side downTo 1) append("v $i $side 0\n")
            for (i in side downTo 1) append("v 0 $i 0\n")
        }
        for (separator in listOf(" ", " \\\n")) {
            val face = (1..4 * side).joinToString(separator, "f ", "\n")
            assertEquals(4 * side - 2, obj(text + face).sumOf { it.triangleCount })
        }
    }

    @Test
    fun positionWithManyTextureCoordinates() {
        val count = 300_000
        val text = buildString {
            append("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
            repeat(count) { append("vt ").append(it).append(" 0\n") }
            for (i in 1..count) append("f 1/$i 2/$i 3/$i\n")
        }
        assertEquals(3 * count, obj(text).sumOf { it.vertexCount })
    }

    @Test
    fun manyObjectsAndMaterials() {
        val count = 50_000
        val text = buildString {
            append("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
            for (i in 0 until count) append("o a\nusemtl m$i\nf 1 2 3\n")
        }
        assertEquals(count, obj(text).size)
    }

    @Test
    fun positionsWithCollidingHashCodes() {
        // Where a hash code is 31 * (31 * x + y) + z, these have one: by the bits of floats between 1 and 2
        val facets = 30_000
        val buffer = ByteBuffer.allocate(84 + 50 * facets).order(ByteOrder.LITTLE_ENDIAN)
        buffer.position(80).putInt(facets)
        val one = 1f.toBits()
        for (i in 0 until facets) {
            buffer.putFloat(0f).putFloat(0f).putFloat(0f)
            for (corner in 0 until 3) {
                val k = 3 * i + corner
                buffer.putInt(one + k).putInt(one + 31 * (100_000 - k)).putInt(one)
            }
            buffer.putShort(0)
        }
        assertEquals(3 * facets, meshes(buffer.array(), SceneFormat.STL).single().vertexCount)
        val path = TestSources.casePath("hang/collide30000.stl")
        meshes(Files.readAllBytes(path), SceneFormat.STL)
    }
}
