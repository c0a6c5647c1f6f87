package dev.lazyz.conformance.cases.changed

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.recoloured
import dev.lazyz.scenes.Tint

/**
 * Gives fragments one colour, except one sample in five, which has another. Most runs of samples therefore have equal
 * colours at both ends, but another one in between. Immutable and thread safe.
 *
 * @param number seed of the colours and flecks
 */
private class Flecks(private val number: Int) : (Fragment) -> Unit {
    private val light = 0.125f * (1 + number % 4)

    override fun invoke(fragment: Fragment) {
        val isFleck = Tint.hash(number, fragment.x, fragment.y, 0) % 5 == 0
        fragment.setColor(light, if (isFleck) 0.75f else light, 0.5f, fragment.alpha)
    }
}

/** A primitive without a shading cursor. */
private class WithoutCursor(whole: Primitive) : Primitive by whole {
    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
}

/** Returns the frame with [Flecks], and every other primitive [WithoutCursor]. */
internal fun FrameCase.flecked(): FrameCase {
    val primitives = frame.primitives.mapIndexed { index, it ->
        (if (index % 2 == 0) WithoutCursor(it) else it).recoloured(Flecks(index))
    }
    return FrameCase(
        Frame(frame.raster, primitives, frame.region),
        "$code\n    .let { SuiteFrames.flecked(it) }",
    )
}
