package dev.lazyz.scenes.obj

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.AlphaMode
import dev.lazyz.world.Mesh
import dev.lazyz.world.Shading
import dev.lazyz.world.TextureWrap
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
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
    fun oneNumberStandsForThree() {
        assertEquals("FF808080", code(mesh("Kd 0.5").material.baseColor))
    }

    @Test
    fun exponentStaysWithinItsRange() {
        assertEquals(listOf(1, 1, 1024, 32), listOf("Ns 0", "Ns -5", "Ns 9999", "").map { mesh(it).material.shininess })
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

        // Some programs mean opaque by it
        assertEquals(AlphaMode.OPAQUE, mesh("Tr 1", warnings = 1).material.alphaMode)
        assertEquals(0f, mesh("d 0").material.baseColor.alpha)
        assertEquals(0f, mesh("d 0\nTr 1").material.baseColor.alpha)
    }

    @Test
    fun textureNamesMayHaveSpacesAndOptions() {
        val maps = listOf(
            "own.png",
            "tex\\dark oak.png",
            ".\\TEX\\Dark Oak.png",
            "-bm 1 -s 1 1 1 tex/dark oak.png",
            "-imfchan l -mm 0 1 own.png",
            "wood.png",
        )
        for (map in maps) {
            assertNotNull(mesh("map_Kd $map", "lib/m.mtl").material.texture, map)
        }
    }

    @Test
    fun clampStopsRepetition() {
        assertEquals(TextureWrap.REPEAT, mesh("map_Kd wood.png").material.texture!!.wrapU)
        assertEquals(TextureWrap.REPEAT, mesh("map_Kd -clamp off wood.png").material.texture!!.wrapU)
        val clamped = mesh("map_Kd -clamp on wood.png").material.texture!!
        assertEquals(listOf(TextureWrap.CLAMP, TextureWrap.CLAMP), listOf(clamped.wrapU, clamped.wrapV))
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

    @Test
    fun alphaOfTheTextureCountsOnlyAsMapD() {
        assertEquals(AlphaMode.OPAQUE, mesh("map_Kd wood.png").material.alphaMode)
        assertEquals(AlphaMode.MASK, mesh("map_Kd wood.png\nmap_d wood.png").material.alphaMode)
        assertEquals(AlphaMode.OPAQUE, mesh("map_Kd wood.png\nmap_d other.png", warnings = 1).material.alphaMode)
    }

    @Test
    fun unusedTexturesGiveOneWarning() {
        val text = "Kd 1 0 0\nmap_Kd wood.png\nmap_Bump a.png\nbump a.png\nmap_d b.png\n" +
            "newmtl b\nNORM n.png\nmap_Bump c.png\nKa 1 1 1\nNi 1\n"
        Files.writeString(folder.resolve("m.mtl"), "newmtl a\n$text")
        val source = TestSources.of("mtllib m.mtl\n$triangle", folder)
        ObjParser.parse(source)
        val expected = "library m.mtl: textures that are not used are 2 map_bump, 1 bump, 1 norm, 1 map_d"
        assertTrue(source.warnings.single().endsWith(expected), source.warnings.toString())
    }

    @Test
    fun numbersOfAllSpellingsAreRead() {
        val material = mesh("Kd 5-e1 nan 0\nNs 1.5+e2\nd inf").material
        assertEquals("FF800000", code(material.baseColor))
        assertEquals(150, material.shininess)
    }

    @Test
    fun missingTextureGivesAPlainMaterial() {
        assertNull(mesh("Kd 1 0 0\nmap_Kd none.png", warnings = 1).material.texture)
    }

    @Test
    fun librariesAreFoundInOtherFoldersAndWithSpaces() {
        val statements = mapOf(
            "lib/m.mtl" to "lib\\m.mtl",
            "my lib.mtl" to "my lib.mtl",
            "lib/N.MTL" to "./lib/n.mtl",
            "x.mtl" to "none.mtl x.mtl",
        )
        for ((place, statement) in statements) {
            val warnings = if (statement.startsWith("none")) 1 else 0
            assertEquals("FFFF0000", code(mesh("Kd 1 0 0", place, statement, warnings).material.baseColor), place)
        }
    }

    @Test
    fun severalLibrariesAddUpAndTheFirstDefinitionCounts() {
        Files.writeString(folder.resolve("1.mtl"), "newmtl a\nKd 1 0 0\n")
        Files.writeString(folder.resolve("2.mtl"), "newmtl a\nKd 0 1 0\nnewmtl b\nKd 0 0 1\n")
        val text = "mtllib 1.mtl\nmtllib 2.mtl\n" + triangle + "usemtl b\nf 1 2 3\n"
        val meshes = ObjParser.parse(TestSources.of(text, folder)).meshes
        assertEquals(listOf("FFFF0000", "FF0000FF"), meshes.map { code(it.material.baseColor) })
    }

    @Test
    fun oneTextureFileIsReadOnce() {
        Files.writeString(folder.resolve("m.mtl"), "newmtl a\nmap_Kd wood.png\nnewmtl b\nmap_Kd wood.png\n")
        val text = "mtllib m.mtl\n" + triangle + "usemtl b\nf 1/1 2/2 3/3\n"
        val meshes = ObjParser.parse(TestSources.of(text, folder)).meshes
        assertSame(meshes[0].material.texture, meshes[1].material.texture)
    }

    @Test
    fun facesWithoutCoordinatesGetNoTexture() {
        Files.writeString(folder.resolve("m.mtl"), "newmtl a\nKd 1 0 0\nmap_Kd wood.png\n")
        val source = TestSources.of("mtllib m.mtl\n" + triangle + "f 1 2 3\n", folder)
        val meshes = ObjParser.parse(source).meshes
        assertEquals(listOf(true, false), meshes.map { it.material.texture != null })
        assertEquals(meshes[0].material.baseColor, meshes[1].material.baseColor)
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
