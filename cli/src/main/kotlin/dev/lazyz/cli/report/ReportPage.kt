package dev.lazyz.cli.report

import dev.lazyz.cli.output.Version
import dev.lazyz.cli.output.counted
import dev.lazyz.cli.page.Page
import dev.lazyz.scenes.html.Html.escaped

/** A [Report] as one page of HTML, without a script. */
internal class ReportPage(private val report: Report) {
    private val title = "${report.input}: one picture, " +
        counted(report.entries.size.toLong(), "order of evaluation", "orders of evaluation")
    private val page = Page(title)
    private val shot = report.comparison.shot
    private val numbers = ReportNumbers(report)
    private val maps = ReportMaps(report, page.pictures)

    fun html(): String = page.html(
        buildString {
            opening()
            section("costs", "What each strategy did", numbers.charts())
            section("maps", "Where the work was", maps.overdraw())
            section("strategies", "Strategy by strategy", maps.strategies())
            section("numbers", "All numbers", numbers.table())
        },
    )

    private fun StringBuilder.section(id: String, title: String, content: String) {
        appendLine("""<section id="$id">""")
        appendLine("<h2>$title</h2>")
        append(content)
        appendLine("</section>")
    }

    private fun StringBuilder.opening() {
        appendLine("<header>")
        appendLine("<h1>${escaped(title)}</h1>")
        val (look, sign) = if (report.isGood) "good" to "✓" else "bad" to "✗"
        appendLine("""<p class="verdict $look"><strong>$sign ${escaped(report.verdict)}</strong></p>""")
        appendLine(
            "<p>Each strategy removes hidden surfaces in another order, and computes the same picture: colour, depth " +
                "and visible surface of every pixel were compared, without tolerance. What differs is the cost.</p>",
        )
        appendLine(
            """<nav aria-label="Sections"><ul><li><a href="#costs">What each strategy did</a></li>""" +
                """<li><a href="#maps">Where the work was</a></li>""" +
                """<li><a href="#strategies">Strategy by strategy</a></li>""" +
                """<li><a href="#numbers">All numbers</a></li></ul></nav>""",
        )
        appendLine("</header>")
        appendLine("""<div class="opening">""")
        report.comparison.reference?.let { reference ->
            appendLine("<figure>${page.pictures.show(reference.image, "${report.input}, rendered")}")
            appendLine("<figcaption>The picture. Its pixel hash is the SHA-256 of its colours.</figcaption></figure>")
        }
        facts()
        appendLine("</div>")
    }

    private fun StringBuilder.facts() {
        val pixels = shot.pixels
        val image = report.comparison.reference?.image
        val factor = shot.factor
        appendLine("""<div class="card"><h2>What was rendered</h2><dl class="facts">""")
        fact("Input", report.input)
        fact("Picture", "${pixels.width} × ${pixels.height} pixels")
        fact("Samples", if (factor == 1) "one a pixel" else "$factor × $factor a pixel, with anti-aliasing")
        fact("Primitives", "%,d".format(null, shot.frame.primitives.size))
        if (image != null) {
            val visible = image.visible
            fact("Covered", "%,d pixels, %.1f %%".format(null, visible, 100.0 * visible / pixels.size))
        }
        if (report.parts.any { it.name.isNotEmpty() }) fact("Parts", parts(pixels.size))
        fact("Renderings", "${report.comparison.repeat} with each strategy to measure time")
        fact("Program", "zcli ${Version.text}")
        val system = listOf("os.name", "os.arch").joinToString(" ") { System.getProperty(it) }
        val processors = Runtime.getRuntime().availableProcessors()
        fact("Machine", "Java ${System.getProperty("java.version")}, $system, $processors processors")
        appendLine("</dl>")
        appendLine("<p>The same page again: <code>${escaped(report.command)}</code></p></div>")
    }

    /** Returns the names of the largest visible parts, and which share of all [pixels] they have. */
    private fun parts(pixels: Long): String {
        val byName = report.parts.groupBy { it.name.ifEmpty { "unnamed" } }
            .map { (name, surfaces) -> name to surfaces.sumOf { it.pixels.toLong() } }
            .sortedByDescending { it.second }
        val rest = byName.size - MOST_PARTS
        return byName.take(MOST_PARTS).joinToString { (name, size) ->
            "%s %.1f %%".format(null, name, 100.0 * size / pixels)
        } + if (rest > 0) ", and $rest more" else ""
    }

    private fun StringBuilder.fact(name: String, value: String) {
        appendLine("<dt>$name</dt><dd>${escaped(value)}</dd>")
    }

    private companion object {
        /** Most parts that the page names. */
        const val MOST_PARTS = 8
    }
}
