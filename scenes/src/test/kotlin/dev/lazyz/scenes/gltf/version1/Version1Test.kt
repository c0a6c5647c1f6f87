package dev.lazyz.scenes.gltf.version1

import dev.lazyz.Rgba
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Sides
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Base64
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** glTF 1.0, where objects are called by names. */
class Version1Test {
    private val png = PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9)))

    /** Positions, one of four numbers each; texture coordinates between them; vertex numbers; a picture. */
    private val data = GltfFiles().run {
        encode(FLOAT, listOf(0, 0, 0, 0.25, 1, 0, 0, 0.5, 0, 1, 0, 0.75)) + encode(USHORT, listOf(0, 1, 2, 0)) + png
    }

    private val technique = """{"parameters":{"diffuse":{"type":35666,"value":[1,0,0,1]}},
        "states":{"enable":[2929]}}"""

    private fun json(
        material: String = """{"name":"red","technique":"t","values":{"diffuse":[0.5,0,1,0.25]}}""",
        uri: String = "data:;base64,${Base64.getEncoder().encodeToString(data)}",
        buffer: String = "b",
        image: String = """{"uri":"data:image/png;base64,${Base64.getEncoder().encodeToString(png)}"}""",
        asset: String = """"asset":{"version":"1.0"},""",
    ) = """{$asset"scene":"s","scenes":{"s":{"nodes":["root"]}},
        "nodes":{"leaf":{"meshes":["m","m"],"translation":[0,0,1]},"root":{"children":["leaf"],"translation":[10,0,0]}},
        "meshes":{"m":{"primitives":[{"attributes":{"POSITION":"p","TEXCOORD_0":"u"},"indices":"i","material":"x"}]}},
        "materials":{"x":$material},"techniques":{"t":$technique},"textures":{"tex":{"source":"img","sampler":"sam"}},
        "samplers":{"sam":{"magFilter":9728}},"images":{"img":$image},
        "accessors":{"p":{"bufferView":"v","byteOffset":0,"byteStride":16,"componentType":5126,"count":3,"type":"VEC3"},
            "u":{"bufferView":"v","byteOffset":4,"byteStride":16,"componentType":5126,"count":3,"type":"VEC2"},
            "i":{"bufferView":"w","byteOffset":0,"byteStride":0,"componentType":5123,"count":3,"type":"SCALAR"}},
        "bufferViews":{"w":{"buffer":"$buffer","byteOffset":48,"byteLength":8},"v":{"buffer":"$buffer","byteLength":48},
            "pic":{"buffer":"$buffer","byteOffset":56,"byteLength":${png.size}}},
        "buffers":{"$buffer":{"byteLength":${data.size},"uri":"$uri"}}}"""

    private fun glb(text: String): ByteArray {
        val bytes = text.toByteArray().let { it.copyOf((it.size + 3) / 4 * 4).also { all -> all.fill(32, it.size) } }
        val out = ByteBuffer.allocate(20 + bytes.size + data.size).order(ByteOrder.LITTLE_ENDIAN)
        out.putInt(0x46546C67).putInt(1).putInt(out.capacity()).putInt(bytes.size).putInt(0).put(bytes).put(data)
        return out.array()
    }

    @Test
    fun theWholeModelIsRelativeToItsCenter() {
        val moved = json().replaceFirst("{", """{"extensions":{"CESIUM_RTC":{"center":[0,100,0]}},""")
        val bounds = checkNotNull(GltfParser.parse(TestSources.of(moved)).meshes[0].bounds)
        assertEquals(listOf(10.0, 100.0, 1.0), listOf(bounds.minX, bounds.minY, bounds.minZ))
        assertEquals(listOf(11.0, 101.0, 1.0), listOf(bounds.maxX, bounds.maxY, bounds.maxZ))
    }

    private val expected = listOf(10f, 0f, 1f, 11f, 0f, 1f, 10f, 1f, 1f)

    @Test
    fun meshesNodesAndColoursAreRead() {
        val source = TestSources.of(json())
        val meshes = GltfParser.parse(source).meshes
        assertEquals(listOf(expected, expected), meshes.map { it.corners().flatten() })
        val material = meshes[0].material
        assertEquals("red", material.name)
        assertEquals(0.2140411f, material.baseColor.red, 1e-6f)
        assertEquals(listOf(0f, 1f, 0.25f), material.baseColor.let { listOf(it.green, it.blue, it.alpha) })
        assertEquals(Sides.BOTH to AlphaMode.OPAQUE, material.sides to material.alphaMode)
        val warning = source.warnings.single()
        assertTrue("glTF 1.0" in warning && "convert it to glTF 2.0" in warning, warning)
    }

    @Test
    fun versionMayBeMissingOrANumber() {
        for (asset in listOf("", """"asset":{"version":1},""", """"asset":{"version":"1.0.1"},""")) {
            assertEquals(2, GltfParser.parse(TestSources.of(json(asset = asset))).meshes.size, asset)
        }
    }

    @Test
    fun texturesAndStatesOfMaterials() {
        fun material(json: String) = GltfParser.parse(TestSources.of(json(json))).meshes[0].material
        assertEquals(1, material("""{"values":{"diffuse":"tex"}}""").texture?.width)
        assertEquals(Rgba(1f, 0f, 0f), material("""{"technique":"t"}""").baseColor)
        assertEquals(Rgba.WHITE, material("{}").baseColor)
        val common = """"values":{"diffuse":[0,1,0,0.5]},"transparent":true"""
        val green = material("""{"extensions":{"KHR_materials_common":{$common}}}""")
        assertEquals(Rgba(0f, 1f, 0f, 0.5f), green.baseColor)
        assertEquals(Sides.FRONT to AlphaMode.BLEND, green.sides to green.alphaMode)
    }

    @Test
    fun coloursThatNoShaderReadsAreNotShown() {
        fun colors(parameters: String): FloatArray? {
            val text = json().replace("\"parameters\":{", "\"parameters\":{$parameters")
                .replace("\"TEXCOORD_0\":\"u\"", "\"COLOR\":\"p\"")
            return GltfParser.parse(TestSources.of(text)).meshes[0].colors
        }
        val position = """"position":{"semantic":"POSITION"},"""
        assertNotNull(colors(""))
        assertNotNull(colors("""$position"tint":{"semantic":"COLOR_0"},"""))
        assertNull(colors(position))
    }

    @Test
    fun binaryFilesHoldBuffersAndPictures() {
        val image = """{"uri":"data:,","extensions":{"KHR_binary_glTF":{"bufferView":"pic","mimeType":"image/png"}}}"""
        val text = json("""{"values":{"diffuse":"tex"}}""", "elsewhere.bin", "binary_glTF", image)
        val mesh = GltfParser.parse(TestSources.of(glb(text))).meshes[0]
        assertEquals(expected, mesh.corners().flatten())
        assertEquals(1, mesh.material.texture?.width)
        assertEquals(listOf(0f, 0f, 0f, 0f, 1f, 0f), mesh.uvs!!.toList())
    }

    @Test
    fun namesThatNobodyHasAreErrors() {
        fun fails(from: String, to: String, location: String, part: String) {
            val error = TestSources.error(GltfParser, TestSources.of(json().replace(from, to)))
            assertEquals(location, error.location, error.message)
            assertTrue(part in error.message!!, error.message)
        }
        fails("\"indices\":\"i\"", "\"indices\":\"j\"", "meshes.m.primitives[0].indices", "accessors.j does not exist")
        fails("[\"leaf\"]", "[\"leaf\",7]", "nodes.root.children[1]", "nodes.7 does not exist")
        fails("\"scene\":\"s\"", "\"scene\":\"none\"", "scene", "scenes.none does not exist")
        fails("\"sam\":{\"magFilter\":9728}", "\"sam\":[]", "samplers.sam", "no JSON object")
    }

    @Test
    fun damageIsReportedAndNothingElse() {
        val text = json("""{"values":{"diffuse":"tex"}}""", "data:,", "binary_glTF")
        val good = glb(text)
        val error = TestSources.error(GltfParser, TestSources.of(good.copyOf().also { it[15] = 1 }))
        assertEquals("byte 12", error.location, error.message)
        for (at in good.indices step 3) {
            val bad = good.copyOf().also { it[at] = (it[at].toInt() xor 1).toByte() }
            try {
                GltfParser.parse(TestSources.of(bad))
            } catch (_: SceneFormatException) {
                // The one exception that is allowed
            }
        }
    }
}
