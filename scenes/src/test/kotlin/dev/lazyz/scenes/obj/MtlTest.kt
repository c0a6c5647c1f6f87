package dev.lazyz.scenes.obj

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.material.Lobes
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class MtlTest {
    @TempDir
    lateinit var folder: Path

    private val triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nusemtl a\nf 1/1 2/2 3/3\n"

    @BeforeEach
    fun writeTexture() {
        Files.createDirectories(folder.resolve("lib/tex"))
        val png = PngFile.of(1, 1, 8, PngFile.GREY_ALPHA, listOf(PngFile.bytes(9, 0)))
        for (name in listOf("wood.png", "lib/tex/dark oak.png", "lib/own.png")) Files.write(folder.resolve(name), png)
    }

    private fun mesh(library: String, place: String = "m.mtl", statement: String = place, warnings: Int = 0): Mesh {
        Files.writeString(folder.resolve(place), "newmtl a\n$library\n")
        val source = TestSources.of("mtllib $statement\n$triangle", folder)
        val mesh = ObjParser.parse(source).meshes.single()
        assertEquals(warnings, source.warnings.size, source.warnings.toString())
        return mesh
    }

    private fun code(color: Rgba) = "%08X".format(color.toArgb())

    @Test
    fun coloursAreSrgb() {
        val material = mesh("Kd 1 0.5 0\nKs 0.2 0.2 0.2\nKe 0 0 0.6\nNs 96.078\nillum 2").material
        assertEquals("a", material.name)
        assertEquals("FFFF8000", code(material.baseColor))
        assertEquals("FF333333", code(material.specular))
        assertEquals("FF000099", code(material.emission))
        assertEquals(96, material.shininess)
        assertEquals(Shading.BLINN_PHONG, material.shading)
        assertEquals(AlphaMode.OPAQUE, material.alphaMode)
    }

    @Test
    fun illuminationModelDecidesAboutLight() {
        val shiny = "Ks 1 1 1\nillum"
        assertEquals(Shading.CONSTANT, mesh("$shiny 0").material.shading)
        assertEquals(Rgba.BLACK, mesh("$shiny 1").material.specular)
        assertEquals(Rgba.WHITE, mesh("$shiny 2").material.specular)
    }

    @Test
    fun opacityMakesTheMaterialTranslucent() {
        val expected = mapOf(
            "d 0.25" to 0.25f,
            "Tr 0.25" to 0.75f,
            "d 0.25\nTr 0.25" to 0.25f,
            "Tr 0.9\nd 0.25" to 0.25f,
            "d -halo 0.5" to 0.5f,
        )
        for ((library, alpha) in expected) {
            val material = mesh(library).material
            assertEquals(alpha, material.baseColor.alpha, library)
            assertEquals(AlphaMode.BLEND, material.alphaMode, library)
        }
        assertEquals(AlphaMode.OPAQUE, mesh("d 1\nTr 0").material.alphaMode)

        // Some programs mean opaque by these
        for (library in listOf("Tr 1", "d 0", "d 0\nTr 1", "d -1")) {
            val material = mesh(library, warnings = 1).material
            assertEquals(1f, material.baseColor.alpha, library)
            assertEquals(AlphaMode.OPAQUE, material.alphaMode, library)
        }
    }

    /** The colour codes of the materials that a model uses, in order. */
    private fun codes(text: String, warnings: Int = 0): List<String> {
        val source = TestSources.of(text, folder)
        val meshes = ObjParser.parse(source).meshes
        assertEquals(warnings, source.warnings.size, source.warnings.toString())
        return meshes.map { code(it.material.baseColor) }
    }

    private val faces = "v 0 0 0\nv 1 0 0\nv 1 1 0\n"

    @Test
    fun commentsAfterNamesAreNoPartOfThem() {
        Files.writeString(folder.resolve("m.mtl"), "newmtl r # x\nKd 1 0 0 # y\nnewmtl g\t# z\nKd 0 1 0\n")
        val text = "mtllib m.mtl # a\n${faces}usemtl r # b\nf 1 2 3\nusemtl g\nf 1 2 3\nusemtl r\nf 3 2 1\n"
        assertEquals(listOf("FFFF0000", "FF00FF00", "FFFF0000"), codes(text))
        assertNotNull(mesh("map_Kd wood.png # the wood").material.texture)
        assertNotNull(mesh("map_Kd -clamp on wood.png\t#the wood").material.texture)
    }

    @Test
    fun oneStatementMayNameLibrariesWithSpaces() {
        Files.writeString(folder.resolve("my red.mtl"), "newmtl r\nKd 1 0 0\n")
        Files.writeString(folder.resolve("the blue.MTL"), "newmtl b\nKd 0 0 1\n")
        Files.writeString(folder.resolve("g.mtl"), "newmtl g\nKd 0 1 0\n")
        val used = "${faces}usemtl r\nf 1 2 3\nusemtl g\nf 1 2 3\nusemtl b\nf 1 2 3\n"
        val names = "mtllib my red.mtl g.mtl the blue.MTL"
        assertEquals(listOf("FFFF0000", "FF00FF00", "FF0000FF"), codes("$names\n$used"))
        assertEquals(listOf("FFFF0000", "FF00FF00", "FF0000FF"), codes("$names no such.mtl # c\n$used", warnings = 1))
    }

    @Test
    fun textureNamesMayHaveSpacesAndOptions() {
        val maps = listOf(
            "own.png", "tex\\dark oak.png", ".\\TEX\\Dark Oak.png", "-bm 1 -s 1 1 1 tex/dark oak.png",
            "-imfchan l -mm 0 1 own.png", "wood.png",
        )
        for (map in maps) {
            assertNotNull(mesh("map_Kd $map", "lib/m.mtl").material.texture, map)
        }
    }

    @Test
    fun scaleAndOffsetMoveTheTextureUpward() {
        assertEquals(listOf(0f, 1f, 1f, 1f, 1f, 0f), mesh("map_Kd wood.png").uvs!!.toList())
        val moved = mesh("map_Kd -s 2 3 -o 0.5 0.25 0 wood.png").uvs!!
        assertEquals(listOf(0.5f, 0.75f, 2.5f, 0.75f, 2.5f, -2.25f), moved.toList())
        assertEquals(listOf(0f, 1f, 2f, 1f, 2f, 0f), mesh("map_Kd -s 2 wood.png").uvs!!.toList())
    }

    @Test
    fun blackUnderATextureMeansWhite() {
        assertEquals("FFFFFFFF", code(mesh("Kd 0 0 0\nmap_Kd wood.png").material.baseColor))
        assertEquals("FF000000", code(mesh("Kd 0 0 0").material.baseColor))
        assertEquals("FF808080", code(mesh("Kd 0.5 0.5 0.5\nmap_Kd wood.png").material.baseColor))
    }

    private fun image(name: String, vararg greys: Int) {
        Files.write(folder.resolve(name), PngFile.of(greys.size, 1, 8, PngFile.GREY, listOf(PngFile.bytes(*greys))))
    }

    private fun texels(map: TextureMap?): List<String> =
        checkNotNull(map).texture.run { List(width * height) { "%08X".format(texel(it % width, it / width)) } }

    @Test
    fun anotherImageIsAMaskToo() {
        image("color.png", 9, 200, 30, 40)
        image("mask.png", 255, 0)
        val masked = mesh("map_Kd color.png\nmap_d mask.png").material
        assertEquals(AlphaMode.MASK, masked.alphaMode)
        assertEquals(listOf("FF090909", "FFC8C8C8", "001E1E1E", "00282828"), texels(masked.textureMap))
        assertEquals(listOf("FFFFFFFF", "00FFFFFF"), texels(mesh("map_d mask.png").material.textureMap))
    }

    @Test
    fun physicallyBasedNumbersMakeAModel() {
        assertNull(mesh("Ns 100").material.metallicRoughness)
        assertEquals(MetallicRoughness(0.25f, 0.75f), mesh("Pm 0.25\nPr 0.75").material.metallicRoughness)
        assertEquals(MetallicRoughness(0f, 1f), mesh("Pr 7").material.metallicRoughness)
        val sheen = Lobes.Sheen(Rgba(0.25f, 0.25f, 0.25f), 0.5f)
        val lobes = Lobes(sheen = sheen, clearcoat = Lobes.Clearcoat(0.5f, 0.75f))
        val brushed = mesh("aniso 0.75\nanisor 0.25")
        assertEquals(Lobes(anisotropy = Lobes.Anisotropy(0.75f, 90f)), brushed.material.metallicRoughness?.lobes)
        assertEquals(lobes, mesh("Ps 0.25\nPc 0.5\nPcr 0.75").material.metallicRoughness?.lobes)
        assertNull(mesh("Ps 0\nPc 0\nPcr 0.75").material.metallicRoughness)
        assertEquals(MetallicRoughness(1f, 0.5f), mesh("Ns 30\nPm 1").material.metallicRoughness)
    }

    @Test
    fun mapsOfTheModelAreOneTexture() {
        image("rough.png", 10, 20)
        image("metal.png", 255)
        val both = mesh("Pm 0\nmap_Pr rough.png\nmap_Pm metal.png").material.metallicRoughness
        assertEquals(1f to 1f, both?.metallic to both?.roughness)
        assertEquals(listOf("FFFF0AFF", "FFFF14FF"), texels(both?.map))
        assertEquals(Texture.Encoding.LINEAR, both?.map?.texture?.encoding)
        val rough = mesh("Pm 0.5\nmap_Pr rough.png").material.metallicRoughness
        assertEquals(0.5f to 1f, rough?.metallic to rough?.roughness)
    }

    @Test
    fun emissionMapsGlow() {
        image("glow.png", 77)
        assertEquals(Rgba.WHITE, mesh("map_Ke glow.png").material.emission)
        val red = mesh("Ke 1 0 0\nmap_Ke glow.png").material
        assertEquals(Rgba(1f, 0f, 0f), red.emission)
        assertEquals(listOf("FF4D4D4D"), texels(red.emissionMap))
    }

    @Test
    fun normalMapsGetTangents() {
        image("n.png", 128)
        val mesh = mesh("norm n.png")
        assertEquals(listOf("FF808080"), texels(mesh.material.normalMap?.map))
        assertEquals(Texture.Encoding.LINEAR, mesh.material.normalMap?.map?.texture?.encoding)
        assertEquals(listOf(1f, 0f, 0f, 1f), mesh.tangents?.take(4))
    }

    @Test
    fun heightsBecomeNormals() {
        // A slope that rises to the right by 1 / 255 of the depth a texel, and falls back at the border
        image("h.png", *IntArray(128) { it })
        for (statement in listOf("bump h.png", "map_Bump h.png", "map_Bump -bm 1 h.png")) {
            val normals = texels(mesh(statement).material.normalMap?.map)
            val slope = 1.0 / 255
            val length = Math.sqrt(1.0 + slope * slope)
            fun code(component: Double) = ((component / length + 1) / 2 * 255 + 0.5).toInt()
            assertEquals("FF%02X%02X%02X".format(code(-slope), code(0.0), code(1.0)), normals[64])
        }
        val steep = texels(mesh("bump -bm 100 h.png").material.normalMap?.map)[64]
        assertTrue(steep.substring(2, 4).toInt(16) < 90) { steep }
        image("v.png", 0)
        assertEquals(listOf("FF8080FF"), texels(mesh("bump v.png").material.normalMap?.map))
    }

    @Test
    fun optionsOfEachMapAreItsOwn() {
        image("glow.png", 77)
        val mesh = mesh("map_Kd -s 2 4 -o 0.5 0.25 wood.png\nmap_Ke -s 3 5 -o 0.125 1 glow.png")
        val transform = checkNotNull(mesh.material.emissionMap).transform
        val uvs = checkNotNull(mesh.uvs)
        for ((vertex, place) in listOf(0f to 0f, 1f to 0f, 1f to 1f).withIndex()) {
            val u = transform.u(uvs[2 * vertex], uvs[2 * vertex + 1])
            val v = transform.v(uvs[2 * vertex], uvs[2 * vertex + 1])
            assertEquals(place.first * 3 + 0.125f, u, 1e-6f)
            assertEquals(1 - (place.second * 5 + 1), v, 1e-6f)
        }
    }

    @Test
    fun unusedTexturesGiveOneWarning() {
        val text = "Kd 1 0 0\nmap_Kd wood.png\nmap_Ks a.png\ndisp a.png\nmap_Ns b.png\n" +
            "newmtl b\nREFL n.png\nmap_Ks c.png\nKa 1 1 1\nNi 1\n"
        Files.writeString(folder.resolve("m.mtl"), "newmtl a\n$text")
        val source = TestSources.of("mtllib m.mtl\n$triangle", folder)
        ObjParser.parse(source)
        val expected = "library m.mtl: statements that are not used are 2 map_ks, 1 disp, 1 map_ns, 1 refl"
        assertTrue(source.warnings.single().endsWith(expected), source.warnings.toString())
    }

    @Test
    fun missingLibraryAndMaterialGiveWarnings() {
        val source = TestSources.of("mtllib none.mtl\n" + triangle + "f 1 2 3\n", folder)
        val mesh = ObjParser.parse(source).meshes.first()
        assertEquals("FFFFFFFF", code(mesh.material.baseColor))
        assertEquals(2, source.warnings.size, source.warnings.toString())
        assertTrue("none.mtl" in source.warnings[0] && "material a" in source.warnings[1], source.warnings.toString())
        val stream = TestSources.of("mtllib m.mtl\n$triangle")
        ObjParser.parse(stream)
        assertTrue("stream" in stream.warnings[0], stream.warnings.toString())
    }
}
