package dev.lazyz.cli.report

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.cli.BuggyRenderer
import dev.lazyz.cli.WrongColorRenderer
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.argb
import dev.lazyz.cli.glass
import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.page.Html
import dev.lazyz.cli.page.Html.Companion.elements
import dev.lazyz.cli.wedge
import dev.lazyz.cli.withRenderers
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.aov.AovPicture
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Correct only the first time. */
class WrongLaterRenderer : Renderer {
    override val id: String get() = "wrong-later"

    override val summary: String get() = "is right once"

    override fun render(frame: Frame, sink: RowSink): Counters =
        (if (runs++ == 0) ZBufferRenderer() else WrongColorRenderer()).render(frame, sink)

    companion object {
        var runs = 0
    }
}

/** `zcli report` writes what `zcli compare`, `zcli trace` and `zcli render --aov` know. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class ReportTest {
    @TempDir
    lateinit var folder: Path

    private val builtIn = Renderers.builtIn.map { it.id }
    private val file: Path get() = folder.resolve("report.html")

    private fun report(input: Any, vararg options: Any): Zrun =
        zcli("report", input, "-o", file, "--size", "40x30", "--repeat", "1", *options)

    private fun page() = Html(file.readText()).also { it.requireSelfContained() }

    @Test
    fun theProofIsTheFirstLine() {
        val run = report("city").done()
        val stats =
            zcli("render", "city", "--size", "40x30", "--aa", "1", "-o", folder.resolve("r.png"), "--stats=json")
        val hash = stats.stat("pixelHash")
        val one = arrayOf<Any>("--size", 1, "--strategy", "lazy", "--repeat", 1)
        val only = zcli("report", "plane", "-o", folder.resolve("one.html"), *one).done().text
        assertTrue(only.startsWith("Only one strategy, so nothing was compared; 1 pixel, pixel hash "), only)
        assertTrue("plane: one picture, 1 order of evaluation<" in folder.resolve("one.html").readText())
        val proof = "Identical: all ${builtIn.size} strategies give the same bits at all 1,200 pixels, pixel hash $hash"
        assertEquals("$proof\n", run.text)
        val page = page()
        assertTrue("<strong>✓ $proof</strong>" in page.text)
        val identical = Regex("""<h3>[\w-]+ <span class="badge good">identical""")
        assertEquals(builtIn.size, identical.findAll(page.text).count())
        assertFalse("<script" in page.text)

        // All pictures are one, and it is that of render
        val own = builtIn.map { page.shown.getValue("Picture of $it, the same as that of the others") }
        assertEquals(1, own.toSet().size)
        assertEquals(folder.resolve("r.png").image.argb(), page.pictures.getValue(own[0]).argb())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun numbersAreThoseOfTheOtherCommands() {
        report("city").done()
        val page = page()
        val heads = page.rows.getValue("Strategy")
        assertEquals(listOf("Picture") + ReportMeasure.entries.map { it.title }, heads)
        val options = arrayOf("city", "--size", "40x30")
        for (id in listOf("zbuffer", "painter", "lazy")) {
            val row = heads.zip(page.rows.getValue(id)).toMap()
            assertEquals("identical", row["Picture"])
            val json = zcli("compare", *options, "--strategy", id, "--json").done()
            for ((title, key) in mapOf("Shading calls" to "shadingCalls", "Fragments" to "fragments")) {
                assertEquals("%,d".format(null, json.stat(key).toLong()), row[title], "$id: $key")
            }
            val trace = zcli("trace", *options, "--strategy", id, "-o", folder.resolve("t.gif")).done().text
            assertTrue("${row["Shading calls"]} shading calls, ${row["Discarded calls"]} of them" in trace, trace)
        }
        assertTrue(page.rows.getValue("zbuffer") != page.rows.getValue("lazy"))
        val ratios = builtIn.map { page.rows.getValue(it)[heads.indexOf("Time")] }
        assertTrue(ratios.all { Regex("""\d+\.\d\d ×""").matches(it) } && "1.00 ×" in ratios, "$ratios")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun chartsShowTheTable() {
        report("city").done()
        val page = page()
        val heads = page.rows.getValue("Strategy")
        assertTrue(page.charts.keys.containsAll(listOf("Shading calls", "Depth evaluations", "Memory held", "Time")))
        for ((title, chart) in page.charts) {
            val texts = chart.getElementsByTagName("text").elements.map { it.textContent }
            val table = builtIn.flatMap { listOf(it, page.rows.getValue(it)[heads.indexOf(title)]) }
            assertEquals(table, texts, title)
            for (text in texts) assertTrue(text in chart.getAttribute("aria-label"), "$title: $text")
        }
        val parts = page.charts.getValue("Shading calls").getElementsByTagName("rect").elements
            .count { it.getAttribute("class") == "part" }
        assertEquals(2, parts, "zbuffer and painter discard")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun mapsShowWhereAndWhen() {
        report("city").done()
        val page = page()
        val picture = { prefix: String ->
            val found = page.shown.filterKeys { it.startsWith(prefix) }
            assertEquals(1, found.size, "$prefix: ${page.shown.keys}")
            page.pictures.getValue(found.values.single()).argb()
        }
        val calls = picture("Shading calls of lazy:")
        assertEquals(2, calls.toSet().size, "grey, and one call")
        val covered = calls.map { it != AovPicture.NOTHING }
        assertTrue(covered.any { it } && covered.any { !it })
        assertTrue(picture("Shading calls of painter:").toSet().size > 3)
        assertTrue(Rgba.viridis(1.0).toArgb() in picture("Overdraw: "))
        val words = Regex("Overdraw: [0-9.]+ surfaces on average, up to [0-9.]+ at a pixel")
        assertTrue(page.shown.keys.any { words.matches(it) }) { "${page.shown.keys}" }

        // Row by row: each covered pixel is lighter than those before it
        val order = picture("Order in which lazy shades")
        assertEquals(covered, order.map { it != AovPicture.NOTHING })
        val colors = order.filter { it != AovPicture.NOTHING }
        assertEquals(
            listOf(Rgba.viridis(0.0).toArgb(), Rgba.viridis(1.0).toArgb()),
            listOf(colors.first(), colors.last()),
        )
        assertEquals(colors.map { it shr 8 and 0xFF }.sorted(), colors.map { it shr 8 and 0xFF })
        assertTrue(picture("Order in which painter shades") != order)
    }

    @Test
    fun whoDoesNotBlendHasACardWithTheReason() {
        val run = report(folder.glass()).done()
        val able = Renderers.builtIn.filter { Capability.TRANSPARENCY in it.capabilities }.map { it.id }
        val others = builtIn.size - able.size
        assertTrue(run.text.startsWith("Identical: all ${able.size} strategies give"), run.text)
        assertTrue("; $others cannot blend translucent surfaces\n" in run.text, run.text)
        val page = page()
        assertEquals("does not blend", page.rows.getValue("zbuffer")[0])
        assertEquals("no numbers", page.rows.getValue("zbuffer")[1])
        val sentence = Regex("<p>The scene is translucent, and this strategy does not")
        assertEquals(others, sentence.findAll(page.text).count())
        assertTrue("zbuffer does not blend" in page.charts.getValue("Time").getAttribute("aria-label"))
        assertTrue("Picture of lists, the same as that of the others" in page.shown)
    }

    @Test
    fun aDifferenceIsShownAndTheExitCodeSaysSo() = withRenderers(folder, WrongColorRenderer::class.java.name) {
        val run = report("teapot")
        assertEquals(ExitCode.DIFFERENT to "", run.code to run.errors)
        val all = builtIn.size
        assertTrue(run.text.startsWith("Not identical: $all of ${all + 1} strategies give"), run.text)
        val page = page()
        assertEquals("different", page.rows.getValue("wrong-color")[0])
        assertTrue("wrong-color differs from tiled at 1 of 1,200 pixels, first at column 20, row 15" in page.text)
        val (own, right) = listOf("wrong-color, not that", "lazy, the same as that").map {
            page.pictures.getValue(page.shown.getValue("Picture of $it of the others")).argb()
        }
        assertEquals(listOf(15 * 40 + 20), own.indices.filter { own[it] != right[it] })
        assertTrue("Pixels of wrong-color that differ, yellow to red" in page.shown)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aDifferenceThatComesAndGoesIsOne() = withRenderers(folder, WrongLaterRenderer::class.java.name) {
        // The first picture is right, and the one on the page is not
        assertEquals(ExitCode.DIFFERENT, report("teapot", "--strategy", "lazy", "--strategy", "wrong-later").code)
        assertEquals("different", page().rows.getValue("wrong-later")[0])
        assertTrue("it is not the same each time" in page().text)
    }

    @Test
    fun aFailureIsReportedAndTheOthersAreThere() = withRenderers(folder, BuggyRenderer::class.java.name) {
        val run = report("teapot", "--strategy", "buggy", "--strategy", "lazy", "--strategy", "zbuffer")
        assertEquals(ExitCode.DIFFERENT to "", run.code to run.errors)
        assertTrue("Not identical: 2 of 3" in run.text, run.text)
        assertTrue("<p>IllegalStateException: the cursor ran away</p>" in page().text)
        assertEquals(listOf("failed", "identical"), listOf("buggy", "lazy").map { page().rows.getValue(it)[0] })
        assertEquals(ExitCode.DIFFERENT, report("teapot", "--strategy", "buggy").code)
        assertTrue("0 of 1 strategies" in file.readText() && "pixel hash none" in file.readText())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun withSeveralSamplesAPixelOrdersAreLeftOut() {
        report("teapot", "--aa", "2", "--strategy", "zbuffer", "--strategy", "lazy").done()
        val page = page()
        assertEquals(listOf("zbuffer", "lazy"), page.rows.keys.filter { it in builtIn })
        assertEquals("not counted", page.rows.getValue("zbuffer")[2])
        assertTrue("<dd>2 × 2 a pixel, with anti-aliasing</dd>" in page.text)
        assertFalse(page.shown.keys.any { it.startsWith("Order") })
        assertTrue(page.shown.keys.any { it.startsWith("Shading calls of lazy") })
    }

    @Test
    fun namesAreEscapedAndTheCommandIsReported() {
        val input = folder.wedge("a<b>&'c.obj")
        report(input, "--view", "top").done()
        val page = page()
        assertTrue("<h1>$folder/a&lt;b&gt;&amp;&#39;c.obj: one picture" in page.text)
        assertFalse("<b>&'c" in page.text)
        val word = "&#39;$folder/a&lt;b&gt;&amp;&#39;\\&#39;&#39;c.obj&#39;"
        assertTrue("zcli report $word --size 40x30 --repeat 1 --view top -o report.html</code>" in page.text)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun visiblePartsAreNamed() {
        val input = folder.resolve("parts.obj")
        val corners = "v -3 0 0\nv -1 0 0\nv -1 2 0\nv 1 0 0\nv 2 0 0\nv 2 1 0\nv 0 9 -9\nv 0 9 -8\n"
        input.writeText("${corners}o car\nf 1 2 3\ng <wheel>\nf 4 5 6\n")
        report(input, "--view", "front").done()
        val parts = Regex("<dt>Parts</dt><dd>(.*)</dd>").find(page().text)!!.groupValues[1]
        assertTrue(Regex("""car \d+\.\d %, car/&lt;wheel&gt; \d+\.\d %""").matches(parts)) { parts }
        report("teapot").done()
        assertFalse("<dt>Parts" in page().text)
    }

    @Test
    fun mistakesLeaveNoFile() {
        val wedge = folder.wedge()
        zcli("report", wedge).mistake("missing option --output")
        zcli("report", wedge, "-o", folder.resolve("a.pdf")).mistake("-o must be a page, NAME.html, or a folder")
        zcli("report", wedge, "-o", folder.resolve("no/a.html")).mistake("there is no folder")
        report(wedge, "--strategy", "lazy", "--strategy", "zbufer").mistake("did you mean 'zbuffer'?")
        report(wedge, "--repeat", "0").mistake("--repeat: must be in 1..1000: 0")
        report(wedge, "--strategy", "zbuffer", "--threads", "2").mistake("no compared strategy supports --threads")
        report(folder.glass(), "--strategy", "zbuffer").mistake("no compared strategy blends", "--opaque")
        report(folder.resolve("none.obj")).mistake("none.obj: no such file")
        zcli("report", wedge, "-o", file, "--size", "262144").mistake("choose a smaller --size")
        assertFalse(file.exists())
        val input = folder.wedge("model.html")
        val before = input.readText()
        zcli("report", input, "--format", "obj", "-o", input).mistake("-o would replace an input")
        assertEquals(before, input.readText())
    }

    /** As `--report` of `zcli conformance`. */
    @Test
    fun aFolderGetsThePage() {
        val words = arrayOf("report", folder.wedge(), "--size", "8x8", "--repeat", "1", "--strategy", "lazy", "-o")
        for (place in listOf(folder, folder.resolve("new/report-1.2"))) {
            zcli(*words, place).done()
            assertTrue("</html>" in place.resolve("report.html").readText(), "$place")
        }
    }
}
