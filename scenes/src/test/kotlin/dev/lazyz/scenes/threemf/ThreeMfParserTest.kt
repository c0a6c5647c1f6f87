package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.FormatSniffer
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.threemf.ThreeMfFiles.TRIANGLE
import dev.lazyz.scenes.threemf.ThreeMfFiles.model
import dev.lazyz.world.surface.Mesh
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ThreeMfParserTest {
    private fun meshes(bytes: ByteArray, vararg warnings: String): List<Mesh> {
        val source = TestSources.of(bytes)
        val meshes = ThreeMfParser.parse(source).meshes
        assertEquals(warnings.map { "test: $it" }, source.warnings)
        return meshes
    }

    private fun meshes(resources: String, build: String, vararg warnings: String) =
        meshes(ThreeMfFiles.of(model(resources, build)), *warnings)

    private fun item(id: Int, transform: String? = null) =
        "<item objectid=\"$id\"" + (transform?.let { " transform=\"$it\"" } ?: "") + "/>"

    private fun component(id: Int, transform: String) = "<component objectid=\"$id\" transform=\"$transform\"/>"

    private val one = "<object id=\"1\" name=\"one\">$TRIANGLE</object>"

    @Test
    fun itemsAreShownWithNormals() {
        val bytes = ThreeMfFiles.of(model(one, item(1)))
        assertEquals(SceneFormat.THREE_MF, FormatSniffer.format(bytes))
        val mesh = meshes(bytes).single()
        assertEquals(listOf(listOf(0f, 0f, 0f), listOf(1f, 0f, 0f), listOf(0f, 1f, 0f)), mesh.corners())
        assertEquals(listOf(0f, 0f, 1f), mesh.normals!!.take(3))
        assertEquals("one", mesh.material.name)
    }

    @Test
    fun lengthsHaveTheUnitOfTheFile() {
        fun unit(model: String) = TestSources.of(ThreeMfFiles.of(model)).also { ThreeMfParser.parse(it) }.unit
        val own = model(one, item(1))
        assertEquals(LengthUnit.MILLIMETRE, unit(own))
        assertEquals(LengthUnit.INCH, unit(own.replace("millimeter", "inch")))
        assertEquals(LengthUnit.MILLIMETRE, unit(own.replace("millimeter", "parsec")))
    }

    @Test
    fun transformsMultiplyRows() {
        // x goes to y, y to twice z, and all move by 10, 20, 30
        val mesh = meshes(one, item(1, "0 1 0  0 0 2  1 0 0 10 20 30")).single()
        assertEquals(listOf(listOf(10f, 20f, 30f), listOf(10f, 21f, 30f), listOf(10f, 20f, 32f)), mesh.corners())
    }

    @Test
    fun componentsMoveWithWhatTheyArePartsOf() {
        val two = "<object id=\"2\"><components>" + component(1, "1 0 0 0 1 0 0 0 1 1 0 0") +
            component(1, "2 0 0 0 2 0 0 0 2 0 0 0") + "</components></object>"
        val three =
            "<object id=\"3\"><components>" + component(2, "0 1 0 -1 0 0 0 0 1 0 0 0") + "</components></object>"
        val meshes = meshes(one + two + three, item(3, "1 0 0 0 1 0 0 0 1 0 0 5") + item(1))
        val firsts = meshes.map { it.corners()[1] }
        assertEquals(listOf(listOf(0f, 2f, 5f), listOf(0f, 2f, 5f), listOf(1f, 0f, 0f)), firsts)
        assertEquals(listOf(0f, 1f, 5f), meshes[0].corners()[0])
    }

    @Test
    fun objectsHaveThePathOfWhatTheyArePartsOf() {
        val same = "1 0 0 0 1 0 0 0 1 0 0 0"
        val two = "<object id=\"2\"><components>" + component(1, same) + "</components></object>"
        val car = "<object id=\"3\" name=\"car\"><components>" + component(1, same) + component(2, same) +
            "</components></object>"
        val meshes = meshes(one + two + car, item(3) + item(1))
        assertEquals(listOf("car/one", "car/one", "one"), meshes.map { it.name })
    }

    @Test
    fun objectsOfOtherPartsAreFollowed() {
        val seven = "<object id=\"7\"><components><component objectid=\"1\"/></components></object>"
        val part = model(seven + one, "").toByteArray()
        val two = "<object id=\"1\"><components><component p:path=\"/3D/Objects/a b.model\" objectid=\"7\"/>" +
            "</components></object>"
        val build = item(1) + "<item p:path=\"/3d/objects/A B.model\" objectid=\"1\" printable=\"0\"/>"
        assertEquals(2, meshes(ThreeMfFiles.of(model(two, build), "3D/Objects/a b.model" to part)).size)
    }

    @Test
    fun whatIsNotShownIsReported() {
        val support = one.replace("id=\"1\"", "id=\"2\" type=\"support\"")
        val beams = "<b:beamlattice xmlns:b=\"b\"><b:beams><b:beam/><b:beam/></b:beams></b:beamlattice>"
        val lattice = "<object id=\"3\"><mesh><vertices/><triangles/>$beams</mesh></object>"
        val painted = one.replace("id=\"1\"", "id=\"4\"").replace("v1", "paint_color=\"8\" v1")
        val resources = one + support + lattice + painted + "<s:slicestack xmlns:s=\"s\"><s:slice/></s:slicestack>"
        val meshes = meshes(
            resources,
            item(1) + item(2) + item(3) + item(2) + item(4),
            "2 support structures are not shown",
            "what is not shown: 2 beams, 1 painted triangles, 1 slicestack",
        )
        assertEquals(2, meshes.size)
    }

    @Test
    fun textMayBeInOtherEncodings() {
        for (charset in listOf(Charsets.UTF_16LE, Charsets.UTF_16BE, Charsets.UTF_8)) {
            for (mark in listOf("", "\uFEFF")) {
                val text = mark + model(one.replace("one", "größe"), item(1)).replace("UTF-8", charset.name())
                val zip = ThreeMfFiles.zip("a.model" to text.toByteArray(charset))
                assertEquals("größe", meshes(zip).single().material.name, "$charset")
            }
        }
    }
}
