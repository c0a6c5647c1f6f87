package dev.lazyz.conformance.broken

import dev.lazyz.Capability
import dev.lazyz.Cell
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.ShadingCursor
import dev.lazyz.strategies.lists.Lists

/** Renderers that are correct except for extremes of alpha and light, and for primitives hidden behind glass. */
object BrokenGlass {
    /** A fragment of alpha 0 adds 0 times its light. */
    fun zeroTimesInfinity() = blending("zero-times-infinity") { cell -> blend(cell, isAdded = { true }) }

    fun stopsEarly() = blending("stops-early") { cell -> blend(cell, isOpen = { it > 1e-7f }) }

    fun multipliesByTheReciprocal() = blending("multiplies-by-the-reciprocal") { cell ->
        blend(cell, quotient = { sum, divisor -> sum * (1f / divisor) })
    }

    /** Shades all translucent fragments in front of the backdrop, and then blends. */
    fun shadesAhead() = blending("shades-ahead", setOf(Capability.SHADES_ONLY_VISIBLE)) { cell ->
        var i = 0
        while (i < cell.size && cell.isTranslucent(i)) cell.shade(i++)
        Selector.blend().select(cell)
    }

    /** Converts NaN to 1. */
    fun nanIsWhite() = primitives("nan-is-white") { Whitened(it) }

    private class Whitened(private val whole: Primitive) : Primitive by whole {
        override fun shade(fragment: Fragment) {
            whole.shade(fragment)
            with(fragment) { setColor(white(red), white(green), white(blue), alpha) }
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

        private fun white(component: Float) = if (component.isNaN()) 1f else component
    }

    /**
     * Contract rule 5.5, with parameters for which fragments are added, when the backdrop is shown unchanged, up to
     * which transmittance fragments are added, and how sums are divided.
     */
    private fun blend(
        cell: Cell,
        isAdded: (Float) -> Boolean = { it > 0f },
        isShownAsItIs: (Float) -> Boolean = { true },
        isOpen: (Float) -> Boolean = { it > 0f },
        quotient: (Float, Float) -> Float = { sum, divisor -> sum / divisor },
    ) {
        if (!cell.isTranslucent(0)) return cell.show(0)
        var transmittance = 1f
        val sums = FloatArray(4)
        fun add(red: Float, green: Float, blue: Float, alpha: Float) {
            val opacity = if (alpha > 0f) minOf(alpha, 1f) else 0f
            if (!isAdded(opacity)) return
            val weight = transmittance * opacity
            for ((i, it) in floatArrayOf(red, green, blue, 1f).withIndex()) sums[i] += weight * it
            transmittance *= 1f - opacity
        }
        var i = 0
        while (i < cell.size && cell.isTranslucent(i) && isOpen(transmittance)) {
            with(cell.shade(i++)) { add(red, green, blue, alpha) }
        }
        if (isOpen(transmittance)) {
            val (light, alpha) = if (i < cell.size) {
                with(cell.shade(i)) { floatArrayOf(red, green, blue) to alpha }
            } else {
                with(cell.background) { floatArrayOf(red, green, blue) to alpha }
            }
            if (sums[3] == 0f && isShownAsItIs(alpha)) return cell.show(0, light[0], light[1], light[2], alpha)
            add(light[0], light[1], light[2], alpha)
        }
        val divisor = if (sums[3] == 0f) 1f else sums[3]
        val (red, green, blue) = sums.take(3).map { quotient(it, divisor) }
        cell.show(0, red, green, blue, sums[3])
    }

    private fun blending(id: String, promises: Set<Capability> = emptySet(), selector: Selector): BrokenRenderer =
        BrokenRenderer(id, promises + Capability.TRANSPARENCY) { frame: Frame, sink ->
            val chosen = if (frame.hasTranslucency) selector else Selector.nearest()
            Lists(RenderOptions(selector = chosen)).render(frame, sink)
        }
}
