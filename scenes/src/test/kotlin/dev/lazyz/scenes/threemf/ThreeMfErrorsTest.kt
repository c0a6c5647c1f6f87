package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.threemf.ThreeMfFiles.TRIANGLE
import dev.lazyz.scenes.threemf.ThreeMfFiles.model
import dev.lazyz.scenes.zip.ZipArchive
import java.io.ByteArrayOutputStream
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class ThreeMfErrorsTest {
    private val one = "<object id=\"1\">$TRIANGLE</object>"
    private val item = "<item objectid=\"1\"/>"

    private fun assertFails(bytes: ByteArray, location: String?, part: String, limits: LoadLimits = LoadLimits()) {
        val error = TestSources.error(ThreeMfParser, Source(bytes, "test", null, Loading(LoadOptions(limits))))
        assertEquals(location, error.location, error.message)
        assertTrue(part in error.message!!, error.message)
    }

    private fun assertFails(resources: String, build: String, location: String?, part: String) =
        assertFails(ThreeMfFiles.of(model(resources, build)), location, part)

    @Test
    fun mistakesNameTheirPartAndLine() {
        val line3 = "3D/3dmodel.model, line 3"
        assertFails(one, "\n<item/>", "3D/3dmodel.model, line 5", "no objectid")
        assertFails(one, "<item objectid=\"2\"/>", "3D/3dmodel.model", "no object 2")
        assertFails(one, "<item objectid=\"1\" p:path=\"/a\"/>", "/a", "missing from the package")
        assertFails(one, "<item objectid=\"1\" transform=\"1 0 0\"/>", "3D/3dmodel.model, line 4", "12 numbers")
        assertFails(one.replace("v2=\"1\"", "v2=\"3\""), item, line3, "vertex number 3 is not one of the 3")
        assertFails(one.replace("v2=\"1\"", "v2=\"-1\""), item, line3, "\"-1\"")
        assertFails(one.replace("v2=\"1\"", ""), item, line3, "lacks v1, v2 or v3")
        assertFails(one.replace(" x=\"1\"", ""), item, line3, "lacks x, y or z")
        assertFails(one.replace(" x=\"1\"", " x=\"1,5\""), item, line3, "\"1,5\"")
        assertFails(one.replace("<object", "<objec"), item, line3, "damaged")
        assertFails(ThreeMfFiles.of("<html/>"), "3D/3dmodel.model, line 1", "not model")
    }

    @Test
    fun archivesThatAreNoModelsAreRefused() {
        assertFails("PK\u0003\u0004 and no more".toByteArray(), null, "no ZIP archive")
        assertFails(ThreeMfFiles.zip("a.txt" to ByteArray(9)), null, "no 3D model")
        val bytes = ThreeMfFiles.of(model(one, item))
        assertFails(bytes.copyOf(bytes.size - 30), null, "no ZIP archive")
        val directory = String(bytes, Charsets.ISO_8859_1).lastIndexOf("PK\u0001\u0002")
        val packed = { value: Int -> bytes.copyOf().also { it[directory + 10] = value.toByte() } }
        assertFails(packed(9), "3D/3dmodel.model", "method 9")
        assertFails(bytes.copyOf().also { it[directory + 8] = 1 }, "3D/3dmodel.model", "encrypted")
    }

    @Test
    fun sizesBeyondTheEndOfTheArchiveAreRefused() {
        // The directory's entry of a file with a long name becomes one with a short name and an extra field, which has
        // the largest size of 64 bits
        val bytes = ThreeMfFiles.stored("a" + "-".repeat(12) to ByteArray(9))
        val directory = String(bytes, Charsets.ISO_8859_1).lastIndexOf("PK\u0001\u0002")
        ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putInt(directory + 20, -1)
            .putShort(directory + 28, 1).putShort(directory + 30, 12)
            .putShort(directory + 47, 1).putShort(directory + 49, 8).putLong(directory + 51, Long.MAX_VALUE)
        val archive = ZipArchive(Source(bytes, "test", null, Loading(LoadOptions())))
        val error = assertThrows(SceneFormatException::class.java) { archive.open("a") }
        assertTrue("damaged" in error.message!!, error.message)
    }

    @Test
    fun cyclesAndDeepNestingAreRefused() {
        fun holder(id: Int, vararg parts: Int) = "<object id=\"$id\"><components>" +
            parts.joinToString("") { "<component objectid=\"$it\"/>" } + "</components></object>"
        assertFails(holder(1, 2) + holder(2, 1), item, "3D/3dmodel.model", "object 1 holds itself")
        val chain = (1..70).joinToString("") { holder(it, it + 1) } + one.replace("id=\"1\"", "id=\"71\"")
        assertFails(chain, item, "3D/3dmodel.model", "more than 64 deep")
        val deep = "<a>".repeat(70) + "</a>".repeat(70)
        assertFails(deep + one, item, "3D/3dmodel.model, line 3", "more than 64 deep")

        // Thirty objects, each of which has the next ten times
        val bomb = (1..30).joinToString("") { holder(it, *IntArray(10) { _ -> it + 1 }) } + holder(31)
        val limits = LoadLimits(decodedBytes = 1_000_000)
        assertFails(ThreeMfFiles.of(model(bomb, item)), null, "decodedBytes", limits)
    }

    @Test
    fun nothingIsUnpackedBeyondTheLimits() {
        // A million to one: packed twice would be more than any memory holds
        val out = ByteArrayOutputStream()
        ZipOutputStream(out).use { zip ->
            zip.putNextEntry(ZipEntry("a.model"))
            zip.write("<model>".toByteArray())
            val spaces = ByteArray(1 shl 20) { ' '.code.toByte() }
            repeat(15) { zip.write(spaces) }
        }
        val bomb = out.toByteArray()
        assertTrue(bomb.size < 20_000)
        assertFails(bomb, null, "decodedBytes", LoadLimits(decodedBytes = 1_000_000))
        assertFails(bomb, "a.model, line 1", "damaged", LoadLimits(decodedBytes = 100_000_000))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whatFillsTheMemoryOfAParserIsRefused() {
        val text = ThreeMfFiles.of("<model><a b=\"" + "x".repeat(17 shl 20))
        assertFails(text, "3D/3dmodel.model", "more than 16777216 characters")
        val names = (0..10_000).joinToString("") { "<a$it/>" }
        assertFails(ThreeMfFiles.of("<model>$names</model>"), "3D/3dmodel.model, line 1", "10000 different names")
    }

    @Test
    fun entitiesAndOtherFilesAreNotFollowed() {
        val text =
            "<!DOCTYPE model [<!ENTITY a \"aaaa\"><!ENTITY b SYSTEM \"file:///etc/passwd\">]>\n" + model(one, item)
                .substringAfter("?>")
        for (name in listOf("a", "b")) {
            assertFails(ThreeMfFiles.of(text.replace(">a<", ">&$name;<")), "3D/3dmodel.model, line 1", "document type")
        }
    }

    @Test
    fun requiredExtensionsThatAreNotSupportedAreRefused() {
        val known = "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
        fun file(words: String) = ThreeMfFiles.of(
            model(one, item).replace("<model ", "<model requiredextensions=\"$words\" xmlns:k=\"$known\" "),
        )
        val line2 = "3D/3dmodel.model, line 2"
        assertFails(file("m"), line2, "the file requires the extension http://m, which is not supported")
        assertFails(file("k p"), line2, "the extension http://p, which is not supported")
        assertFails(file("q"), line2, "the required extension \"q\" is not declared")
        for (words in listOf("k", "", " ")) {
            assertEquals(1, ThreeMfParser.parse(TestSources.of(file(words))).surfaces.size, words)
        }
    }

    @Test
    fun twoObjectsWithOneIdAreRefused() {
        assertFails("$one\n$one", item, "3D/3dmodel.model, line 4", "two objects have the id 1")
    }
}
