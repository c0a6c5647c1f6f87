package dev.lazyz.cli.trace

import dev.lazyz.cli.page.Page
import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped
import dev.lazyz.scenes.pictures.Canvas
import dev.lazyz.scenes.pictures.PixelFont
import java.io.ByteArrayOutputStream
import java.nio.file.Path
import java.util.Base64
import java.util.BitSet
import java.util.zip.Deflater
import java.util.zip.DeflaterOutputStream

/**
 * A [Film] as one page of HTML: the final picture, and the order of calls, from which a script draws each step. Without
 * the script, the page shows the last picture.
 *
 * @param input what is shown
 */
internal class FilmPage(
    private val orders: List<ShadingOrder>,
    private val picture: TracedPicture,
    private val input: String,
    private val steps: Int,
    private val framesPerSecond: Int,
) {
    private val page = Page("$input: evaluation order of ${orders.joinToString(" and ") { it.strategy }}")
    private val most = orders.maxOf { it.size }

    /** Writes the page to [path]. */
    fun write(path: Path) = Html.write(path, page.html(content(), Page.resource(FilmPage::class.java, "film.js")))

    private fun content(): String = buildString {
        appendLine("<h1>${escaped(input)}: in which order it is shaded</h1>")
        append("<p>A step shows some more shading calls, not time: %,d calls in %,d steps. ".format(null, most, steps))
        if (orders.size > 1) append("Both strategies have made equally many calls at each step, or are done. ")
        appendLine("All calls are those of one thread.</p>")
        legend()
        controls()
        appendLine("""<div class="grid">""")
        for (order in orders) panel(order)
        appendLine("</div>")
        appendLine("<noscript><p>This is the last picture. The film needs JavaScript.</p></noscript>")
    }

    private fun StringBuilder.legend() {
        appendLine("""<ul class="legend">""")
        appendLine("<li>${swatch(FilmPanel.WAITING)} waits for its colour</li>")
        val words = orders.joinToString { "%s %,d of %,d".format(null, it.strategy, it.discarded, it.size) }
        appendLine("<li>${swatch(FilmPanel.DISCARDED)} discarded: a nearer surface hides the colour ($words)</li>")
        appendLine("<li>other colours: final</li>")
        appendLine("</ul>")
    }

    private fun swatch(argb: Int): String = """<span class="swatch" style="background:${css(argb)}"></span>"""

    private fun css(argb: Int): String = "#%06x".format(argb and 0xFFFFFF)

    private fun StringBuilder.controls() {
        appendLine("""<div class="controls" hidden>""")
        appendLine("""<button type="button" class="main" id="play">Play</button>""")
        appendLine("""<button type="button" id="back" aria-label="One step back">←</button>""")
        appendLine("""<button type="button" id="forward" aria-label="One step forward">→</button>""")
        appendLine("""<input type="range" id="step" min="0" max="$steps" value="$steps" aria-label="Step">""")
        appendLine("""<output for="step" id="shown">step $steps of $steps</output>""")
        appendLine("</div>")
    }

    private fun StringBuilder.panel(order: ShadingOrder) {
        val colors = """data-waiting="${css(FilmPanel.WAITING)}" data-discarded="${css(FilmPanel.DISCARDED)}""""
        val speed = """data-steps="$steps" data-most="$most" data-speed="$framesPerSecond""""
        appendLine("""<figure class="card order" $colors $speed data-calls="${CallRuns.text(order)}">""")
        appendLine("<h2>${escaped(order.strategy)}</h2>")
        append("""<div class="film">${page.pictures.show(picture.toImage(), "$input, shaded by ${order.strategy}")}""")
        appendLine("""<canvas width="${picture.width}" height="${picture.height}" aria-hidden="true"></canvas></div>""")
        append("""<figcaption><b class="calls">%,d</b> calls, """.format(null, order.size))
        appendLine("""<b class="discarded">%,d</b> discarded</figcaption>""".format(null, order.discarded))
        appendLine("</figure>")
    }
}

/**
 * The shading calls of a [ShadingOrder] as text that a script can read.
 *
 * Most calls are at the pixel to the right of the call before, so the calls are written as *runs* of such neighbours of
 * which all are discarded, or none is. A run is two numbers: how far its first pixel is from the one after the run
 * before, at first from pixel 0, with the sign as the lowest bit; and its length, with the lowest bit set if it is
 * discarded. A number is written in groups of 7 bits from the lowest, with the highest bit of the byte set if another
 * follows. The bytes are compressed in zlib format (RFC 1950) and written in base 64.
 */
