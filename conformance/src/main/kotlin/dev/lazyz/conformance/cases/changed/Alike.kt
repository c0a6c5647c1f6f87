package dev.lazyz.conformance.cases.changed

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.conformance.cases.FrameCase

/** A primitive that is equal to all others of this class, although it looks like [whole]. */
private class Alike(whole: Primitive) : Primitive by whole {
    override fun equals(other: Any?): Boolean = other is Alike

    override fun hashCode(): Int = 0
}

/** Returns the frame with primitives that are all equal, each of them two times. */
internal fun FrameCase.alike(): FrameCase {
    val alike = frame.primitives.map { Alike(it) }
    return FrameCase(
        Frame(frame.raster, alike + alike, frame.region),
        "$code\n    .let { SuiteFrames.alike(it) }",
    )
}
