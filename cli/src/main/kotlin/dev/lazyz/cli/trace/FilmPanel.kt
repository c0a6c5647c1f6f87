package dev.lazyz.cli.trace

import dev.lazyz.scenes.pictures.Canvas
import dev.lazyz.scenes.pictures.PixelFont
import java.util.BitSet

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
