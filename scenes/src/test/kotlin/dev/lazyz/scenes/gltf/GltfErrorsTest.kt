package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.gltf.GltfFiles.Companion.UINT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.USHORT
import dev.lazyz.scenes.loading.TestSources
import java.nio.ByteBuffer
import java.nio.ByteOrder
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

private const val PRIMITIVE = "meshes[0].primitives[0]"

@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class GltfErrorsTest {
    private val mesh = """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}]"""

    private fun files(indices: List<Number> = listOf(0, 1, 2), type: Int = USHORT): GltfFiles {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        files.accessor("SCALAR", type, indices)
        return files
    }

    private fun assertFails(text: String, location: String?, vararg parts: String) =
        assertFails(text.toByteArray(), location, *parts)

    /** The good file with one thing changed in its JSON. */
    private fun changed(from: String, to: String): String {
        val json = files().json(mesh)
        check(from in json) { "$from is not in $json" }
        return json.replace(from, to)
    }

    private fun assertFails(bytes: ByteArray, location: String?, vararg parts: String) {
        val error = TestSources.error(GltfParser, TestSources.of(bytes))
        assertEquals(location, error.location, error.message)
        for (part in parts) assertTrue(part in error.message!!, "\"$part\" in: ${error.message}")
    }

    @Test
    fun textThatIsNoGltfIsRefused() {
        assertFails("[]", null, "no JSON object")
        val neither = arrayOf("neither JSON", "nor binary")
        for (start in listOf("glTX\u0002\u0000\u0000\u0000", "\u0000\u0000glTF", "solid x", "\uFEFF\n x{}")) {
            assertFails(start, "byte 0", *neither)
        }
        val damaged = files().glb(mesh).also { it[20] = 'x'.code.toByte() }
        assertFails(damaged, "line 1, column 1", "the JSON of the binary file is damaged")
        assertFails("{\n \"asset\": }", "line 2, column 11", "no JSON")
        assertFails("{\n \"asset\": ]", "line 2, column 11", "no JSON")
        assertFails("{]", "line 1, column 2", "expected '}'; correct it")
        assertFails("""{"asset":{"version":"0.8"}}""", "asset.version", "\"0.8\"", "export the model as glTF 2.0")
        assertFails("{}", "asset.version", "it is missing", "export the model as glTF 2.0")
        assertFails("""{"asset":{}}""", "asset.version", "it is missing")
        val start = "{\"asset\":{\"version\":\"2.0\"},\"extras\":" + "[".repeat(100_000)
        assertFails(start, null, "nested more than 64 deep", "--max-nesting")
        assertFails(start + "]".repeat(100_000) + "}", null, "nested more than 64 deep")
    }

    @Test
    fun valuesOfTheWrongKindNameTheirPlace() {
        assertFails(changed("\"POSITION\":0", "\"POSITION\":\"x\""), "$PRIMITIVE.attributes.POSITION")
        assertFails(changed("\"count\":3", "\"count\":\"many\""), "accessors[0].count")
        assertFails(changed("\"count\":3", "\"count\":99999999999"), "accessors[0].count")
        assertFails(changed("\"scene\":0", "\"scene\":{}"), "scene", "a whole number is expected, not an object")

        // The whole message, in which nothing of a library is left
        fun message(text: String) = TestSources.error(GltfParser, TestSources.of(text)).message
        fun node(more: String) = message(changed("\"mesh\":0", "\"mesh\":0,$more"))
        val start = "test, nodes[0]."
        val end = " is expected, not "
        val advice = "; correct it or export the model again"
        assertEquals("${start}scale[1]: a number${end}text$advice", node("\"scale\":[1,\"2\",1]"))
        assertEquals("${start}name: text${end}a list$advice", node("\"name\":[]"))
        assertEquals("${start}children[0]: a whole number${end}an object$advice", node("\"children\":{}"))
        assertEquals("${start}extensions: an object${end}a list$advice", node("\"extensions\":[]"))
        assertEquals("${start}extensions: an object${end}7$advice", node("\"extensions\":7"))
    }

    @Test
    fun valuesThatAreOnlyNotAllowedArePassedOver() {
        val materials = """"materials":[{"alphaMode":"odd"},{"alphaMode":"even"},{"alphaMode":"odd"}]"""
        val source = TestSources.of(files().json("$mesh,$materials"))
        assertEquals(1, GltfParser.parse(source).surfaces.size)
        val expected = "test: materials.alphaMode is passed over: 3 " +
            "(Invalid value for alphaMode: odd, valid: [OPAQUE, MASK, BLEND])"
        assertEquals(listOf(expected), source.warnings)
        assertFails(changed("\"count\":3", "\"count\":0"), "accessors[0].count", "missing or not allowed")
    }

    @Test
    fun referencesToNothingNameTheirPlace() {
        assertFails(changed("\"POSITION\":0", "\"POSITION\":7"), "$PRIMITIVE.attributes.POSITION", "accessors[7]")
        assertFails(changed("\"indices\":1", "\"indices\":7"), "$PRIMITIVE.indices", "accessors[7]")
        assertFails(changed("\"mesh\":0", "\"mesh\":7"), "nodes[0].mesh", "meshes[7]")
        assertFails(changed("\"nodes\":[0]", "\"nodes\":[7]"), "scenes[0].nodes[0]", "nodes[7]")
        assertFails(changed("\"scene\":0", "\"scene\":7"), "scene", "scenes[7]")
        assertFails(changed("\"mesh\":0", "\"children\":[7]"), "nodes[0].children[0]", "nodes[7]")
        assertFails(changed("\"indices\":1", "\"material\":7"), "$PRIMITIVE.material", "materials[7]")
        assertFails(changed("\"bufferView\":0", "\"bufferView\":7"), "accessors[0]", "bufferViews[7]")
        assertFails(changed("\"buffer\":0", "\"buffer\":7"), "bufferViews[0].buffer", "buffers[7]")
        assertFails(changed("[{\"mesh\":0}]", "[null]"), "nodes[0]", "null")
    }

    @Test
    fun vertexNumbersOutOfRangeNameTheElement() {
        assertFails(files(listOf(0, 1, 3)).json(mesh), "$PRIMITIVE.indices", "element 2 is 3", "3 vertices")
        val beyond = files(listOf(0, 4294967295L, 2), UINT)
        assertFails(beyond.json(mesh), "$PRIMITIVE.indices", "element 1 is beyond 31 bits")
        assertFails(changed("\"indices\":1", "\"indices\":0"), "accessors[0].type", "SCALAR")
    }

    @Test
    fun accessorsStayWithinTheirBytes() {
        assertFails(changed("\"count\":3", "\"count\":4"), "accessors[0]", "byte 48", "36 bytes")
        assertFails(changed("\"count\":3", "\"count\":2000000000"), "accessors[0]", "36 bytes")
        assertFails(changed("\"byteLength\":36", "\"byteLength\":360"), "bufferViews[0]", "until 360")
        assertFails(changed("\"byteLength\":42,", "\"byteLength\":43,"), "buffers[0].byteLength", "43", "42")
        assertFails(changed("base64,", "base64,*"), "buffers[0].uri", "Base64")
        val zeros = changed("\"bufferView\":0,\"componentType\"", "\"componentType\"")
        assertFails(zeros.replace("\"count\":3", "\"count\":2000000000"), "accessors[0].count", "2000000000")
    }

    @Test
    fun sparseIndicesStayWithinTheirAccessor() {
        val files = GltfFiles()
        val places = files.view(files.encode(USHORT, listOf(3)))
        val values = files.view(files.encode(FLOAT, listOf(1, 2, 3)))
        files.accessor(
            """{"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,
            "indices":{"bufferView":$places,"componentType":5123},"values":{"bufferView":$values}}}""",
        )
        val json = files.json(mesh.replace(",\"indices\":1", ""))
        assertFails(json, "accessors[0].sparse.indices", "element 0 is 3", "3 elements")
    }

    @Test
    fun nodesThatAreNoTreeAreRefused() {
        val nodes = """"nodes":"""
        val circle = files().json("""$nodes[{"children":[1]},{"children":[2]},{"children":[1]}]""")
        assertFails(circle, "nodes[2].children[0]", "node 1")
        assertFails(files().json("""$nodes[{"children":[1,1]},{}]"""), "nodes[0].children[1]", "two parents")

        // Every node twice below the one before: without a check this is walked 2 to the power of 60 times
        val doubling = (0 until 60).joinToString(",") { """{"children":[${it + 1},${it + 1}]}""" }
        val source = TestSources.of(files().json("$nodes[$doubling,{}]"))
        TestSources.error(GltfParser, source)
    }

    @Test
    fun binaryErrorsNameTheirByte() {
        val glb = files().glb(mesh)

        fun changed(at: Int, value: Int): ByteArray {
            val bytes = glb.copyOf()
            ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(at, value)
            return bytes
        }
        assertFails(glb.copyOf(8), "byte 8", "within its header")
        assertFails(glb.copyOf(glb.size - 1), "byte ${glb.size - 1}", "${glb.size} bytes")
        assertFails(changed(4, 3), "byte 4", "version is 3")
        assertFails(changed(12, -8), "byte 12", "4294967288 bytes")
        assertFails(changed(16, 7), "byte 12", "not JSON")
        assertFails(changed(glb.size - 52, 1 shl 30), "byte ${glb.size - 52}", "1073741824 bytes")
        assertFails(changed(glb.size - 48, 7), "buffers[0].uri", "no binary chunk")
    }

    @Test
    fun numbersOfElementsAreWholeNumbers() {
        for (wrong in listOf("0.5", "\"0\"", "\"\"", "true", "1e30")) {
            val text = changed("\"mesh\":0", "\"mesh\":$wrong")
            assertFails(text, "nodes[0].mesh", "a whole number is expected, not ")
        }
        val matrix = changed("\"mesh\":0", "\"mesh\":0,\"matrix\":\"1\"")
        assertFails(matrix, "nodes[0].matrix", "a list is expected, not text")
        val nodes = changed("\"nodes\":[0]", "\"nodes\":[0.5]")
        assertFails(nodes, "scenes[0].nodes[0]", "a whole number is expected, not 0.5")
        assertFails(changed("\"POSITION\":0", "\"POSITION\":0.5"), "$PRIMITIVE.attributes.POSITION")
        val whole = changed("\"mesh\":0", "\"mesh\":0.0").toByteArray()
        assertEquals(1, GltfParser.parse(TestSources.of(whole)).surfaces.size)
    }

    @Test
    fun textAfterTheJsonIsRefused() {
        val json = files().json(mesh)
        for (more in listOf("x", "{}", " }", "\n1")) {
            val error = TestSources.error(GltfParser, TestSources.of((json + more).toByteArray()))
            assertTrue("there is more text after the JSON object" in error.message!!, error.message)
            assertTrue(error.location!!.startsWith("line "), error.message)
        }
        for (padding in listOf(" \r\n\t", "\u0000\u0000")) {
            assertEquals(1, GltfParser.parse(TestSources.of("$json$padding".toByteArray())).surfaces.size)
        }
    }
}
