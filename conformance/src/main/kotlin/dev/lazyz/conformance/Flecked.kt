package dev.lazyz.conformance

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor
import dev.lazyz.scenes.Tint

/**
 * A primitive of one colour with flecks of another, one sample in five: everything else is as in [whole].
 *
 * Mostly a run of samples has the same colour at both ends, and another one in between. Primitives of even [number] have no
 * shading cursor. Immutable and thread safe if [whole] is.
 *
 * @param number another one gives other colours and flecks
 */
internal class Flecked(private val whole: Primitive, private val number: Int) : Primitive by whole {
    override fun shade(fragment: Fragment) {
        whole.shade(fragment)
        fleck(fragment)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? =
        if (number % 2 == 0) null else whole.shadingCursor(x, y)?.recoloured(::fleck)

    private fun fleck(fragment: Fragment) {
        val isFleck = Tint.hash(number, fragment.x, fragment.y, 0) % 5 == 0
        val light = 0.125f * (1 + number % 4)
        fragment.setColor(light, if (isFleck) 0.75f else light, 0.5f, fragment.alpha)
    }
}

/** The same frame with [Flecked] colours. */
internal fun FrameCase.flecked(): FrameCase = FrameCase(
    Frame(frame.raster, frame.primitives.mapIndexed { index, it -> Flecked(it, index) }, frame.region),
    "$code // each primitive of one colour with flecks of another, every other one without a shading cursor",
)
