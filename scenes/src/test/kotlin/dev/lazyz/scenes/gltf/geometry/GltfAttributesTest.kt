package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UBYTE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.surface.Mesh
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class GltfAttributesTest {
    private val triangle = listOf(0, 0, 0, 1, 0, 0, 0, 1, 0)

    private fun mesh(files: GltfFiles, attributes: String, more: String = ""): Mesh {
        val material = if ("material" in more) ",\"material\":0" else ""
        val json = files.json("""$ONE_NODE,"meshes":[{"primitives":[{"attributes":{$attributes}$material}]}]$more""")
        return GltfParser.parse(TestSources.of(json)).meshes.single()
    }

    @Test
    fun coloursAreLinearAndOfAnyType() {
        val expected = listOf(1f, 0f, 0.2f, 1f)
        val types = mapOf(FLOAT to listOf(1, 0, 0.2f), UBYTE to listOf(255, 0, 51), USHORT to listOf(65535, 0, 13107))
        for ((type, colour) in types) {
            for (hasAlpha in listOf(false, true)) {
                val files = GltfFiles()
                files.accessor("VEC3", FLOAT, triangle)
                val row = if (hasAlpha) colour + colour[0] else colour
                files.accessor(if (hasAlpha) "VEC4" else "VEC3", type, row + row + row, ",\"normalized\":true")
                val colors = mesh(files, "\"POSITION\":0,\"COLOR_0\":1").colors!!.toList()
                for (i in 0 until 12) assertEquals(expected[i % 4], colors[i], 1e-6f, "type $type, $hasAlpha")
            }
        }
    }

    @Test
    fun coloursOfIntegersAreFractionsEvenIfTheFileForgetsToSaySo() {
        for ((type, colour) in mapOf(UBYTE to listOf(255, 0, 51, 255), USHORT to listOf(65535, 0, 13107, 65535))) {
            for (width in 3..4) {
                val files = GltfFiles()
                files.accessor("VEC3", FLOAT, triangle)
                files.accessor("VEC$width", type, List(3 * width) { colour[it % width] })
                val part = """{"attributes":{"POSITION":0,"COLOR_0":1}}"""
                val source = TestSources.of(files.json("""$ONE_NODE,"meshes":[{"primitives":[$part,$part]}]"""))
                val colors = GltfParser.parse(source).meshes[1].colors!!.toList()
                assertEquals(List(12) { listOf(1f, 0f, 0.2f, 1f)[it % 4] }, colors, "type $type, $width")
                val warning = "colours of integers that are not marked as normalized are read as if they were: 2"
                assertEquals(listOf("test: $warning"), source.warnings)
            }
        }
    }

    @Test
    fun aWrongNumberOfColoursIsSaidAsItIs() {
        for ((type, count) in listOf("VEC3" to 2, "VEC3" to 4, "VEC4" to 2, "VEC4" to 9)) {
            val files = GltfFiles()
            files.accessor("VEC3", FLOAT, triangle + triangle + triangle + triangle)
            files.accessor(type, FLOAT, List(count * type.last().digitToInt()) { 0 })
            val json = files.json("""$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"COLOR_0":1}}]}]""")
            val error = TestSources.error(GltfParser, TestSources.of(json))
            assertEquals("there are $count elements for 12 positions", error.problem, type)
            assertEquals("meshes[0].primitives[0].attributes.COLOR_0", error.location)
        }
    }

    @Test
    fun interleavedRowsAreTakenApart() {
        val files = GltfFiles()
        val rows = (0 until 3).flatMap { triangle.slice(3 * it until 3 * it + 3) + listOf(10 + it, 20 + it) }
        val view = files.view(files.encode(FLOAT, rows), ",\"byteStride\":20")
        files.accessor("""{"bufferView":$view,"componentType":$FLOAT,"count":3,"type":"VEC3"}""")
        files.accessor("""{"bufferView":$view,"byteOffset":12,"componentType":$FLOAT,"count":3,"type":"VEC2"}""")
        val mesh = mesh(files, "\"POSITION\":0,\"TEXCOORD_0\":1")
        assertEquals(triangle.map { it.toFloat() }, mesh.positions.toList())
        assertEquals(listOf(10f, 20f, 11f, 21f, 12f, 22f), mesh.uvs!!.toList())
    }

    @Test
    fun sparseValuesReplaceSomeOfTheBase() {
        for (base in listOf("offset", "zeros")) {
            val files = GltfFiles()
            val numbers = files.view(files.encode(FLOAT, listOf(99, 99, 99) + List(9) { it + 1 }))
            val places = files.view(files.encode(USHORT, listOf(0, 2)))
            val values = files.view(files.encode(FLOAT, listOf(-1, -2, -3, -4, -5, -6)))
            val dense = if (base == "offset") "\"bufferView\":$numbers,\"byteOffset\":12," else ""
            files.accessor(
                """{$dense"componentType":$FLOAT,"count":3,"type":"VEC3","sparse":{"count":2,
                "indices":{"bufferView":$places,"componentType":$USHORT},"values":{"bufferView":$values}}}""",
            )
            val middle = if (base == "offset") listOf(4f, 5f, 6f) else listOf(0f, 0f, 0f)
            val expected = listOf(-1f, -2f, -3f) + middle + listOf(-4f, -5f, -6f)
            assertEquals(expected, mesh(files, "\"POSITION\":0").positions.toList(), base)
        }
    }

    @Test
    fun textureDecidesWhichCoordinatesAreUsed() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, triangle)
        files.accessor("VEC2", FLOAT, listOf(0, 0, 1, 0, 0, 1))
        files.accessor("VEC2", UBYTE, listOf(255, 51, 0, 0, 0, 0), ",\"normalized\":true")
        val attributes = "\"POSITION\":0,\"TEXCOORD_0\":1,\"TEXCOORD_1\":2"
        assertEquals(listOf(0f, 0f, 1f), mesh(files, attributes).uvs!!.take(3))
        val pbr = """{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}}"""
        val second = ""","textures":[{}],"materials":[$pbr]"""
        assertEquals(listOf(1f, 0.2f, 0f), mesh(files, attributes, second).uvs!!.take(3))
    }
}
