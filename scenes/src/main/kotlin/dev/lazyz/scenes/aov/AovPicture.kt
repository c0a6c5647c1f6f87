package dev.lazyz.scenes.aov

import dev.lazyz.Image
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.scenes.pictures.Canvas
import dev.lazyz.scenes.pictures.PixelFont

/**
 * Pictures of AOVs for people: colours, and below them a legend with the range of the numbers. Everything is drawn by
 * integers and a font of its own, so a picture is the same on every machine. For data, see [AovFiles].
 *
 * | AOV | colours |
 * |---|---|
 * | depth | the scale [dev.lazyz.Rgba.viridis] from the nearest to the farthest pixel |
 * | coverage | the same scale from 0 to 1 |
 * | overdraw | the same scale from 0 to the greatest number; the legend counts surfaces, means of the pixel's samples |
 * | shading calls | the same scale from 0 to the greatest number |
 * | normal | red, green and blue are x, y and z, -1..1 |
 * | position | red, green and blue are x, y and z, each from the least to the greatest number in the picture |
 * | texture coordinates | red is u and green v, their fractions where they are not in 0..1 |
 * | object and primitive | a colour for each number, by a hash |
 *
 * Pixels without a surface, fragment or shading call are grey.
 */
public object AovPicture {
    /** The colour of pixels without a surface, fragment or shading call, `0xFFRRGGBB`. */
    public const val NOTHING: Int = 0xFFD8D8D8.toInt()

    private const val PAGE = 0xFFFFFFFF.toInt()
    private const val INK = 0xFF202020.toInt()

    /** The narrowest page; smaller pictures are in its upper left corner. */
    private const val LEAST_WIDTH = 200

    /** The legend's text is as large as it is for a page of this width, and larger for wider ones in whole steps. */
    private const val USUAL_WIDTH = 320

    /**
     * Returns a picture of [aov] with a legend below it. It is as wide as the AOV, but at least 200 pixels, and higher
     * by the legend. It is opaque and has no depth.
     *
     * @throws ArithmeticException if it would have more than 2^31-1 pixels
     */
    @JvmStatic
    public fun of(aov: AovImage): Image {
        val width = maxOf(aov.width, LEAST_WIDTH)
        val scale = maxOf(width / USUAL_WIDTH, 1)
        val palette = AovPalette.of(aov)
        val legend = Legend(aov, palette, scale, width)
        val canvas = Canvas(width, Math.addExact(aov.height, legend.height), PAGE)
        paint(aov, palette, canvas)
        legend.draw(canvas, aov.height)
        return canvas.toImage()
    }

    /**
     * Returns a picture of the counts of [aov] without a legend, on the scale from 0 to [most], so that pictures of
     * several renderings can be compared: 0 is grey, and more than [most] counts as [most]. It is opaque and has no
     * depth.
     *
     * @throws IllegalArgumentException if [aov] is no count ([Aov.OVERDRAW] or [Aov.SHADING_CALLS]), or [most] is not
     *   positive
     */
    @JvmStatic
    public fun ofCounts(aov: AovImage, most: Int): Image {
        require(aov.aov == Aov.OVERDRAW || aov.aov == Aov.SHADING_CALLS) { "'${aov.aov.id}' is no count" }
        require(most > 0) { "most must be positive: $most" }
        val canvas = Canvas(aov.width, aov.height, PAGE)
        paint(aov, AovPalette.ofCounts(aov, most), canvas)
        return canvas.toImage()
    }

    private fun paint(aov: AovImage, palette: AovPalette, canvas: Canvas) {
        for (y in 0 until aov.height) {
            for (x in 0 until aov.width) canvas.set(x, y, palette.argb(y * aov.width + x))
        }
    }

    /** The legend of [aov] on a page of [width] pixels, with dots of [scale] pixels. */
    private class Legend(
        private val aov: AovImage,
        private val palette: AovPalette,
        private val scale: Int,
        private val width: Int,
    ) {
        private val margin = 4 * scale
        private val line = (PixelFont.HEIGHT + 4) * scale
        private val title =
            listOf(palette.title, palette.title.substringBefore(',')).firstOrNull { fits(it) } ?: aov.aov.id

        val height: Int = 2 * margin + line * (1 + palette.bars.size + (if (palette.swatches.isEmpty()) 0 else 1))

        private fun fits(text: String) = scale * PixelFont.width(text) <= width - 2 * margin

        fun draw(canvas: Canvas, top: Int) {
            var y = top + margin
            canvas.text(title, margin, y, scale, INK)
            y += line
            val start = margin + scale * ((palette.bars.maxOfOrNull { PixelFont.width(it.leastText) } ?: 0) + 4)
            val end = width - margin - scale * ((palette.bars.maxOfOrNull { PixelFont.width(it.most) } ?: 0) + 4)
            for (bar in palette.bars) {
                drawBar(canvas, bar, y, start, end)
                y += line
            }
            drawSwatches(canvas, y)
        }

        /** Draws the number at the left end, the colours from [start] to [end], and the number at the right end. */
        private fun drawBar(canvas: Canvas, bar: AovPalette.Bar, y: Int, start: Int, end: Int) {
            canvas.text(bar.leastText, margin, y, scale, INK)
            canvas.text(bar.most, end + 4 * scale, y, scale, INK)
            for (x in start until end) {
                val place = (x - start + 0.5) / (end - start)
                canvas.fill(x, y, 1, PixelFont.HEIGHT * scale, bar.argb(place))
            }
        }

        /** Draws as many swatches as fit, and how many are left. */
        private fun drawSwatches(canvas: Canvas, y: Int) {
            var x = margin
            for ((number, swatch) in palette.swatches.withIndex()) {
                val size = scale * (PixelFont.HEIGHT + 2 + PixelFont.width(swatch.name) + 5)
                val rest = "+${palette.swatches.size - number}"
                val isLast = number == palette.swatches.lastIndex
                val room = width - margin - (if (isLast) 0 else scale * PixelFont.width(rest))
                if (x + size > room) return canvas.text(rest, x, y, scale, INK)
                canvas.fill(x, y, PixelFont.HEIGHT * scale, PixelFont.HEIGHT * scale, swatch.argb)
                canvas.text(swatch.name, x + scale * (PixelFont.HEIGHT + 2), y, scale, INK)
                x += size
            }
        }
    }
}
