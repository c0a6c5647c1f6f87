package dev.lazyz.cli.diff

import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.page.Html
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.cli.zcliReading
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `zcli diff` of models: what changed, in pictures and numbers. */
class ModelDiffTest {
    @TempDir
    lateinit var folder: Path

    private lateinit var old: Path
    private lateinit var new: Path
    private val size = arrayOf("--size", "40x30")

    @BeforeEach
    fun models() {
        old = folder.wedge("old.obj")
        new = folder.resolve("new.obj")
        new.writeText(old.readText().replace("v 0 2 0", "v 0 3 0") + "o <more>\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 5 6 7\n")
    }

    @Test
    fun equalModelsAreEqual() {
        val copy = folder.wedge("copy.obj")
        val text = zcli("diff", old, copy, *size).done().text
        assertTrue(text.startsWith("$copy is equal to $old\npixels: 1,200 same, 0 added, 0 removed, 0 moved"), text)
        assertTrue(Regex("volume +1.333333 +1.333333 +0\n").containsMatchIn(text), text)
        zcli("diff", "teapot", "teapot", *size).done()
    }

    @Test
    fun whatChangedIsPrinted() {
        val run = zcli("diff", old, new, *size)
        assertEquals(ExitCode.DIFFERENT, run.code)
        assertEquals("", run.errors)
        val lines = run.text.lines()
        assertEquals("$new differs from $old", lines[0])
        assertTrue(Regex("max y +2 +3 +\\+1").matches(lines.first { it.startsWith("max y") }), run.text)
        assertTrue(Regex("volume +1.333333 +- +-").matches(lines.first { it.startsWith("volume") }), run.text)
        assertTrue(lines.any { it.startsWith("changed part: unnamed, volume 1.333333 to 2, area ") }, run.text)
        assertTrue("added part: <more>" in lines, run.text)

        val json = Json.parseToJsonElement(zcli("diff", old, new, "--json", *size).text).jsonObject
        assertEquals("$old", json.getValue("old").jsonObject.getValue("file").jsonPrimitive.content)
        assertEquals("false", json.getValue("equal").jsonPrimitive.content)
        assertEquals("[2.0,3.0,1.0]", json.getValue("numbers").jsonObject.getValue("maxY").toString())
        assertEquals("[4,5,1]", json.getValue("numbers").jsonObject.getValue("triangles").toString())
        assertEquals("[null,0.5,null]", number(json, 1, "area"))
        assertEquals(1200, json.getValue("pixels").jsonObject.values.sumOf { it.jsonPrimitive.content.toInt() })
    }

    private fun number(json: JsonObject, part: Int, name: String): String = json.getValue("parts").jsonArray[part]
        .jsonObject.getValue("numbers").jsonObject.getValue(name).toString()

    @Test
    fun picturesAreThoseOfOneCamera() {
        val place = folder.resolve("changes")
        val marked = folder.resolve("marked.png")
        val run = zcli("diff", old, new, "-o", place, "--diff", marked, "--print-camera", "--opaque", *size)
        assertEquals(ExitCode.DIFFERENT, run.code)
        val cameras = run.errors.lines().filter { "--eye" in it }.map { it.substringAfter(": ") }.toSet()
        assertEquals(1, cameras.size, run.errors)
        val camera = cameras.single().split(' ').toTypedArray()
        for ((model, name) in listOf(old to "before", new to "after")) {
            val alone = folder.resolve("alone.png")
            zcli("render", model, *camera, *size, "-o", alone).done()
            zcli("diff", alone, place.resolve("$name.png")).done()
        }
        assertEquals(40, marked.image.width)
        zcli("diff", marked, place.resolve("difference.png")).done()

        val page = Html(place.resolve("report.html").readText())
        page.requireSelfContained()
        assertEquals(3, page.pictures.size)
        assertEquals("added", page.rows.getValue("&lt;more&gt;").first())
        val alone = folder.resolve("alone.html")
        zcli("diff", old, new, "-o", alone, *size)
        assertEquals(place.resolve("report.html").readText(), alone.readText())
    }

    @Test
    fun wrongInputIsAMistake() {
        zcli("diff", old, folder.resolve("no.stl")).mistake("no.stl: no such file")
        zcli("diff", old, new, "--threshold", "1").mistake("--threshold is for pictures")
        zcli("diff", old, new, "--diff", old).mistake("--diff must end in .png")
        zcli("diff", old, new, "-o", folder.resolve("a.png")).mistake("-o must be a page")
        zcli("diff", old, new, "--memory-budget", "64k").mistake("'tiled', which does not support --memory-budget")
        zcli("diff", "-", "-", "--format", "obj").mistake("standard input can be only one of the inputs")
        zcli("diff", old, new, "--wireframe", "--edges").mistake("--wireframe contains the edges of --edges")
        val same = zcliReading(old.readText(), "diff", "-", old, "--format", "obj", *size)
        assertEquals(ExitCode.DONE, same.code, same.errors)
        val texture = folder.resolve("a.png").also { zcli("render", "teapot", "--size", "4", "-o", it).done() }
        val replaced = "--diff would replace the input of --matcap"
        zcli("diff", old, new, "--matcap", texture, "--diff", texture).mistake(replaced)
        assertFalse(folder.resolve("a.html").exists())
    }
}
