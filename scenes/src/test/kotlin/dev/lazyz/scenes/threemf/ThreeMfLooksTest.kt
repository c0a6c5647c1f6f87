package dev.lazyz.scenes.threemf

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.threemf.ThreeMfFiles.model
import dev.lazyz.shared.ProcessorTime
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.surface.Mesh
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

class ThreeMfLooksTest {
    private val bases = "<basematerials id=\"1\"><base name=\"a\" displaycolor=\"#FF0000\"/>" +
        "<base displaycolor=\"#0000FF80\"/><base name=\"none\"/></basematerials>"
    private val colors =
        "<m:colorgroup id=\"2\"><m:color color=\"#00FF00FF\"/><m:color color=\"#808080\"/></m:colorgroup>"

    /** An object of triangles with the given attributes, all at one place. */
    private fun thing(attributes: String, vararg triangles: String) = "<object $attributes><mesh><vertices>" +
        "<vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"0\" y=\"1\" z=\"0\"/>" +
        "</vertices><triangles>" + triangles.joinToString("") { "<triangle v1=\"0\" v2=\"1\" v3=\"2\" $it/>" } +
        "</triangles></mesh></object>"

    private fun meshes(resources: String, build: String, warnings: List<String> = emptyList()): List<Mesh> {
        val png = PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9)))
        val bytes = ThreeMfFiles.of(model(resources, build), "3D/Textures/t.png" to png)
        val source = TestSources.of(bytes)
        val meshes = ThreeMfParser.parse(source).meshes
        assertEquals(warnings.map { "test: $it" }, source.warnings)
        return meshes
    }

    /** The colours of each corner, as codes. */
    private fun Mesh.codes() = triangles.map { vertex ->
        val (r, g, b, a) = colors!!.slice(4 * vertex until 4 * vertex + 4)
        "%08X".format(Rgba(r, g, b, a).toArgb())
    }

    private val item = "<item objectid=\"9\"/>"

    @Test
    fun displayPropertiesAreThoseOfTheFirstCorner() {
        val metal = "<m:pbmetallicdisplayproperties id=\"7\"><m:pbmetallic name=\"a\"/>" +
            "<m:pbmetallic metallicness=\"1\" roughness=\"0.25\"/>" +
            "<m:pbmetallic roughness=\"2\" metallicness=\"NaN\"/></m:pbmetallicdisplayproperties>"
        val triangles = arrayOf("p1=\"1\" p2=\"0\" p3=\"0\"", "p1=\"0\"", "p1=\"2\"", "pid=\"2\" p1=\"0\"")
        val group = bases.replace("id=\"1\"", "id=\"1\" displaypropertiesid=\"7\"")
        for (resources in listOf(metal + group, group + metal)) {
            val parts = meshes(resources + colors + thing("id=\"9\" pid=\"1\" pindex=\"0\"", *triangles), item)
            val models = parts.map { it.material.metallicRoughness }
            assertEquals(listOf(MetallicRoughness(1f, 0.25f), MetallicRoughness(0f, 1f), null), models)
            assertEquals(listOf(1, 2, 1), parts.map { it.triangleCount })
        }

        // Elements can name the properties themselves, and layers have those of the first one
        val own = bases.replace("displaycolor=\"#0000FF80\"", "displaycolor=\"#0000FF\" displaypropertiesid=\"7\"")
        val layers = "<m:multiproperties id=\"6\" pids=\"1 4\"><m:multi pindices=\"1 0\"/></m:multiproperties>"
        val thing = thing("id=\"9\" pid=\"1\" pindex=\"0\"", "p1=\"1\"", "p1=\"0\"", "pid=\"6\" p1=\"0\"")
        val found = meshes(metal + own + textures + layers + thing, item).map { it.material.metallicRoughness }
        assertEquals(listOf(MetallicRoughness(1f, 0.25f), null, MetallicRoughness(1f, 0.25f)), found)
    }

    @Test
    fun specularColoursAreReflectances() {
        val shiny = "<m:pbspeculardisplayproperties id=\"7\"><m:pbspecular glossiness=\"0.75\"/>" +
            "<m:pbspecular specularcolor=\"#FFFFFF\"/></m:pbspeculardisplayproperties>"
        val group = colors.replace("id=\"2\"", "id=\"2\" displaypropertiesid=\"7\"")
        val parts = meshes(shiny + group + thing("id=\"9\"", "pid=\"2\" p1=\"0\"", "pid=\"2\" p1=\"1\""), item)
        val (plastic, mirror) = parts.map { it.material.metallicRoughness!! }
        assertEquals(MetallicRoughness(0f, 0.25f), plastic)
        val specular = checkNotNull(mirror.lobes?.specular)
        assertEquals(1f, mirror.roughness)
        assertEquals(1f, specular.color.red * 0.04f, 1e-6f)
    }

    @Test
    fun texturesOfDisplayPropertiesAreLaidAsThatOfTheColour() {
        fun textured(properties: String, more: String): MetallicRoughness {
            val own = textures.replace("texid=\"3\"", "texid=\"3\" displaypropertiesid=\"7\"")
            val other = "<m:texture2d id=\"8\" path=\"/3D/Textures/n.png\" contenttype=\"image/png\"/>"
            val numbers = PngFile.of(1, 1, 8, PngFile.RGBA, listOf(PngFile.bytes(51, 102, 153, 204)))
            val grey = PngFile.of(1, 1, 8, PngFile.GREY, listOf(PngFile.bytes(9)))
            val pb = "<m:$properties id=\"7\" $more/>"
            val model = model(own + other + pb + thing("id=\"9\"", "pid=\"4\" p1=\"0\""), item)
            val source = TestSources.of(
                ThreeMfFiles.of(model, "3D/Textures/t.png" to grey, "3D/Textures/n.png" to numbers),
            )
            val material = ThreeMfParser.parse(source).meshes.single().material
            assertEquals(emptyList<String>(), source.warnings)
            assertEquals(AlphaMode.OPAQUE, material.alphaMode)
            return checkNotNull(material.metallicRoughness)
        }
        fun texel(map: TextureMap?) = "%08X".format(checkNotNull(map).texture.texel(0, 0))
        val both = textured(
            "pbmetallictexturedisplayproperties",
            "metallictextureid=\"8\" roughnesstextureid=\"8\" metallicfactor=\"0.5\"",
        )
        assertEquals(listOf("FFFF3366", 0.5f, 1f), listOf(texel(both.map), both.metallic, both.roughness))
        assertEquals(Texture.Wrap.MIRROR, both.map!!.texture.wrapU)
        val two = textured("pbmetallictexturedisplayproperties", "metallictextureid=\"8\" roughnesstextureid=\"3\"")
        assertEquals("FFFF0933", texel(two.map))
        val gloss = textured(
            "pbspeculartexturedisplayproperties",
            "speculartextureid=\"8\" glossinesstextureid=\"8\" glossinessfactor=\"0.5\"",
        )
        assertEquals(listOf("FFFF99FF", "CC336699"), listOf(texel(gloss.map), texel(gloss.lobes!!.specular!!.colorMap)))
        assertEquals(listOf(0f, 1f), listOf(gloss.metallic, gloss.roughness))
    }

    @Test
    fun manyFinishesTakeLinearTime() {
        fun file(count: Int): ByteArray {
            fun all(element: (Int) -> String) = (0 until count).joinToString("", transform = element)
            val metal = "<m:pbmetallicdisplayproperties id=\"7\">" +
                all { "<m:pbmetallic metallicness=\"${it / 9999f}\" roughness=\"1\"/>" } +
                "</m:pbmetallicdisplayproperties>"
            val group = "<m:colorgroup id=\"2\" displaypropertiesid=\"7\">" + all { "<m:color color=\"#00FF00\"/>" } +
                "</m:colorgroup>"
            val triangles = Array(count) { "pid=\"2\" p1=\"$it\"" }
            return ThreeMfFiles.of(model(metal + group + thing("id=\"9\"", *triangles), item))
        }
        ProcessorTime.assertLinear(4800, ::file) { bytes, count ->
            assertEquals(count, ThreeMfParser.parse(TestSources.of(bytes)).meshes.size)
        }
    }

    @Test
    fun componentsWithoutLooksHaveThoseOfTheWhole() {
        val whole = "<object id=\"9\" pid=\"2\" pindex=\"0\"><components><component objectid=\"4\"/>" +
            "<component objectid=\"5\"/></components></object>"
        val parts = thing("id=\"4\"", "") + thing("id=\"5\" pid=\"1\" pindex=\"0\"", "")
        val (first, second, alone) = meshes(bases + colors + parts + whole, "$item<item objectid=\"4\"/>")
        assertEquals("FF00FF00", first.codes()[0])
        assertEquals("FFFF0000", second.codes()[0])
        assertNull(alone.colors)
    }

    private val textures = "<m:texture2d id=\"3\" path=\"/3D/Textures/t.png\" contenttype=\"image/png\" " +
        "tilestyleu=\"mirror\" tilestylev=\"clamp\" filter=\"nearest\"/><m:texture2dgroup id=\"4\" texid=\"3\">" +
        "<m:tex2coord u=\"0\" v=\"0\"/><m:tex2coord u=\"1\" v=\"0.25\"/></m:texture2dgroup>"

    @Test
    fun texturesAreMeshesOfTheirOwn() {
        val triangles = arrayOf("pid=\"4\" p1=\"0\" p2=\"1\" p3=\"1\"", "pid=\"1\" p1=\"0\"", "pid=\"4\" p1=\"1\"")
        val (textured, colored) = meshes(textures + bases + thing("id=\"9\"", *triangles), item)
        assertEquals(listOf(2, 1), listOf(textured.triangleCount, colored.triangleCount))
        val uvs = textured.triangles.map { textured.uvs!!.slice(2 * it..2 * it + 1) }
        assertEquals(listOf(listOf(0f, 1f)) + List(5) { listOf(1f, 0.75f) }, uvs)
        val texture = textured.material.texture!!
        assertEquals(listOf(Texture.Wrap.MIRROR, Texture.Wrap.CLAMP), listOf(texture.wrapU, texture.wrapV))
        assertEquals(Texture.Filter.NEAREST, texture.filter)
        assertNull(colored.material.texture)
    }

    @Test
    fun texturesOfStyleNoneEndWhereTheColourOfTheObjectBegins() {
        val none = "tilestyleu=\"none\" tilestylev=\"none\""
        fun texture(own: String, group: String = "4", styles: String = none): TextureMap {
            val resources = textures.replace("tilestyleu=\"mirror\" tilestylev=\"clamp\"", styles)
            val layers = "<m:multiproperties id=\"6\" pids=\"2 4\"><m:multi pindices=\"1 0\"/></m:multiproperties>"
            val thing = thing("id=\"9\" $own", "pid=\"$group\" p1=\"0\"")
            return meshes(resources + bases + colors + layers + thing, item).single().material.textureMap!!
        }

        fun sample(map: TextureMap, u: Float, v: Float): String {
            fun texel(at: Float, size: Int) = (at * size).toInt().coerceIn(0, size - 1)
            val image = map.texture
            return "%08X".format(
                image.texel(texel(map.transform.u(u, v), image.width), texel(map.transform.v(u, v), image.height)),
            )
        }
        val beyond = listOf(-0.01f to 0.5f, 1.01f to 0.5f, 0.5f to -3f, 0.5f to 1.01f, 9f to -9f)
        val colors = mapOf("pid=\"2\" pindex=\"0\"" to "FF00FF00", "" to "FFFFFFFF", "pid=\"4\"" to "FFFFFFFF")
        for ((own, color) in colors) {
            val map = texture(own)
            for (inside in listOf(0.01f, 0.5f, 0.99f)) assertEquals("FF090909", sample(map, inside, inside))
            for ((u, v) in beyond) assertEquals(color, sample(map, u, v), "$own at $u, $v")
        }
        assertEquals("FF808080", sample(texture("pid=\"1\"", group = "6"), 2f, 0.5f))
        val half = texture("pid=\"2\"", styles = "tilestyleu=\"wrap\" tilestylev=\"none\"")
        assertEquals(listOf(1, 3, Texture.Wrap.REPEAT), half.texture.run { listOf(width, height, wrapU) })
        assertEquals(listOf("FF090909", "FF00FF00"), listOf(sample(half, 2.5f, 0.5f), sample(half, 0.5f, 2f)))
    }

    @Test
    fun mixesAndLayersBecomeOneLook() {
        val mix = "<m:compositematerials id=\"5\" matid=\"1\" matindices=\"0 2\"><m:composite values=\"3 1\"/>" +
            "</m:compositematerials>"
        val layers = "<m:multiproperties id=\"6\" pids=\"1 4\"><m:multi pindices=\"0 1\"/><m:multi pindices=\"0\"/>" +
            "</m:multiproperties>"
        val thing = thing("id=\"9\"", "pid=\"5\" p1=\"0\"", "pid=\"6\" p1=\"0\" p2=\"1\" p3=\"1\"")
        val (mixed, layered) = meshes(bases + textures + mix + layers + thing, item)
        assertEquals(listOf(1f, 0.25f, 0.25f, 1f), mixed.colors!!.take(4))
        assertEquals("t.png", layered.material.texture!!.name)
        assertEquals(listOf(1f, 0.75f, 0f, 1f), layered.uvs!!.take(4))
    }

    /** The material of layers [pids], of which a texture has one transparent and one white texel. */
    private fun layered(
        groups: String,
        pids: String,
        warnings: List<String> = emptyList(),
        path: String = "u.png",
    ): Material {
        val layers = "<m:multiproperties id=\"6\" pids=\"$pids\"><m:multi pindices=\"0 0\"/></m:multiproperties>"
        val thing = thing("id=\"9\" pid=\"6\" pindex=\"0\"", "")
        val model = model(textures.replace("t.png", path) + groups + layers + thing, item)
        val png = PngFile.of(2, 1, 8, PngFile.GREY_ALPHA, listOf(PngFile.bytes(9, 0, 255, 255)))
        val source = TestSources.of(ThreeMfFiles.of(model, "3D/Textures/u.png" to png))
        val material = ThreeMfParser.parse(source).meshes.single().material
        assertEquals(warnings.map { "test: $it" }, source.warnings)
        return material
    }

    private fun texels(material: Material) =
        checkNotNull(material.texture).run { List(width) { "%08X".format(texel(it, 0)) } }

    @Test
    fun aTextureLiesOnTheColourBelowIt() {
        val opaque = layered(bases, "1 4")
        assertEquals(listOf("FFFF0000", "FFFFFFFF"), texels(opaque))
        assertEquals(AlphaMode.OPAQUE, opaque.alphaMode)
        assertEquals(listOf("FF00FF00", "FFFFFFFF"), texels(layered(colors, "2 4")))
        val more = listOf("what is not shown: 1 layers of multiproperties")
        assertEquals(listOf("FF00FF00", "FFFFFFFF"), texels(layered(bases + colors, "1 2 4", more)))
        assertEquals(listOf("00090909", "FFFFFFFF"), texels(layered("", "4")))
    }

    @Test
    fun whatIsNotThereGivesAWarning() {
        val warning = "3 triangles refer to colours or textures that are not there, and are drawn without"
        val triangles = arrayOf("pid=\"2\" p1=\"2\"", "pid=\"7\" p1=\"0\"", "pid=\"2\" p1=\"0\" p2=\"9\"")
        assertNull(meshes(colors + thing("id=\"9\"", *triangles), item, listOf(warning)).single().colors)
        val missing = textures.replace("t.png", "u.png") + thing("id=\"9\" pid=\"4\" pindex=\"0\"", "")
        val lost = "texture /3D/Textures/u.png is not in the package and is left out"
        val mesh = meshes(missing, item, listOf(lost)).single()
        assertNull(mesh.material.texture)
    }
}
