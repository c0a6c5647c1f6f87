package dev.lazyz.scenes.gltf

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import java.util.Base64
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What is passed over is reported once for each kind, with its number. */
class GltfOmissionsTest {
    private fun warnings(more: String, attributes: String = ""): List<String> {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        files.accessor("VEC2", FLOAT, List(6) { 0 })
        files.view(PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9))))
        val part = """{"attributes":{"POSITION":0,"TEXCOORD_0":1$attributes},"material":0}"""
        val second = """{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":1}"""
        val source = TestSources.of(files.json("""$ONE_NODE,"meshes":[{"primitives":[$part,$second]}]$more"""))
        GltfParser.parse(source)
        return source.warnings.map { it.removePrefix("test: ") }
    }

    @Test
    fun unknownExtensionsAreListed() {
        val names = """"KHR_lights_punctual","KHR_materials_dispersion","KHR_materials_unlit","ACME_a""""
        val used = """"extensionsUsed":[$names]"""
        val lights = """"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"},{"type":"spot"}]}}"""
        val expected = "extensions that are not known are passed over, 2 in all: KHR_materials_dispersion, ACME_a"
        assertEquals(listOf(expected), warnings(""","materials":[{},{}],$used,$lights"""))
    }

    @Test
    fun animationsOfOtherPropertiesAreRefusedIfRequired() {
        val name = "KHR_animation_pointer"
        val passedOver = "extensions that are not known are passed over, 1 in all: $name"
        assertEquals(listOf(passedOver), warnings(""","materials":[{},{}],"extensionsUsed":["$name"]"""))
        val error = assertThrows(SceneFormatException::class.java) {
            warnings(""","materials":[{},{}],"extensionsRequired":["$name"]""")
        }
        assertTrue("requires the extension $name" in checkNotNull(error.message), error.message)
    }

    @Test
    fun furtherSetsAreCounted() {
        val sets = ""","TEXCOORD_1":1,"TEXCOORD_2":1,"COLOR_1":1"""
        val expected = listOf(
            "further sets of texture coordinates are passed over: 2",
            "further sets of colours are passed over: 1",
        )
        assertEquals(expected, warnings(""","materials":[{},{}]""", sets))
        val second = """{"pbrMetallicRoughness":{"baseColorTexture":{"index":0,"texCoord":1}}}"""
        val textures = ""","textures":[{"source":0}],"images":[{"bufferView":2}]"""
        assertEquals(emptyList<String>(), warnings(""","materials":[$second,{}]$textures""", ""","TEXCOORD_1":1"""))
    }

    @Test
    fun aMaterialHasTwoSetsOfTextureCoordinates() {
        fun info(set: Int) = """{"index":0,"texCoord":$set}"""
        val pbr = """"pbrMetallicRoughness":{"baseColorTexture":${info(0)},"metallicRoughnessTexture":${info(1)}}"""
        val material = """{$pbr,"normalTexture":${info(2)},"emissiveTexture":${info(1)}}"""
        val more = ""","materials":[$material,{}],"textures":[{"source":0}],"images":[{"bufferView":2}]"""
        assertEquals(
            listOf("textures with a third set of texture coordinates are left out: 1"),
            warnings(more, ""","TEXCOORD_1":1"""),
        )
    }

    @Test
    fun formatsThatAreNotDecodedAreNamedUnlessThereIsAnotherImage() {
        val textured = { index: Int -> """{"pbrMetallicRoughness":{"baseColorTexture":{"index":$index}}}""" }
        for (extension in listOf("KHR_texture_basisu", "EXT_texture_avif")) {
            val only = """{"extensions":{"$extension":{"source":1}}}"""
            val both = """{"source":0,"extensions":{"$extension":{"source":1}}}"""
            val data = Base64.getEncoder().encodeToString("    ftypavif".toByteArray())
            val avif = """{"uri":"data:image/avif;base64,$data"}"""
            val images = ""","images":[{"bufferView":2},$avif],"extensionsRequired":["$extension"]"""
            val materials = ""","materials":[${textured(0)},${textured(1)}]"""
            val sentence = "images[1] cannot be decoded and is left out: it is AVIF; save it as PNG, JPEG or WebP"
            assertEquals(listOf(sentence), warnings("""$materials,"textures":[$only,$only]$images"""))
            assertEquals(emptyList<String>(), warnings("""$materials,"textures":[$both,$both]$images"""))
        }
        val webP = """{"extensions":{"EXT_texture_webp":{"source":0}}}"""
        val rest = ""","images":[{"bufferView":2}],"extensionsRequired":["EXT_texture_webp"]"""
        assertEquals(emptyList<String>(), warnings(""","materials":[${textured(0)},{}],"textures":[$webP]$rest"""))
    }
}
