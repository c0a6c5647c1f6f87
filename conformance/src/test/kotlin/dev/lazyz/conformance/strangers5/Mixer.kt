package dev.lazyz.conformance.strangers5

import dev.lazyz.Fragment
import dev.lazyz.Rgba

/** Mixes the colours of one sample, nearest first, as rule 5.5 says; one for each thread. */
internal class Mixer(private val mistake: Mistake?) {
    private var through = 1f
    private var sum = 0f
    private var red = 0f
    private var green = 0f
    private var blue = 0f

    /** Whether light still gets through. */
    val isOpen: Boolean get() = if (mistake == Mistake.PEELER_DIM) through >= 1f / 256f else through > 0f

    /** Begins a sample. */
    fun begin() {
        through = 1f
        sum = 0f
        red = 0f
        green = 0f
        blue = 0f
    }

    /** Goes on with a sample that was put away by [save]. */
    fun load(from: FloatArray, at: Int) {
        through = from[at]
        sum = from[at + 1]
        red = from[at + 2]
        green = from[at + 3]
        blue = from[at + 4]
    }

    /** Puts the sample away, [STATE] numbers from [at] on. */
    fun save(to: FloatArray, at: Int) {
        to[at] = through
        to[at + 1] = sum
        to[at + 2] = red
        to[at + 3] = green
        to[at + 4] = blue
    }

    /** Adds the next fragment behind the ones before. */
    fun add(fragment: Fragment) = add(fragment.red, fragment.green, fragment.blue, fragment.alpha)

    /** Adds the backdrop, and returns the finished colour. */
    fun finish(red: Float, green: Float, blue: Float, alpha: Float): Int {
        if (sum == 0f && mistake != Mistake.PEELER_MIXED_BACKDROP) return Rgba(red, green, blue, alpha).toArgb()
        if (through > 0f) add(red, green, blue, if (mistake == Mistake.CASTER_SOLID_BACKDROP) 1f else alpha)
        return Rgba(this.red / sum, this.green / sum, this.blue / sum, sum).toArgb()
    }

    /** Returns the finished colour where the backdrop is [color]. */
    fun finish(color: Rgba): Int = finish(color.red, color.green, color.blue, color.alpha)

    private fun add(red: Float, green: Float, blue: Float, alpha: Float) {
        val a = when {
            mistake == Mistake.PEELER_NAN_ALPHA && alpha.isNaN() -> 1f
            !(alpha > 0f) -> return
            alpha > 1f && mistake != Mistake.CASTER_BRIGHT_ALPHA -> 1f
            else -> alpha
        }
        val weight = through * a
        this.red += weight * red
        this.green += weight * green
        this.blue += weight * blue
        sum += weight
        through *= 1f - a
    }

    companion object {
        /** Numbers of a sample. */
        const val STATE: Int = 5
    }
}

/** Whether the greatest depth wins. */
internal fun dev.lazyz.DepthTest.isReverse(): Boolean = key(1, 0) < key(0, 0)

/** Whether the bounds have a sample in common with [region]. */
internal fun dev.lazyz.Primitive.meets(region: dev.lazyz.Region): Boolean {
    val top = rowStart
    val bottom = rowEnd
    if (top >= bottom || bottom <= region.rowStart || top >= region.rowEnd) return false
    val left = columnStart
    val right = columnEnd
    return left < right && right > region.columnStart && left < region.columnEnd
}
