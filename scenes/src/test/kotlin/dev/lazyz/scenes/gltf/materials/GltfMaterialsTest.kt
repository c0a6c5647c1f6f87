package dev.lazyz.scenes.gltf.materials

import dev.lazyz.Rgba
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfFiles.Companion.FLOAT
import dev.lazyz.scenes.gltf.GltfFiles.Companion.ONE_NODE
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap.UvTransform
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class GltfMaterialsTest {
    private val png = PngFile.of(2, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9, 200)))

    private fun read(material: String, more: String = "", folder: Path? = null): Pair<Material, Source> {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        files.accessor("VEC2", FLOAT, List(6) { 0 })
        files.view(png)
        val mesh = """"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1},"material":0}]}]"""
        val source = TestSources.of(files.json("""$ONE_NODE,$mesh,"materials":[$material]$more"""), folder)
        return GltfParser.parse(source).meshes.single().material to source
    }

    private fun material(json: String, more: String = "") = read(json, more).first

    private fun pbr(json: String) = material("""{"pbrMetallicRoughness":{$json}}""")

    @Test
    fun factorsAreLinear() {
        val pbr = """"pbrMetallicRoughness":{"baseColorFactor":[0.5,0.25,0,0.75]}"""
        val material = material("""{"name":"a",$pbr,"emissiveFactor":[0,0.5,1]}""")
        assertEquals(Rgba(0.5f, 0.25f, 0f, 0.75f), material.baseColor)
        assertEquals(Rgba(0f, 0.5f, 1f), material.emission)
        assertEquals("a", material.name)
        assertEquals(Shading.BLINN_PHONG, material.shading)
    }

    @Test
    fun alphaModesAndSidesAreKept() {
        assertEquals(AlphaMode.OPAQUE to Sides.FRONT, material("{}").let { it.alphaMode to it.sides })
        val masked = material("""{"alphaMode":"MASK","alphaCutoff":0.25,"doubleSided":true}""")
        assertEquals(AlphaMode.MASK to Sides.BOTH, masked.alphaMode to masked.sides)
        assertEquals(0.25f, masked.alphaCutoff)
        assertEquals(AlphaMode.BLEND, material("""{"alphaMode":"BLEND"}""").alphaMode)
        val (unknown, source) = read("""{"alphaMode":"MAGIC"}""")
        assertEquals(AlphaMode.OPAQUE, unknown.alphaMode)
        assertEquals(1, source.warnings.size)
    }

    @Test
    fun extensionsChangeLight() {
        assertEquals(Shading.CONSTANT, material("""{"extensions":{"KHR_materials_unlit":{}}}""").shading)
        val strength = """"KHR_materials_emissive_strength":{"emissiveStrength":4}"""
        val strong = material("""{"emissiveFactor":[1,0.5,0],"extensions":{$strength}}""")
        assertEquals(Rgba(4f, 2f, 0f), strong.emission)
    }

    private fun lobes(extensions: String, more: String = "") =
        material("""{"extensions":{$extensions}$more}""", image)

    @Test
    fun extensionsBecomeLobes() {
        val texture = """{"index":0}"""
        val coat = """"clearcoatFactor":0.5,"clearcoatTexture":$texture,"clearcoatRoughnessFactor":0.25"""
        val normals = """"clearcoatNormalTexture":{"index":0,"scale":2}"""
        val sheen = """"sheenColorFactor":[1,0.5,0],"sheenRoughnessFactor":0.75,"sheenColorTexture":$texture"""
        val specular = """"specularFactor":0.5,"specularColorFactor":[2,1,0],"specularTexture":$texture"""
        val material = lobes(
            """"KHR_materials_clearcoat":{$coat,$normals},"KHR_materials_sheen":{$sheen},""" +
                """"KHR_materials_specular":{$specular},"KHR_materials_ior":{"ior":1.25},""" +
                """"KHR_materials_iridescence":{"iridescenceFactor":0.5,"iridescenceThicknessMaximum":600},""" +
                """"KHR_materials_anisotropy":{"anisotropyStrength":0.5,"anisotropyRotation":1.5707964,""" +
                """"anisotropyTexture":$texture}""",
        )
        val lobes = checkNotNull(material.metallicRoughness?.lobes)
        val numbers = checkNotNull(lobes.clearcoat?.strengthMap)
        assertEquals(Texture.Encoding.LINEAR, numbers.texture.encoding)
        assertEquals(Lobes.Clearcoat(0.5f, 0.25f, numbers, null, NormalMap(numbers, 2f)), lobes.clearcoat)
        val colors = checkNotNull(lobes.sheen?.colorMap)
        assertEquals(Texture.Encoding.SRGB, colors.texture.encoding)
        assertEquals(Lobes.Sheen(Rgba(1f, 0.5f, 0f), 0.75f, colors), lobes.sheen)
        assertEquals(Lobes.Specular(0.5f, Rgba(2f, 1f, 0f), 1.25f, numbers), lobes.specular)
        assertEquals(Lobes.Iridescence(0.5f, thickness = 600f), lobes.iridescence)
        assertEquals(Lobes.Anisotropy(0.5f, 90f, numbers), lobes.anisotropy)
        assertEquals(numbers, material.tangentMap)
    }

    @Test
    fun transmissionMakesGlass() {
        val numbers = """"thicknessFactor":2,"attenuationDistance":4,"attenuationColor":[1,0.5,0]"""
        val volume = """"KHR_materials_volume":{$numbers}"""
        val base = ""","pbrMetallicRoughness":{"baseColorFactor":[1,1,1,0.5]}"""
        val glass = lobes(""""KHR_materials_transmission":{"transmissionFactor":0.75},$volume""", base)
        val expected = Lobes.Transmission(0.75f, null, 2f, null, Rgba(1f, 0.5f, 0f), 4f)
        assertEquals(Lobes(transmission = expected), glass.metallicRoughness?.lobes)
        assertEquals(AlphaMode.BLEND to Rgba.WHITE, glass.alphaMode to glass.baseColor)
    }

    @Test
    fun extensionsThatChangeNothingAreNoLobes() {
        val none = """"KHR_materials_clearcoat":{},"KHR_materials_sheen":{"sheenRoughnessFactor":1},""" +
            """"KHR_materials_specular":{},"KHR_materials_ior":{"ior":1.5},"KHR_materials_transmission":{},""" +
            """"KHR_materials_volume":{"thicknessFactor":1},"KHR_materials_anisotropy":{"anisotropyRotation":1}"""
        assertNull(lobes(none).metallicRoughness?.lobes)
    }

    @Test
    fun variantsAreChosenByName() {
        val mapping = """{"mappings":[{"material":1,"variants":[1]}]}"""
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        val part = """{"attributes":{"POSITION":0},"material":0,"extensions":{"KHR_materials_variants":$mapping}}"""
        val names = """"extensions":{"KHR_materials_variants":{"variants":[{"name":"day"},{"name":"night"}]}}"""
        val scenes = """"scenes":[{"nodes":[]},{"nodes":[0]}],"scene":1,"nodes":[{"mesh":0}]"""
        val json = files.json(
            """$scenes,"meshes":[{"primitives":[$part]}],"materials":[{"name":"a"},{"name":"b"}],$names""",
        )
        fun load(options: LoadOptions) = Scenes.load(json.toByteArray(), SceneFormat.GLTF, "test", options)
        fun name(variant: String?) =
            (load(LoadOptions().withVariant(variant)).scene.surfaces.single() as Mesh).material.name
        assertEquals(listOf("a", "a", "b"), listOf(null, "day", "night").map(::name))
        val unknown = assertThrows(SceneFormatException::class.java) { name("dusk") }
        assertTrue("\"day\", \"night\"" in unknown.message.orEmpty(), unknown.message)
        assertEquals(0, load(LoadOptions().withSceneNumber(0)).scene.surfaces.size)
        val beyond = assertThrows(SceneFormatException::class.java) { load(LoadOptions().withSceneNumber(2)) }
        assertTrue("there are 2" in beyond.message.orEmpty(), beyond.message)
    }

    @Test
    fun factorsOutsideTheirRangeAreClamped() {
        val base = """"baseColorFactor":[1.00000012,0.5,-0.0001,1],"roughnessFactor":-0.00001"""
        val (nearly, source) = read("""{"pbrMetallicRoughness":{$base},"emissiveFactor":[0,0.5,1.0005]}""")
        assertEquals(Rgba(1f, 0.5f, 0f), nearly.baseColor)
        assertEquals(0f, nearly.metallicRoughness?.roughness)
        assertEquals(Rgba(0f, 0.5f, 1f), nearly.emission)
        assertEquals(emptyList<String>(), source.warnings)
        val (far, warned) = read("""{"pbrMetallicRoughness":{"metallicFactor":2},"emissiveFactor":[0.5,3,7]}""")
        assertEquals(1f, far.metallicRoughness?.metallic)
        assertEquals(Rgba(0.5f, 1f, 1f), far.emission)
        val expected = listOf("pbrMetallicRoughness.metallicFactor", "emissiveFactor")
            .map { "test: materials.$it is outside 0..1 and is clamped: 1" }
        assertEquals(expected, warned.warnings)
    }

    private fun glossy(json: String, more: String = "") =
        read("""{"extensions":{"KHR_materials_pbrSpecularGlossiness":{$json}}$more}""", image)

    @Test
    fun specularGlossinessIsConverted() {
        val factors = """"specularFactor":[0,0,0],"glossinessFactor":0.25"""
        val (matt, source) = glossy(""""diffuseFactor":[0.48,0.24,0,0.5],$factors""")
        assertEquals(listOf(0.5f, 0.25f, 0f, 0.5f), matt.baseColor.run { listOf(red, green, blue, alpha) })
        assertEquals(MetallicRoughness(0f, 0.75f), matt.metallicRoughness)
        assertEquals(emptyList<String>(), source.warnings)
        val gold = glossy(""""diffuseFactor":[0,0,0,1],"specularFactor":[1,0.75,0.25],"glossinessFactor":0.75""").first
        assertEquals(Rgba(1f, 0.75f, 0.25f), gold.baseColor)
        assertEquals(MetallicRoughness(1f, 0.25f), gold.metallicRoughness)
        assertEquals(MetallicRoughness(1f, 0f), glossy("").first.metallicRoughness)
    }

    @Test
    fun texturesOfSpecularColourAndGlossinessAreShown() {
        val diffuse = """"diffuseFactor":[0.5,0.25,0,1],"diffuseTexture":{"index":0}"""
        val specular = """"specularFactor":[0.5,0.25,0],"glossinessFactor":0.75"""
        val (material, source) = glossy("$diffuse,$specular,\"specularGlossinessTexture\":{\"index\":0}")
        assertEquals(emptyList<String>(), source.warnings)
        assertEquals(Rgba(0.5f, 0.25f, 0f), material.baseColor)
        assertNotNull(material.textureMap)
        val model = checkNotNull(material.metallicRoughness)
        assertEquals(0f to 1f, model.metallic to model.roughness)
        assertEquals(0xFFFF40FF.toInt(), checkNotNull(model.map).texture.texel(0, 0) or 0xFF0000)
        val reflected = Lobes.Specular(1f, Rgba(0.5f, 0.25f, 0f), 0f, null, model.lobes?.specular?.colorMap)
        assertEquals(Lobes(reflected), model.lobes)
        assertEquals(Texture.Encoding.SRGB, reflected.colorMap?.texture?.encoding)

        val plain = checkNotNull(glossy("$diffuse,$specular").first.metallicRoughness)
        assertEquals(MetallicRoughness(0f, 0.25f, null, Lobes(Lobes.Specular(1f, reflected.color, 0f))), plain)
    }

    @Test
    fun metallicRoughnessIsPreferredToTexturesOfGlossiness() {
        val metallic = ""","pbrMetallicRoughness":{"metallicRoughnessTexture":{"index":0}}"""
        val own = checkNotNull(
            glossy("\"specularGlossinessTexture\":{\"index\":0}", metallic).first.metallicRoughness,
        )
        assertNotNull(own.map)
        assertNull(own.lobes)
        assertNull(glossy("\"diffuseTexture\":{\"index\":0}", metallic).first.metallicRoughness?.map)
    }

    private val image = ""","textures":[{"source":0}],"images":[{"bufferView":2}]"""

    @Test
    fun mapsHaveTheirEncodings() {
        val pbr = """"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"metallicRoughnessTexture":{"index":0}}"""
        val normal = """"normalTexture":{"index":0,"scale":0.5}"""
        val rest = """"occlusionTexture":{"index":0,"strength":0.25},"emissiveTexture":{"index":0}"""
        val (material, source) = read("""{$pbr,$normal,$rest,"emissiveFactor":[1,0.5,0]}""", image)
        assertEquals(emptyList<String>(), source.warnings)
        assertEquals(Texture.Encoding.SRGB, material.texture?.encoding)
        assertEquals(Texture.Encoding.LINEAR, material.metallicRoughness?.map?.texture?.encoding)
        assertEquals(Texture.Encoding.LINEAR, material.normalMap?.map?.texture?.encoding)
        assertEquals(Texture.Encoding.LINEAR, material.occlusionMap?.map?.texture?.encoding)
        assertEquals(Texture.Encoding.SRGB, material.emissionMap?.texture?.encoding)
        assertEquals(0.5f to 0.25f, material.normalMap?.scale to material.occlusionMap?.strength)
        assertEquals(Rgba(1f, 0.5f, 0f), material.emission)
    }

    @Test
    fun eachMapHasItsOwnTransformAndSet() {
        val transform = """"KHR_texture_transform":{"scale":[2,3],"offset":[0.5,0.25],"rotation":1.5707963267948966}"""
        val moved = """{"index":0,"extensions":{$transform}}"""
        val pbr = """"pbrMetallicRoughness":{"baseColorTexture":$moved}"""
        val material = material("""{$pbr,"emissiveTexture":{"index":0}}""", image)
        assertEquals(UvTransform.IDENTITY, material.emissionMap?.transform)
        val map = checkNotNull(material.textureMap)
        val places = listOf(0f to 0f, 1f to 0f, 0f to 1f)
        for ((from, to) in places.zip(listOf(0.5f to 0.25f, 0.5f to -1.75f, 3.5f to 0.25f))) {
            assertEquals(to.first, map.transform.u(from.first, from.second), 1e-6f)
            assertEquals(to.second, map.transform.v(from.first, from.second), 1e-6f)
        }
    }

    @Test
    fun setsOfCoordinatesAreNumberedByUse() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        files.accessor("VEC2", FLOAT, listOf(0, 0, 1, 0, 0, 1))
        files.accessor("VEC2", FLOAT, listOf(5, 5, 6, 5, 5, 6))
        files.view(png)
        val attributes = """"POSITION":0,"TEXCOORD_0":1,"TEXCOORD_3":2"""
        val override = """"extensions":{"KHR_texture_transform":{"texCoord":3}}"""
        val json = files.json(
            """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{$attributes},"material":0}]}],
            "textures":[{"source":0}],"images":[{"bufferView":3}],"materials":[{"pbrMetallicRoughness":{
            "baseColorTexture":{"index":0,$override}},"emissiveTexture":{"index":0}}]""",
        )
        val mesh = GltfParser.parse(TestSources.of(json)).meshes.single()
        assertEquals(0 to 1, mesh.material.textureMap?.uvSet to mesh.material.emissionMap?.uvSet)
        assertEquals(listOf(5f, 5f), mesh.uvs?.take(2))
        assertEquals(listOf(0f, 0f), mesh.uvs2?.take(2))
    }

    @Test
    fun tangentsAreReadOrComputed() {
        fun mesh(normals: Boolean, tangents: Boolean): Mesh {
            val files = GltfFiles()
            files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
            files.accessor("VEC2", FLOAT, listOf(0, 1, 1, 1, 0, 0))
            files.accessor("VEC3", FLOAT, listOf(0, 0, 1, 0, 0, 1, 0, 0, 1))
            files.accessor("VEC4", FLOAT, List(3) { listOf(0, 1, 0, -1) }.flatten())
            files.view(png)
            val more = (if (normals) ",\"NORMAL\":2" else "") + (if (tangents) ",\"TANGENT\":3" else "")
            val json = files.json(
                """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0,"TEXCOORD_0":1$more},"material":0}]}],
                "textures":[{"source":0}],"images":[{"bufferView":4}],"materials":[{"normalTexture":{"index":0}}]""",
            )
            return GltfParser.parse(TestSources.of(json)).meshes.single()
        }
        assertEquals(listOf(0f, 1f, 0f, -1f), mesh(normals = true, tangents = true).tangents?.take(4))
        for ((normals, tangents) in listOf(true to false, false to true, false to false)) {
            assertEquals(listOf(1f, 0f, 0f, 1f), mesh(normals, tangents).tangents?.take(4)?.map { it + 0f })
        }
    }

    @Test
    fun imagesMayBeEmbeddedOrFiles(@TempDir folder: Path) {
        Files.write(folder.resolve("dark oak.png"), png)
        val textured = """{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}"""
        val images = listOf(
            """{"bufferView":2,"mimeType":"image/png"}""",
            """{"uri":"data:image/png;base64,${Base64.getEncoder().encodeToString(png)}"}""",
            """{"uri":"dark%20oak.png"}""",
            """{"uri":"dark oak.png"}""",
        )
        for (image in images) {
            val (material, source) = read(textured, ""","textures":[{"source":0}],"images":[$image]""", folder)
            assertEquals(0xFFC8C8C8.toInt(), material.texture?.texel(1, 0), image)
            assertEquals(emptyList<String>(), source.warnings)
        }
        for (uri in listOf("none.png", "data:image/png;base64,AAAA", "data:image/png;base64,*", "data:,x", null)) {
            val image = if (uri == null) "{}" else """{"uri":"$uri"}"""
            val (material, source) = read(textured, ""","textures":[{"source":0}],"images":[$image]""", folder)
            assertNull(material.texture, image)
            assertEquals(1, source.warnings.size, image)
        }
    }

    @Test
    fun textureWithoutCoordinatesIsLeftOut() {
        val files = GltfFiles()
        files.accessor("VEC3", FLOAT, listOf(0, 0, 0, 1, 0, 0, 0, 1, 0))
        files.view(png)
        val json = files.json(
            """$ONE_NODE,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
            "textures":[{"source":0}],"images":[{"bufferView":1}],
            "materials":[{"name":"a","pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}]""",
        )
        val material = GltfParser.parse(TestSources.of(json)).meshes.single().material
        assertNull(material.texture)
        assertEquals("a", material.name)
    }

    @Test
    fun samplersDecideFilterAndWrap() {
        fun sampled(sampler: String): List<Any> {
            val more = ""","textures":[{"source":0,"sampler":0}],"images":[{"bufferView":2}],"samplers":[$sampler]"""
            val texture = material("""{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}""", more).texture
            assertNotNull(texture)
            return listOf(texture!!.filter, texture.wrapU, texture.wrapV)
        }
        assertEquals(listOf(Texture.Filter.BILINEAR, Texture.Wrap.REPEAT, Texture.Wrap.REPEAT), sampled("{}"))
        val nearest = sampled("""{"magFilter":9728,"wrapS":33071}""")
        assertEquals(listOf(Texture.Filter.NEAREST, Texture.Wrap.CLAMP, Texture.Wrap.REPEAT), nearest)
        val mirrored = sampled("""{"magFilter":9729,"wrapS":33648,"wrapT":33071}""")
        assertEquals(listOf(Texture.Filter.BILINEAR, Texture.Wrap.MIRROR, Texture.Wrap.CLAMP), mirrored)
    }

    @Test
    fun requiredExtensionsAreTakenSeriously() {
        val (_, source) = read("{}", ""","extensionsRequired":["KHR_materials_dispersion","KHR_materials_unlit"]""")
        assertTrue("1 in all: KHR_materials_dispersion" in source.warnings.single(), source.warnings.toString())
    }
}
