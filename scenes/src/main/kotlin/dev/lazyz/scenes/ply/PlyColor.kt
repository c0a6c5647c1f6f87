package dev.lazyz.scenes.ply

import dev.lazyz.Rgba
import dev.lazyz.scenes.images.SrgbDecoding

/**
 * The columns of a colour. Red, green and blue are sRGB-encoded; alpha is linear. Numbers are integers in the range of
 * their type, or fractions in 0..1. Splats, which have no colours, have the first coefficient of spherical harmonics,
 * whose colour from all sides is 0.5 plus [HARMONIC] times the coefficient (B. Kerbl et al., "3D Gaussian Splatting for
 * Real-Time Radiance Field Rendering", 2023).
 */
internal class PlyColor private constructor(
    private val channels: IntArray,
    private val alpha: Int?,
    private val areCoefficients: Boolean,
) {
    /** The numbers of all columns. */
    val columns: List<Int> = channels.toList() + listOfNotNull(alpha)

    /** Returns red (0), green (1), blue (2), all linear, or alpha (3) of [row]. */
    fun channel(row: PlyRow, channel: Int): Float {
        if (channel == 3) return if (alpha == null) 1f else (row.numbers[alpha] / most(row, alpha)).toFloat()

        // Bytes are decoded with a table, so that they give the same colours as the same bytes in a texture
        val column = channels[channel]
        val number = row.numbers[column]
        val isCode = row.properties[column].type == PlyType.UCHAR
        if (areCoefficients) return Rgba.linearOf((0.5 + HARMONIC * number).coerceIn(0.0, 1.0))
        if (isCode) return SrgbDecoding.decodeByte(number.toInt().coerceIn(0, 255))
        return Rgba.linearOf(number / most(row, column))
    }

    private fun most(row: PlyRow, column: Int): Double = row.properties[column].type.most

    companion object {
        /** The value of the spherical harmonic of degree 0, 1 / (2 sqrt(pi)). */
        private const val HARMONIC = 0.28209479177387814

        /** Returns the colour of [element]'s rows, or null if they have none. */
        fun of(element: PlyElement): PlyColor? {
            val channels = listOf("red", "green", "blue").mapNotNull { column(element, it) }
            if (channels.size == 3) return PlyColor(channels.toIntArray(), column(element, "alpha"), false)
            val coefficients = List(3) { "f_dc_$it" }.mapNotNull { element.column(listOf(it)) }
            return if (coefficients.size < 3) null else PlyColor(coefficients.toIntArray(), null, true)
        }

        private fun column(element: PlyElement, name: String): Int? =
            element.column(listOf(name, "diffuse_$name", name.substring(0, 1)))
    }
}
