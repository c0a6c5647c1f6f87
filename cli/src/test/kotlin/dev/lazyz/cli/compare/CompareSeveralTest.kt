package dev.lazyz.cli.compare

import dev.lazyz.cli.BuggyRenderer
import dev.lazyz.cli.CapableRenderer
import dev.lazyz.cli.WrongDepthRenderer
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.emptyModel
import dev.lazyz.cli.glass
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.rendererJar
import dev.lazyz.cli.statIn
import dev.lazyz.cli.wedge
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.strategies.Renderers
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** `zcli compare` on several files, folders and views. */
class CompareSeveralTest {
    @TempDir
    lateinit var folder: Path

    private fun compare(vararg words: Any): Zrun = zcli("compare", *words, "--size", "40x30")

    private fun Zrun.lines(): List<String> = text.trimEnd().lines()

    /** A folder with files of all kinds, and the files in it that are compared, in order. */
    private fun models(): List<Path> {
        val models = folder.resolve("models")
        for (name in listOf("deep/er", "b.obj.d", ".hidden")) models.resolve(name).createDirectories()
        val names = listOf("a.obj", "b.OBJ", "b.obj.d/z.obj", "deep/er/c.obj", ".d.obj", ".hidden/e.obj")
        val files = names.map { models.wedge(it) }
        models.resolve("package.json").writeText("{\"name\": \"models\"}")
        models.resolve("readme.md").writeText("models")
        models.glass()
        return listOf(files[0], files[1], files[2], files[3], models.resolve("glass.json"))
    }

