package dev.lazyz.cli.report

import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.cli.compare.Outcome
import dev.lazyz.cli.page.PictureStore
import dev.lazyz.cli.trace.ShadingOrder
import dev.lazyz.scenes.aov.AovPicture
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.scenes.pictures.Canvas
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference

/** The part of a report that shows pictures: where surfaces and shading calls are, and in which order. */
internal class ReportMaps(private val report: Report, private val pictures: PictureStore) {
    private val reference = report.comparison.reference?.image
    private val mostCalls: Int = maxOf(report.entries.maxOf { it.portrait?.calls?.ints?.max() ?: 0 }, 1)

    /** Returns a map of the overdraw, and what it means. */
    fun overdraw(): String = buildString {
        val overdraw = report.overdraw ?: return "<p>No strategy has rendered the input.</p>\n"
        val most = maxOf(overdraw.ints.max(), 1)
        appendLine("""<div class="opening">""")
        val sum = overdraw.ints.sumOf { it.toLong() }
        val samples = overdraw.samplesPerPixel.toDouble()
        val mean = sum / samples / overdraw.ints.size
        val words = "Overdraw: %.2f surfaces on average, up to %.1f at a pixel".format(null, mean, most / samples)
        appendLine("<figure>${pictures.show(AovPicture.ofCounts(overdraw, most), words)}")
        appendLine("<figcaption>$words.</figcaption></figure>")
        appendLine("""<div class="card"><h3>Overdraw</h3>""")
        append("<p>How many surfaces cover each pixel, hidden ones too: the work that can be saved. ")
        append("Where a surface covers a part of a pixel, that part counts. ")
        appendLine("It belongs to the scene, so it is the same for all strategies.</p>")
        append(scale("Surfaces:", "0", "", "%.1f".format(null, most / samples)))
        appendLine("</div></div>")
    }

    /** Returns a card for each strategy. */
    fun strategies(): String = buildString {
        appendLine("<p>For each strategy: its picture; how often each pixel was shaded, on one scale for all; and ")
        appendLine("when each pixel got its colour, if one thread works.</p>")
        append(scale("Calls:", "0", "1", "%,d a pixel".format(null, mostCalls)))
        append(scale("Order:", "none", "first", "last"))
        appendLine("""<div class="grid wide">""")
        for (entry in report.entries) card(entry)
        appendLine("</div>")
    }

    private fun StringBuilder.card(entry: ReportEntry) {
        appendLine("""<article class="card">""")
        appendLine("<h3>${escaped(entry.id)} ${ReportNumbers.badge(report, entry)}</h3>")
        appendLine("""<p class="soft">${escaped(entry.summary.replaceFirstChar { it.uppercase() })}.</p>""")
        when (val outcome = entry.outcome) {
            is Outcome.NotBlending -> appendLine(
                "<p>The scene is translucent, and this strategy does not blend. With <code>--opaque</code>, all " +
                    "strategies render the scene as opaque.</p>",
            )

            is Outcome.Failed -> appendLine("<p>${escaped(outcome.message)}</p>")

            is Outcome.Rendered -> {
                difference(entry, outcome)
                entry.portrait?.let { pictures(entry, it) }
            }
        }
        appendLine("</article>")
    }

    /** Says what is different, if something is. */
    private fun StringBuilder.difference(entry: ReportEntry, outcome: Outcome.Rendered) {
        if (report.isIdentical(entry)) return
        val difference = outcome.difference
        if (difference == null) {
            appendLine("<p>The picture differs only in some renderings: it is not the same each time.</p>")
        } else {
            appendLine("<p>${escaped(report.comparison.sentence(entry.id, difference))}: expected ")
            appendLine("${escaped("${difference.expected}")}; found ${escaped("${difference.actual}")}.</p>")
        }
    }

    private fun StringBuilder.pictures(entry: ReportEntry, portrait: Portrait) {
        appendLine("""<div class="row">""")
        val same = if (report.isIdentical(entry)) "the same as that of the others" else "not that of the others"
        figure(portrait.image, "Picture of ${entry.id}, $same", "picture")
        if (reference != null && reference.pixelHash() != portrait.hash) {
            val marked = PictureDifference.between(Picture.of(reference), Picture.of(portrait.image)).toImage()
            figure(marked, "Pixels of ${entry.id} that differ, yellow to red", "difference")
        }
        val calls = ReportMeasure.SHADING_CALLS.text(report, entry)
        val most = portrait.calls.ints.max()
        figure(
            AovPicture.ofCounts(portrait.calls, mostCalls),
            "Shading calls of ${entry.id}: $calls in all, up to $most at a pixel",
            "calls, up to $most a pixel",
        )
        portrait.order?.let { figure(it.toImage(), "Order in which ${entry.id} shades", "order") }
        appendLine("</div>")
    }

    private fun StringBuilder.figure(image: Image, description: String, caption: String) {
        appendLine("<figure>${pictures.show(image, description)}<figcaption>$caption</figcaption></figure>")
    }

    /** Returns the legend of the map [name]: what is grey, and the ends of the scale. */
    private fun scale(name: String, none: String, least: String, most: String): String {
        val colors = (0..STOPS).joinToString {
            "#%06x".format(Rgba.viridis(it / STOPS.toDouble()).toArgb() and 0xFFFFFF)
        }
        val grey = "#%06x".format(AovPicture.NOTHING and 0xFFFFFF)
        return """<div class="scale"><b>$name</b> <span class="swatch" style="background:$grey"></span> $none """ +
            """<span>$least</span><i style="background:linear-gradient(90deg, $colors)"></i>""" +
            "<span>$most</span></div>\n"
    }

    private companion object {
        const val STOPS = 7
    }
}

/** When each of [pixels] got its colour, from the first call of [order] to the last. Memory: 4 bytes a pixel. */
internal class OrderMap(order: ShadingOrder, pixels: Region) {
    private val canvas = Canvas(pixels.width, pixels.height, AovPicture.NOTHING)

    /** See [ShadingOrder.discarded]. */
    val discarded: Int = order.discarded

    init {
        // With several layers, the first counts
        val last = maxOf(order.size - 1, 1).toDouble()
        for (call in order.size - 1 downTo 0) {
            if (order.isDiscarded(call)) continue
            val place = order.place(call)
            canvas.set(place % pixels.width, place / pixels.width, Rgba.viridis(call / last).toArgb())
        }
    }

    fun toImage(): Image = canvas.toImage()
}
