package dev.lazyz.scenes.gltf.meshopt

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import java.util.Base64
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** glTF files with compressed buffer views. */
class GltfCompressedViewsTest {
    private val data = MeshoptFixtures.exponents
    private val compressed = """"buffer":0,"byteLength":${data.size},"byteStride":8,"count":16,"mode":"ATTRIBUTES""""
    private val filter = ""","filter":"EXPONENTIAL""""

    /** Twice the same sixteen pairs of numbers as texture coordinates, in the buffer that is not there. */
    private fun file(extension: String, values: String = compressed + filter, length: Int = 128): String = """{
        "asset":{"version":"2.0"},"extensionsRequired":["$extension","KHR_mesh_quantization"],
        "nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1}}]}],
        "buffers":[{"byteLength":${data.size},"uri":"data:;base64,${Base64.getEncoder().encodeToString(data)}"},
            {"byteLength":$length,"extensions":{"$extension":{"fallback":true}}}],
        "bufferViews":[{"buffer":1,"byteLength":$length,"byteStride":8,"extensions":{"$extension":{$values}}}],
        "accessors":[{"componentType":5126,"count":15,"type":"VEC3"},
            {"bufferView":0,"componentType":5126,"count":15,"type":"VEC2"}]}"""

    @Test
    fun bothExtensionsAreDecodedWithoutTheirFallback() {
        for (extension in listOf("EXT_meshopt_compression", "KHR_meshopt_compression")) {
            val source = TestSources.of(file(extension))
            val uvs = GltfParser.parse(source).meshes.single().uvs!!
            assertEquals(listOf(-10f, 3f / 256, -8.75f, 3f / 128), uvs.take(4))
            assertEquals(emptyList<String>(), source.warnings)
        }
    }

    @Test
    fun errorsNameTheViewAndWhatIsWrong() {
        val name = "EXT_meshopt_compression"
        val place = "bufferViews[0].extensions.$name"

        fun fails(text: String, location: String, part: String) {
            val error = TestSources.error(GltfParser, TestSources.of(text))
            assertEquals(location, error.location, error.message)
            assertTrue(part in error.message!!, error.message)
        }
        fails(file(name, compressed.replace("ATTRIBUTES", "MAGIC")), place, "mode is MAGIC")
        fails(file(name, compressed.replace("\"count\":16", "\"count\":17")), "bufferViews[0].byteLength", "136 bytes")
        fails(file(name, compressed.replace("\"count\":16,", "")), "$place.count", "it is missing")
        fails(file(name, compressed.replace("\"count\":16", "\"count\":1e9")), "$place.count", "no whole number")
        fails(file(name, compressed.replace("\"buffer\":0", "\"buffer\":7")), "$place.buffer", "buffers[7]")
        fails(file(name, compressed.replace("\"buffer\":0", "\"buffer\":1")), "buffers[1].uri", "it is missing")
        fails(file(name, compressed.replace("\"byteLength\":${data.size}", "\"byteLength\":40")), place, "compressed")
    }

    @Test
    fun sizesAreLimitedBeforeTheyAreAllocated() {
        val count = 250_000_000
        val text = file("EXT_meshopt_compression", compressed.replace("16,\"mode", "$count,\"mode"), 8 * count)
        val loading = Loading(LoadOptions(LoadLimits(decodedBytes = 1000)))
        val source = Source(text.toByteArray(), "test", null, loading)
        assertTrue("--max-decoded" in TestSources.error(GltfParser, source).message!!)
    }
}