    @Test
    fun namesMayHaveEndsOfLinesAndPercentSigns() {
        val good = folder.wedge("a%n\nb.obj")
        val bad = folder.wedge("c\nd.obj").apply { writeText("v 1") }
        val lines = compare(good, bad, "e\nf.obj").lines()
        val starts = listOf(
            "ok       $folder/a%n?b.obj: 4 primitives",
            "error    $folder/c?d.obj, line 1",
            "error    e?f.obj: no such file",
        )
        assertEquals(4, lines.size) { "$lines" }
        for ((line, start) in lines.zip(starts)) assertTrue(line.startsWith(start)) { line }
        val json = compare(good, "teapot", "--json").text
        assertTrue("a%n\\nb.obj" in json) { json }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun foldersAreWalkedInOrder() {
        val files = models()
        val run = compare(folder.resolve("models"), "teapot").done()
        val names = run.lines().dropLast(1).map { it.drop(9).substringBefore(": ") }
        assertEquals(files.map { it.toString() } + "teapot", names)
        assertTrue(run.lines().dropLast(1).all { it.startsWith("ok       ") }, run.text)
        assertTrue(run.lines()[0].endsWith("a.obj: 4 primitives"), run.text)
        assertTrue(Regex("glass.json: \\d+ primitives, translucent: \\d strategies left out") in run.text, run.text)
        assertEquals("6 inputs: 6 ok, 0 differ, 0 failed, 0 errors; 6 pictures, 0 of them blank", run.lines().last())
        assertEquals(files.take(4).size + 1, compare(folder.resolve("models"), "--format", "obj").done().lines().size)
    }

    /** Two links to the own folder make exponentially many paths. */
    @Test
    fun linksToFoldersAreNotFollowedInFolders() {
        val two = folder.resolve("two").createDirectories()
        val wedge = two.wedge()
        listOf("l1", "l2").forEach { two.resolve(it).createSymbolicLinkPointingTo(Path.of(".")) }
        val link = two.resolve("z.obj").createSymbolicLinkPointingTo(wedge)
        fun names(input: Path) = compare(input).done().lines().dropLast(1).map { it.drop(9).substringBefore(": ") }
        assertEquals(listOf("$wedge", "$link"), names(two))

        // A link that is an input itself is followed
        val other = folder.resolve("other").createSymbolicLinkPointingTo(two)
        assertEquals(listOf("$other/wedge.obj", "$other/z.obj"), names(other))
    }

    @Test
    fun jsonLinesAreThoseOfSingleComparisons() {
        fun timeless(line: String) = line.replace(Regex("\"millis\":[0-9.]+"), "")
        val words = listOf("--strategy", "zbuffer", "--strategy", "lazy", "--json").toTypedArray()
        val wedge = folder.wedge()
        val lines = compare(wedge, "city", *words).done().lines()
        val single = listOf(wedge, "city").map { compare(it, *words).done().lines().single() }
        assertEquals(single.map { timeless(it) }, lines.dropLast(1).map { timeless(it) })
        val sums = """{"inputs":2,"ok":2,"error":0,"failed":0,"differs":0,"pictures":2,"blank":0}"""
        assertEquals(sums, lines.last())
    }

    @Test
    fun viewsAreThoseOfSingleComparisons() {
        val wedge = folder.wedge()
        val lines = compare(wedge, "--views", "iso,front,back", "--json").done().lines()
        val sides = listOf("iso", "front", "back")
        assertEquals(sides, lines.dropLast(1).map { statIn(it, "view") })
        val hashes = sides.map { compare(wedge, "--view", it, "--json").done().stat("pixelHash") }
        assertEquals(3, hashes.distinct().size)
        assertEquals(hashes, lines.dropLast(1).map { statIn(it, "pixelHash") })
        assertEquals(hashes[1], compare(wedge, "--views", "front", "--json").done().stat("pixelHash"))
        assertTrue("| tiled" in compare(wedge, "--views", "front").done().text)
    }

    @Test
    fun badInputsAreReportedAndDoNotStopTheOthers() {
        val broken = folder.resolve("broken.obj").apply { writeText("v 0 0\nf 1 2 3\n") }
        val none = folder.resolve("none.obj")
        val empty = folder.resolve("empty").createDirectories()
        val run = compare(broken, none, empty, "teapto", "teapot")
        assertEquals(ExitCode.MISTAKE, run.code)
        val lines = run.lines()

        // They are errors, so they go to standard error, too
        val errors = lines.filter { it.startsWith("error") }.map { "zcli: error: ${it.substringAfter("error    ")}" }
        assertEquals(errors, run.errors.lines().filter { it.startsWith("zcli: error: ") })
        assertEquals(List(4) { "error" } + "ok" + "5", lines.map { it.substringBefore(" ") })
        assertTrue(lines[0].startsWith("error    $broken, line 1: "), run.text)
        assertEquals("error    $none: no such file", lines[1])
        assertTrue(lines[3].endsWith("'teapto'; did you mean 'teapot'?"), run.text)
        val json = compare(none, "teapot", "--json").lines()
        assertEquals("{\"input\":\"$none\",\"message\":\"$none: no such file\"}", json[0])
        assertEquals("zcli: error: $none: no such file\n", compare(none, "teapot", "--json").errors)
        assertEquals(listOf("1", "1"), listOf("error", "ok").map { statIn(json.last(), it) })
    }

    @Test
    fun nothingVisibleIsReported() {
        val blank = folder.emptyModel()
        val run = compare(blank, "teapot").done()
        assertEquals("ok       $blank: 0 primitives, nothing to see", run.lines()[0])
        assertTrue(run.text.endsWith("2 pictures, 1 of them blank\n"), run.text)
    }

    @Test
    fun differencesAndFailuresAreReported() {
        val wedge = folder.wedge()
        withRenderers(folder, WrongDepthRenderer::class.java.name) {
            val run = compare(wedge, folder.resolve("none.obj"), "--views", "top,iso")
            assertEquals(ExitCode.DIFFERENT, run.code)
            assertEquals("zcli: error: ${folder.resolve("none.obj")}: no such file\n", run.errors)
            val line = "differs  $wedge: top: wrong-depth differs from tiled at 1 of 1,200 pixels, " +
                "first at column 20, row 15"
            assertEquals(line, run.lines()[0])
            assertTrue("2 inputs: 0 ok, 1 differs, 0 failed, 1 error; 2 pictures" in run.text, run.text)
            val json = compare(wedge, "teapot", "--json")
            assertEquals(listOf("false", "false"), json.lines().dropLast(1).map { statIn(it, "identical") })
        }
        withRenderers(folder, BuggyRenderer::class.java.name) {
            val run = compare(wedge, "teapot")
            assertEquals(ExitCode.DIFFERENT to "", run.code to run.errors)
            assertEquals("failed   $wedge: buggy failed: IllegalStateException: the cursor ran away", run.lines()[0])
        }
    }

    @Test
    fun mistakesOfTheCommandLineAreFoundFirst() {
        val wedge = folder.wedge()
        compare(wedge, "city", "--strategy", "zbufer").mistake("did you mean 'zbuffer'?")
        compare(wedge, "city", "--views", "iso,fornt").mistake("'fornt' is not one of", "did you mean 'front'?")
        compare(wedge, "--views", "iso,front", "--view", "back").mistake("--views cannot be combined with --view")
        compare(wedge, "--views", "iso", "--azimuth", "3").mistake("--views cannot be combined with")
        compare("-", wedge, "-", "--format", "obj").mistake("standard input can be only one of the inputs")
        zcli("compare").mistake("missing argument INPUT")
    }

    @Test
    fun strategiesOfAJarAreComparedAndRender() {
        val jar = folder.rendererJar(CapableRenderer::class.java, WrongDepthRenderer::class.java)
        val wedge = folder.wedge()
        val one = compare(wedge, "--classpath", jar, "--json")
        assertEquals(ExitCode.DIFFERENT, one.code)
        assertTrue("\"strategy\":\"capable\",\"outcome\":\"identical\"" in one.text, one.text)
        assertTrue("\"strategy\":\"wrong-depth\",\"outcome\":\"different\"" in one.text, one.text)
        assertEquals(ExitCode.DIFFERENT, compare(wedge, "city", "--classpath", jar).code)
        assertEquals(Renderers.builtIn.size, Regex("\"outcome\"").findAll(compare(wedge, "--json").done().text).count())

        val picture = arrayOf<Any>("render", wedge, "-o", "-", "--size", "40x30", "--aa", "1")
        val words = arrayOf(*picture, "--stats=json", "--strategy", "capable")
        val render = zcli(*words, "--classpath", jar)
        assertEquals("capable", statIn(render.errors, "strategy"))
        assertEquals(one.stat("pixelHash"), statIn(render.errors, "pixelHash"))
        zcli(*words).mistake("no strategy 'capable'")
        zcli(*words, "--classpath", folder.resolve("no.jar")).mistake("--classpath", "no such file")
    }
}
