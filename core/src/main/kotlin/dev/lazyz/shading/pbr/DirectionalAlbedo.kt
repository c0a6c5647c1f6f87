package dev.lazyz.shading.pbr

/**
 * How much of uniform light a rough surface reflects: `F0 * scale + bias` for a surface with the reflectance F0 at
 * normal incidence, by roughness and angle. This is the second factor of the split sum.
 *
 * The two numbers are interpolated bilinearly in a table of [SIZE] x [SIZE] elements, over N.V and perceptual
 * roughness. It is computed once, in double precision with [StrictMath], from [STRATA] x [STRATA] microfacets for each
 * element; it differs from the exact integral by less than 0.012, except below N.V = 0.1. Source: B. Karis, "Real
 * Shading in Unreal Engine 4", SIGGRAPH 2013.
 */
internal object DirectionalAlbedo {
    private const val SIZE = 32
    private const val STRATA = 16
    private val scales = SquareTable(SIZE)
    private val biases = SquareTable(SIZE)

    /** The cosines and sines of the angles around the normal, for half a turn: the other half is symmetric. */
    private val directions = DoubleArray(STRATA) { StrictMath.cos(StrictMath.PI * (it + 0.5) / STRATA) }

    init {
        for (row in 0 until SIZE) {
            val roughness = row / (SIZE - 1.0)
            for (column in 0 until SIZE) integrate(maxOf(column / (SIZE - 1.0), 1e-3), roughness, row * SIZE + column)
        }
    }

    /** Passes scale and bias for N.V and perceptual roughness, each in 0..1, to [use]. */
    inline fun at(cosine: Float, roughness: Float, use: (Float, Float) -> Unit) =
        use(scale(cosine, roughness), bias(cosine, roughness))

    /** For [at] only. */
    fun scale(cosine: Float, roughness: Float): Float = scales.at(cosine, roughness)

    /** For [at] only. */
    fun bias(cosine: Float, roughness: Float): Float = biases.at(cosine, roughness)

    /** Computes element [at] with microfacets of the distribution. */
    private fun integrate(cosineV: Double, roughness: Double, at: Int) {
        val alpha = maxOf(roughness * roughness, 1e-4)
        val a2 = alpha * alpha
        val sineV = StrictMath.sqrt(1.0 - cosineV * cosineV)
        var scale = 0.0
        var bias = 0.0
        for (i in 0 until STRATA) {
            // More microfacets where they are steep, which matters at grazing angles
            val rest = 1.0 - (i + 0.5) / STRATA
            val u = 1.0 - rest * rest
            val cosineH = StrictMath.sqrt((1.0 - u) / (1.0 + (a2 - 1.0) * u))
            val sineH = StrictMath.sqrt(1.0 - cosineH * cosineH)
            for (direction in directions) {
                val vh = sineV * sineH * direction + cosineV * cosineH
                val cosineL = 2.0 * vh * cosineH - cosineV
                if (!(cosineL > 0.0 && vh > 0.0)) continue
                val light = cosineL + StrictMath.sqrt(a2 + (1.0 - a2) * cosineL * cosineL)
                val view = cosineV + StrictMath.sqrt(a2 + (1.0 - a2) * cosineV * cosineV)
                val weight = 2.0 * rest * 4.0 * cosineL * vh / (light * view * cosineH)
                val beyond = 1.0 - vh
                val grazing = beyond * beyond * beyond * beyond * beyond
                scale += (1.0 - grazing) * weight
                bias += grazing * weight
            }
        }
        scales.numbers[at] = (scale / (STRATA * STRATA)).toFloat()
        biases.numbers[at] = (bias / (STRATA * STRATA)).toFloat()
    }
}

/** A table over two arguments in 0..1, of [size] x [size] [numbers], between which it interpolates bilinearly. */
internal class SquareTable(private val size: Int) {
    /** Row by row; the first argument grows within a row. */
    val numbers: FloatArray = FloatArray(size * size)

    fun at(first: Float, second: Float): Float {
        val x = first * (size - 1)
        val y = second * (size - 1)
        val column = minOf(x.toInt(), size - 2)
        val row = minOf(y.toInt(), size - 2)
        val at = row * size + column
        val fx = x - column
        val fy = y - row
        val upper = numbers[at] * (1f - fx) + numbers[at + 1] * fx
        val lower = numbers[at + size] * (1f - fx) + numbers[at + size + 1] * fx
        return upper * (1f - fy) + lower * fy
    }
}
