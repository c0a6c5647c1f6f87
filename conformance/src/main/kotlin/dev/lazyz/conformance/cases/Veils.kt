package dev.lazyz.conformance.cases

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.oracle.BlendedSample
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import java.util.Random

/** A translucent primitive that covers a raster of [side] x [side] samples at one depth, with a colour for each. */
private class Veil(private val side: Int, private val depth: Int, private val colors: List<Rgba>) : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = side
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = side
    override val leastDepth: Int get() = depth
    override val greatestDepth: Int get() = depth
    override val isTranslucent: Boolean get() = true

    override fun spans(y: Int, spans: Spans) {
        if (y in 0..<side) spans.add(0, side)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment): Unit =
        with(colors[fragment.y * side + fragment.x]) { fragment.setColor(red, green, blue, alpha) }
}

/**
 * Returns a frame of layers whose light just reaches the next 8-bit value at half of the samples, and just does not
 * reach it at the others: the least change of a sum changes the picture. The layer behind all others, seen through a
 * transmittance down to 10^-30, decides. The less of its light gets through, the brighter it is.
 */
internal fun veils(salt: Long): FrameCase {
    val random = Random(salt)
    val samples = List(SIDE * SIDE) { layers(random) }
    val veils = List(LAYERS) { layer -> Veil(SIDE, (layer + 1) * DISTANCE, samples.map { it[layer] }) }
    return FrameCase(Frame(Raster(SIDE, SIDE), veils.shuffled(random)), "SuiteFrames.veils(${salt}L)")
}

private const val SIDE = 16
private const val LAYERS = 8
private const val DISTANCE = 1 shl 24
private const val LEAST_TRANSMITTANCE = 1e-30f

/** Alphas of layers that leave some light, or hardly any. */
private val alphas = floatArrayOf(0.125f, 0.3f, 0.5f, 0.9f, 0.99f, 0.9999f, 1 - 1e-6f)

/** Returns the layers of a sample, from near to far. */
private fun layers(random: Random): List<Rgba> {
    var left = 1f
    val layers = MutableList(LAYERS) {
        val alpha = if (random.nextInt(4) == 0) random.nextFloat() else alphas[random.nextInt(alphas.size)]
        val isLeft = left * (1f - alpha) > LEAST_TRANSMITTANCE
        if (isLeft) left *= 1f - alpha
        fun light() = random.nextFloat() / 2
        Rgba(light(), light(), light(), if (isLeft) alpha else 0f)
    }
    val last = layers.indexOfLast { it.alpha > 0f }
    if (last < 0) return layers
    fun decisive(component: (Rgba) -> Float) =
        decisive(layers.take(last).map { Rgba(component(it), 0f, 0f, it.alpha) }, layers[last].alpha, random)
    layers[last] = Rgba(decisive { it.red }, decisive { it.green }, decisive { it.blue }, layers[last].alpha)
    return layers
}

/**
 * Returns the least red light of a layer of this [alpha] that changes the packed red of the sample with the layers
 * [before] it, or the greatest that does not. Every operation of the blending is monotonic in it.
 */
private fun decisive(before: List<Rgba>, alpha: Float, random: Random): Float {
    fun packed(bits: Int): Int {
        val layers = (before + Rgba(Float.fromBits(bits), 0f, 0f, alpha)).map { BlendedSample.Layer(true) { it } }
        return BlendedSample.of(layers, Raster(1, 1).background).toArgb() shr 16 and 0xFF
    }
    var least = 0
    var most = Float.MAX_VALUE.toBits()
    val dark = packed(least)
    if (packed(most) == dark) return 0f
    while (most - least > 1) {
        val middle = (least + most) ushr 1
        if (packed(middle) == dark) least = middle else most = middle
    }
    return Float.fromBits(if (random.nextBoolean()) least else most)
}
