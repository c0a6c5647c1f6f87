package dev.lazyz.conformance.cases.changed

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor
import dev.lazyz.conformance.cases.FrameCase

/** What [whole] covers, black and with alpha 0, so that its packed colour is 0; it says that it holds a megabyte. */
private class HeavyAndDark(whole: Primitive) : Primitive by whole {
    override val heldBytes: Long get() = 1L shl 20

    override fun shade(fragment: Fragment): Unit = fragment.setColor(0f, 0f, 0f, 0f)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
}

/** Returns the frame with every second primitive as [HeavyAndDark]. */
internal fun FrameCase.halfHeavyAndDark(): FrameCase {
    val primitives = frame.primitives.mapIndexed { index, it -> if (index % 2 == 1) HeavyAndDark(it) else it }
    return FrameCase(
        Frame(frame.raster, primitives, frame.region),
        "$code\n    .let { SuiteFrames.halfHeavyAndDark(it) }",
    )
}
