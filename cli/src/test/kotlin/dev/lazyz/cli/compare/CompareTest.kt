package dev.lazyz.cli.compare

import dev.lazyz.Capability
import dev.lazyz.cli.BuggyRenderer
import dev.lazyz.cli.CapableRenderer
import dev.lazyz.cli.FickleRenderer
import dev.lazyz.cli.GreedyRenderer
import dev.lazyz.cli.ShortRenderer
import dev.lazyz.cli.StutteringRenderer
import dev.lazyz.cli.WrongDepthRenderer
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.glass
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.run
import dev.lazyz.cli.statIn
import dev.lazyz.cli.wedge
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Scene
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** `zcli compare` runs the strategies and compares each with the first. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class CompareTest {
    @TempDir
    lateinit var folder: Path

    private val builtIn = Renderers.builtIn.map { it.id }

    private fun compare(input: Any, vararg options: Any): Zrun = zcli("compare", input, "--size", "40x30", *options)

    /** Returns all values of [key] in the JSON, in their order. */
    private fun Zrun.stats(key: String): List<String> =
        Regex("\"$key\":(\"[^\"]*\"|[^,}]+)").findAll(text).map { it.groupValues[1].trim('"') }.toList()

    private fun Zrun.rows(): Map<String, List<String>> =
        text.lines().filter { it.startsWith("|") }.drop(1).associate { line ->
            val cells = line.trim('|').split("|").map { it.trim() }
            cells[0] to cells.drop(1)
        }

    @Test
    fun builtInStrategiesAgree() {
        val run = compare("molecule", "--json").done()
        assertEquals(builtIn, run.stats("strategy"))
        assertEquals(listOf("reference") + List(builtIn.size - 1) { "identical" }, run.stats("outcome"))
        assertEquals("true", run.stat("identical"))
        val fragments = run.stats("strategy").zip(run.stats("fragments").map { it.toLong() }).toMap()
        assertTrue(fragments.values.all { it <= fragments.getValue("zbuffer") }, "$fragments")
    }

    @Test
    fun tableHasARowForEach() {
        val run = compare(folder.wedge()).done()
        val rows = run.rows()
        assertEquals(builtIn, rows.keys.toList())
        assertEquals(listOf("(reference)") + List(builtIn.size - 1) { "yes" }, rows.values.map { it[0] })
        val json = compare(folder.wedge(), "--json").done()
        assertEquals(json.stats("shadingCalls"), rows.values.map { it[1].replace(",", "") })
        assertEquals(json.stats("depthEvaluations"), rows.values.map { it[2].replace(",", "") })
        assertTrue(run.text.lines().all { it.length <= 120 }, run.text)
    }

    @Test
    fun jsonReportsWhatRenderReports() {
        val json = compare("teapot", "--json").done()
        val render = zcli("render", "teapot", "-o", "-", "--size", "40x30", "--aa", "1", "--stats=json").errors
        val keys = listOf("input", "width", "height", "pixelHash", "primitives", "depthPasses", "peakBytes", "overdraw")
        for (key in keys) {
            assertEquals(statIn(render, key), json.stat(key), key)
        }
        assertEquals(1, json.text.count { it == '\n' })
    }

    @ParameterizedTest
    @CsvSource("color,WrongColorRenderer", "depth,WrongDepthRenderer", "primitive,WrongPrimitiveRenderer")
    fun oneWrongPixelIsFound(what: String, renderer: String) = withRenderers(folder, "dev.lazyz.cli.$renderer") {
        val run = compare("teapot")
        assertEquals(ExitCode.DIFFERENT to "", run.code to run.errors)
        assertEquals("no", run.rows().getValue("wrong-$what")[0])
        assertTrue("wrong-$what differs from tiled at 1 of 1,200 pixels, first at column 20, row 15:" in run.text)
        val reported = run.text.lines().filter { "  colour #" in it }
        assertEquals(listOf("  tiled", "  wrong-$what"), reported.map { it.substringBefore("  colour").trimEnd() })

        val json = compare("teapot", "--json")
        assertEquals(ExitCode.DIFFERENT, json.code)
        assertEquals("false" to "different", json.stat("identical") to json.stats("outcome").last())
        assertEquals("1", json.stat("differingPixels"))
        assertEquals("20" to "15", json.stat("x") to json.stat("y"))
        val keys = listOf("color", "depth", "primitive")
        assertEquals(listOf(what), keys.filter { json.stats(it)[0] != json.stats(it)[1] }, json.text)
    }

    @Test
    fun differencesAreReportedByPlaceInTheWholePicture() = withRenderers(folder, WrongDepthRenderer::class.java.name) {
        // The wrong pixel is in column 20 of the rendered region
        val json = compare("teapot", "--region", "5,10,30x10", "--json")
        assertEquals("25" to "15", json.stat("x") to json.stat("y"))
    }

    @Test
    fun theFirstChosenIsTheReference() = withRenderers(folder, WrongDepthRenderer::class.java.name) {
        val json = compare("teapot", "--strategy", "wrong-depth", "--strategy", "lazy", "--strategy", "LAZY", "--json")
        json.mistake("no strategy 'LAZY'")
        val run = compare("teapot", "--strategy", "wrong-depth", "--strategy", "lazy", "--strategy", "lazy", "--json")
        assertEquals("wrong-depth", run.stat("reference"))
        assertEquals(listOf("wrong-depth", "lazy"), run.stats("strategy"))
        assertEquals(listOf("reference", "different"), run.stats("outcome"))
        assertEquals(ExitCode.DIFFERENT, run.code)
    }

    @Test
    fun aThirdPartysFailureIsARow() = withRenderers(folder, BuggyRenderer::class.java.name) {
        val run = compare("teapot", "--strategy", "buggy", "--strategy", "zbuffer", "--strategy", "lazy")
        assertEquals(ExitCode.DIFFERENT to "", run.code to run.errors)
        assertEquals(listOf("failed: IllegalStateException: the cursor ran away"), run.rows().getValue("buggy"))
        assertEquals(listOf("(reference)", "yes"), listOf("zbuffer", "lazy").map { run.rows().getValue(it)[0] })
        val json = compare("teapot", "--strategy", "buggy", "--strategy", "zbuffer", "--json")
        assertEquals("failed", json.stat("outcome"))
        assertEquals("IllegalStateException: the cursor ran away", json.stat("message"))
        assertEquals("zbuffer", json.stat("reference"))
    }

    @Test
    fun noReferenceIsLeftIfAllFail() = withRenderers(folder, GreedyRenderer::class.java.name) {
        val json = compare("teapot", "--strategy", "greedy", "--json")
        assertEquals(ExitCode.DIFFERENT to "null", json.code to json.stat("reference"))
        assertTrue("out of memory" in json.stat("message"), json.text)
    }

    @Test
    fun lostAndRepeatedRowsAreFound() =
        withRenderers(folder, ShortRenderer::class.java.name, StutteringRenderer::class.java.name) {
            val rows = compare("teapot").rows()
            assertEquals(listOf("failed: IllegalStateException: 20 of 30 rows arrived"), rows["short"])
            assertEquals(listOf("failed: IllegalStateException: row 7 arrived instead of row 8"), rows["stuttering"])
        }

    @Test
    fun onlyOurOwnFailuresAreOurBugs() {
        val frame = PictureSettings(4, 3).frame(LoadedScene(Scene(emptyList()), emptyList()))
        val ours = IllegalStateException("the cursor ran away")
        val outcomes = listOf("lazy" to ours, "buggy" to RuntimeException(), "zbuffer" to OutOfMemoryError())
            .map { (id, failure) -> id to Outcome.Failed(failure) }
        val comparison = Comparison("x", null, frame, 1, 0, null, outcomes)
        assertEquals(listOf<Throwable>(ours), comparison.bugs)
        assertFalse(comparison.isGood)
    }

    @Test
    fun whoDoesNotBlendSaysSo() {
        val run = compare(folder.glass()).done()
        for (strategy in Renderers.builtIn) {
            val blends = Capability.TRANSPARENCY in strategy.capabilities
            if (!blends) assertEquals(listOf("does not blend"), run.rows().getValue(strategy.id))
        }
        val first = Renderers.builtIn.first { Capability.TRANSPARENCY in it.capabilities }
        assertEquals("(reference)", run.rows().getValue(first.id)[0])
        assertTrue("not blending" in compare(folder.glass(), "--json").done().stats("outcome"))
        val opaque = compare(folder.glass(), "--opaque", "--json").done()
        assertEquals(listOf("reference") + List(builtIn.size - 1) { "identical" }, opaque.stats("outcome"))
    }

    @Test
    fun costFlagsReachWhoeverHeedsThem() = withRenderers(folder, CapableRenderer::class.java.name) {
        val run = compare("teapot", "--threads", "3", "--memory-budget", "1k", "--tile-size", "16", "--json").done()
        assertEquals(builtIn + "capable", run.stats("strategy"))
        val asked = checkNotNull(CapableRenderer.asked)
        assertEquals(listOf<Any?>(3, 1024L, 16), listOf<Any?>(asked.threads, asked.memoryBudget, asked.tileSize))
    }

    @Test
    fun everyRepetitionIsCompared() = withRenderers(folder, FickleRenderer::class.java.name) {
        val options = arrayOf("--strategy", "fickle", "--json", "--repeat")
        assertEquals(ExitCode.DONE, compare("teapot", *options, "1").code)
        val run = compare("teapot", *options, "2")
        assertEquals(ExitCode.DIFFERENT to "different", run.code to run.stat("outcome"))
    }

    @Test
    fun mistakes() {
        val wedge = folder.wedge()
        compare(wedge, "--repeat", "0").mistake("--repeat: must be in 1..1000: 0")
        compare(wedge, "--repeat", "x").mistake("'x' is not a whole number")
        compare(wedge, "--strategy", "zbufer").mistake("did you mean 'zbuffer'?")
        compare(wedge, "--strategy", "zbuffer", "--threads", "2").mistake("no compared strategy supports --threads")
        compare(wedge, "--select", "count").mistake("no such option --select")
        compare(wedge, "-o", "x.png").mistake("no such option -o")
        compare(wedge, "--region", "0,0,41x1").mistake("reaches beyond the whole picture, which is 40x30")
        compare(wedge, "--size", "262144x262144").mistake("68719476736 pixels", "choose a smaller --size or a --region")
        compare(folder.glass(), "--strategy", "zbuffer").mistake("no compared strategy blends (tiled", "--opaque")
        compare(folder.resolve("none.obj")).mistake("none.obj: no such file")
        zcli("compare", "teapto").mistake("did you mean 'teapot'?")
        assertEquals(listOf("glass.json", "wedge.obj"), folder.listDirectoryEntries().map { it.name }.sorted())
    }
}
