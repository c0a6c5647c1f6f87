package dev.lazyz.scenes.aov

import dev.lazyz.Rgba
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import java.math.BigDecimal
import java.math.MathContext
import kotlin.math.floor

/**
 * The colours of an AOV, and what its legend says about them.
 *
 * @property title what the colours show; the part after a comma is left out if there is no room
 * @property bars scales of colours with numbers
 * @property swatches single colours with names
 */
internal class AovPalette private constructor(
    val title: String,
    val bars: List<Bar>,
    val swatches: List<Swatch>,
    private val color: (Int) -> Int,
) {
    /** Returns the colour of the pixel with the given index, `0xFFRRGGBB`. */
    fun argb(index: Int): Int = color(index)

    /** A scale of colours from 0 to 1, and the numbers at its ends. */
    class Bar(name: String, least: String, val most: String, val argb: (Double) -> Int) {
        /** What is written at the left end. */
        val leastText: String = if (name.isEmpty()) least else "$name $least"
    }

    /** A colour and its name. */
    class Swatch(val name: String, val argb: Int)

    companion object {
        private const val NOTHING = AovPicture.NOTHING
        private const val OPAQUE = 0xFF shl 24
        private val NONE = Swatch("none", NOTHING)

        /** In letters. */
        private const val LONGEST_LABEL = 16
        private val NAMES = listOf("x", "y", "z")

        fun of(image: AovImage): AovPalette = when (image.aov) {
            Aov.DEPTH -> scale(image, "depth, distance along the line of sight", null)
            Aov.COVERAGE -> scale(image, "coverage, part of the pixel", 0.0 to 1.0)
            Aov.OVERDRAW, Aov.SHADING_CALLS -> ofCounts(image, maxOf(image.ints.max(), 1))
            Aov.OBJECT -> ids(image, "objects, colours by number")
            Aov.PRIMITIVE -> ids(image, "primitives, colours by number")
            Aov.NORMAL -> normals(image)
            Aov.POSITION -> vectors(image, "position, red x, green y, blue z", NAMES.indices.map { range(image, it) })
            Aov.UV -> uvs(image)
        }

        /** Returns the colours of counts, on the scale from 0 to [most]. */
        fun ofCounts(image: AovImage, most: Int): AovPalette {
            val sum = image.ints.sumOf { it.toLong() }
            if (image.aov != Aov.OVERDRAW) {
                return scale(image, "shading calls, of the pixel, $sum in all", 0.0 to most.toDouble())
            }

            // A surface counts once, not once for each sample of the pixel
            val samples = image.samplesPerPixel
            val mean = readable(sum.toDouble() / samples / image.ints.size)
            return scale(image, "overdraw, surfaces at each place, mean $mean", 0.0 to most.toDouble(), samples)
        }

        /** Returns the colours of numbers on one scale; the legend has the ends of the scale divided by [unit]. */
        private fun scale(image: AovImage, title: String, fixed: Pair<Double, Double>?, unit: Int = 1): AovPalette {
            val (least, most) = fixed ?: range(image, 0)
            val bar = Bar("", readable(least / unit), readable(most / unit), { Rgba.viridis(it).toArgb() })
            return AovPalette(title, listOf(bar), listOf(NONE)) { index ->
                val number = image.numberAt(index, 0)
                if (number == image.aov.background || !number.isFinite()) {
                    NOTHING
                } else {
                    Rgba.viridis(place(number, least, most)).toArgb()
                }
            }
        }

        private fun ids(image: AovImage, title: String): AovPalette {
            val seen = image.ints.filter { it >= 0 }.distinct().sorted()
            val swatches = listOf(NONE) + seen.map { Swatch(label(it, image.names.getOrNull(it)), hashed(it)) }
            return AovPalette("$title, ${seen.size} visible", emptyList(), swatches) { index ->
                val id = image.ints[index]
                if (id < 0) NOTHING else hashed(id)
            }
        }

        /**
         * Returns the last part of the [name] of an object, or its number if it has none, or not only letters of ASCII.
         */
        private fun label(id: Int, name: String?): String {
            val own = name?.substringAfterLast('/').orEmpty()
            return if (own.isNotEmpty() && own.all { it in ' '..'~' }) own.take(LONGEST_LABEL) else "$id"
        }

        private fun normals(image: AovImage): AovPalette {
            val axes = NAMES.indices.flatMap { axis ->
                listOf("+" to 1.0, "-" to -1.0).map { (sign, size) ->
                    Swatch(sign + NAMES[axis], packed { if (it == axis) place(size, -1.0, 1.0) else 0.5 })
                }
            }
            return AovPalette("normal, red x, green y, blue z", emptyList(), axes + NONE) { index ->
                val isNone = (0..2).all { image.numberAt(index, it) == 0.0 }
                if (isNone) NOTHING else packed { place(image.numberAt(index, it), -1.0, 1.0) }
            }
        }

        private fun uvs(image: AovImage): AovPalette =
            vectors(image, "texture coordinates, red u, green v", listOf(0.0 to 1.0, 0.0 to 1.0))

        /** Channels as red, green and blue, each in a range of its own. Pixels of background numbers only are grey. */
        private fun vectors(image: AovImage, title: String, ranges: List<Pair<Double, Double>>): AovPalette {
            val bars = ranges.mapIndexed { channel, (least, most) ->
                Bar(image.aov.channels[channel], readable(least), readable(most)) { place ->
                    packed { if (it == channel) place else 0.0 }
                }
            }
            val isRepeated = image.aov == Aov.UV
            return AovPalette(title, bars, emptyList()) { index ->
                val isNone = image.aov.channels.indices.all { image.numberAt(index, it) == image.aov.background }
                if (isNone) {
                    NOTHING
                } else {
                    packed { channel ->
                        if (channel >= ranges.size) return@packed 0.0
                        val number = image.numberAt(index, channel)
                        val shown = if (isRepeated && number !in 0.0..1.0) number - floor(number) else number
                        place(shown, ranges[channel].first, ranges[channel].second)
                    }
                }
            }
        }

        /** Returns the least and the greatest number of a channel, without background pixels; 0 and 1 if none. */
        private fun range(image: AovImage, channel: Int): Pair<Double, Double> {
            var least = Double.POSITIVE_INFINITY
            var most = Double.NEGATIVE_INFINITY
            for (index in 0 until image.width * image.height) {
                if (image.aov.channels.indices.all { image.numberAt(index, it) == image.aov.background }) continue
                val number = image.numberAt(index, channel)
                if (!number.isFinite()) continue
                least = minOf(least, number)
                most = maxOf(most, number)
            }
            return if (least <= most) least to most else 0.0 to 1.0
        }

        /** Returns where [number] is between [least] and [most], 0..1; NaN is 0. */
        private fun place(number: Double, least: Double, most: Double): Double {
            val place = if (most > least) (number - least) / (most - least) else 0.0
            return if (place > 0.0) minOf(place, 1.0) else 0.0
        }

        private inline fun packed(component: (Int) -> Double): Int {
            var argb = OPAQUE
            for (i in 0..2) argb = argb or (floor(component(i) * 255 + 0.5).toInt() shl (16 - 8 * i))
            return argb
        }

        /** Returns a colour for [id], not too dark and not grey: bits of a product with an odd constant, mixed. */
        private fun hashed(id: Int): Int {
            var bits = (id + 1) * 0x9E3779B1.toInt()
            bits = (bits xor (bits ushr 15)) * 0x85EBCA6B.toInt()
            bits = bits xor (bits ushr 13)
            val hue = (bits and 0xFFFF) * 360f / 0x10000
            val saturation = 0.45f + (bits ushr 16 and 0xFF) * (0.45f / 255)
            val value = 0.6f + (bits ushr 24 and 0xFF) * (0.35f / 255)
            return Rgba.hsv(hue, saturation, value).toArgb()
        }

        /** At most four digits other than leading zeros; as 1.5E+12 if that is shorter. */
        private fun readable(number: Double): String {
            val rounded = BigDecimal(number).round(MathContext(4)).stripTrailingZeros()
            val plain = rounded.toPlainString()
            return if (plain.length <= 9) plain else rounded.toString()
        }
    }
}
