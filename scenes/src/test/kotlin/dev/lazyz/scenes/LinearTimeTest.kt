package dev.lazyz.scenes

import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.shared.ProcessorTime
import dev.lazyz.world.surface.Mesh
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/** Files made to take long are read in linear time. */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class LinearTimeTest {
    private fun meshes(bytes: ByteArray, format: SceneFormat): List<Mesh> =
        Scenes.load(bytes.inputStream(), format).scene.surfaces.map { it as Mesh }

    private fun obj(text: String): List<Mesh> = meshes(text.toByteArray(), SceneFormat.OBJ)

    @ParameterizedTest
    @ValueSource(strings = [" ", " \\\n"])
    fun faceOfManyCornersOnOneLineOrOnMany(separator: String) {
        // A square with corners all along its sides
        val text = { side: Int ->
            buildString {
                for (i in 0 until side) append("v $i 0 0\n")
                for (i in 0 until side) append("v $side $i 0\n")
                for (i in side downTo 1) append("v $i $side 0\n")
                for (i in side downTo 1) append("v 0 $i 0\n")
                append((1..4 * side).joinToString(separator, "f ", "\n"))
            }
        }
        ProcessorTime.assertLinear(48_000, text) { file, side ->
            assertEquals(4 * side - 2, obj(file).sumOf { it.triangleCount })
        }
    }

    @Test
    fun positionWithManyTextureCoordinates() {
        val text = { count: Int ->
            buildString {
                append("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
                repeat(count) { append("vt ").append(it).append(" 0\n") }
                for (i in 1..count) append("f 1/$i 2/$i 3/$i\n")
            }
        }
        ProcessorTime.assertLinear(160_000, text) { file, count ->
            assertEquals(3 * count, obj(file).sumOf { it.vertexCount })
        }
    }

    @Test
    fun manyObjectsAndMaterials() {
        val text = { count: Int ->
            buildString {
                append("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
                for (i in 0 until count) append("o a\nusemtl m$i\nf 1 2 3\n")
            }
        }
        ProcessorTime.assertLinear(48_000, text) { file, count -> assertEquals(count, obj(file).size) }
    }

    /** The last of many variants is asked for, whose names are equal at the beginning, for each of many primitives. */
    @Test
    fun manyVariantsForManyPrimitives() {
        fun name(number: Int) = "v".repeat(200) + (1_000_000 + number)
        val zeros = Base64.getEncoder().encodeToString(ByteArray(36))
        val text = { count: Int ->
            val names = (0 until count).joinToString(",") { """{"name":"${name(it)}"}""" }
            val primitives = List(count) { """{"attributes":{"POSITION":0}}""" }.joinToString(",")
            """{"asset":{"version":"2.0"},"nodes":[{"mesh":0}],"meshes":[{"primitives":[$primitives]}],
                "extensions":{"KHR_materials_variants":{"variants":[$names]}},
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
                "bufferViews":[{"buffer":0,"byteLength":36}],
                "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,$zeros"}]}"""
        }
        ProcessorTime.assertLinear(16_000, text) { file, count ->
            val options = LoadOptions().withVariant(name(count - 1))
            val loaded = Scenes.load(file.byteInputStream(), SceneFormat.GLTF, "test", null, options)
            assertEquals(count, loaded.scene.surfaces.size)
        }
    }

    @Test
    fun positionsWithCollidingHashCodes() {
        ProcessorTime.assertLinear(32_000, ::collidingFacets) { file, facets ->
            assertEquals(3 * facets, meshes(file, SceneFormat.STL).single().vertexCount)
        }
    }

    /** Where a hash code is 31 * (31 * x + y) + z, these have one: by the bits of floats between 1 and 2. */
    private fun collidingFacets(facets: Int): ByteArray {
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
        return buffer.array()
    }
}