internal object CallRuns {
    /** Returns the calls of [order]. */
    fun text(order: ShadingOrder): String = Base64.getEncoder().encodeToString(compressed(bytes(order)))

    private fun bytes(order: ShadingOrder): ByteArray {
        val bytes = ByteArrayOutputStream()
        var expected = 0
        var call = 0
        while (call < order.size) {
            val first = order.place(call)
            val isDiscarded = order.isDiscarded(call)
            var length = 1
            while (
                call + length < order.size && order.place(call + length) == first + length &&
                order.isDiscarded(call + length) == isDiscarded
            ) {
                length++
            }
            bytes.writeNumber(signed(first - expected))
            bytes.writeNumber(2L * length + (if (isDiscarded) 1 else 0))
            expected = first + length
            call += length
        }
        return bytes.toByteArray()
    }

    private fun signed(number: Int): Long = if (number < 0) -2L * number - 1 else 2L * number

    private fun ByteArrayOutputStream.writeNumber(number: Long) {
        var rest = number
        while (rest >= 0x80) {
            write((rest and 0x7F).toInt() or 0x80)
            rest = rest shr 7
        }
        write(rest.toInt())
    }

    private fun compressed(bytes: ByteArray): ByteArray {
        val result = ByteArrayOutputStream()
        val deflater = Deflater(Deflater.BEST_COMPRESSION)
        try {
            DeflaterOutputStream(result, deflater).use { it.write(bytes) }
        } finally {
            deflater.end()
        }
        return result.toByteArray()
    }
}

/**
 * The part of a film that shows one strategy: the picture as far as it is shaded, and below it the numbers of calls.
 *
 * The background is there from the beginning; pixels that wait for their colour are grey. A discarded call is pink in
 * the picture of its step, and stays so until its pixel gets its final colour. A pixel with several layers gets that
 * with the first layer that counts.
 *
 * @param picture the final picture
 */
internal class FilmPanel(private val order: ShadingOrder, private val picture: TracedPicture) {
    private val shown = IntArray(picture.argb.size) { if (picture.covered[it]) WAITING else picture.argb[it] }
    private val ready = BitSet(shown.size)
    private val discardedNow = BitSet(shown.size)
    private var done = 0
    private var discarded = 0

    /** Makes the next step: goes on until [calls] shading calls are made. */
    fun advance(calls: Int) {
        discardedNow.clear()
        val end = minOf(calls, order.size)
        while (done < end) {
            val place = order.place(done)
            if (order.isDiscarded(done)) {
                discarded++
                discardedNow.set(place)
                if (!ready[place]) shown[place] = DISCARDED
            } else {
                ready.set(place)
                shown[place] = picture.argb[place]
            }
            done++
        }
    }

    /** Draws the panel from column [left] on. */
    fun draw(canvas: Canvas, left: Int) {
        for (place in shown.indices) {
            val color = if (discardedNow[place]) DISCARDED else shown[place]
            canvas.set(left + place % picture.width, place / picture.width, color)
        }
        val top = picture.height + MARGIN
        canvas.text("${order.strategy}: " + "%,d calls".format(null, done), left + MARGIN, top, 1, INK)
        val color = if (discarded == 0) INK else DISCARDED
        canvas.text("%,d discarded".format(null, discarded), left + MARGIN, top + LINE, 1, color)
    }

    companion object {
        /** The colour of discarded calls. */
        const val DISCARDED = 0xFFFF1493.toInt()

        /** The colour of pixels that wait for their shading call. */
        const val WAITING = 0xFFC8C8C8.toInt()
        private const val INK = 0xFF202020.toInt()
        private const val MARGIN = 4
        private const val LINE = PixelFont.HEIGHT + 4
        private const val LEAST_WIDTH = 200

        /** The width of a panel with this [picture]. */
        fun width(picture: TracedPicture): Int = maxOf(picture.width, LEAST_WIDTH)

        /** The height of a panel with this [picture]. */
        fun height(picture: TracedPicture): Int = picture.height + 2 * MARGIN + 2 * LINE
    }
}
