package dev.lazyz.conformance.cases.changed

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.cases.UncoveredPrimitive
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor
import java.util.Random

/** Where a primitive is that is invisible. */
internal enum class HidingPlace(private val primitive: (Frame) -> Primitive?) {
    NOWHERE({ UncoveredPrimitive(it.raster) }),
    BEHIND_EVERYTHING({
        with(it.raster) { Stripe(0..<width, 0..<height, Rasters.behindAll(depthTest)) }
    }),
    OUTSIDE_THE_REGION(::besides),
    ;

    /** Returns a primitive there; null if [frame] has no such place. */
    fun primitive(frame: Frame): Primitive? = primitive.invoke(frame)
}

/** Returns variants of this frame, each with one additional translucent primitive that is invisible. */
internal fun FrameCase.withHiddenGlass(random: Random): List<FrameCase> =
    HidingPlace.entries.filter { it.primitive(frame) != null }
        .map { withHiddenGlass(random.nextInt(frame.primitives.size + 1), it) }

/** Returns this frame with a translucent primitive as number [index], at a [place] that there must be. */
internal fun FrameCase.withHiddenGlass(index: Int, place: HidingPlace): FrameCase {
    val hidden = Glass(checkNotNull(place.primitive(frame)))
    return FrameCase(
        Frame(frame.raster, frame.primitives.take(index) + hidden + frame.primitives.drop(index), frame.region),
        "$code\n    .let { SuiteFrames.withHiddenGlass(it, $index, \"$place\") }",
    )
}

/** Returns a primitive that covers the samples on one side of the region; null if the region is the whole raster. */
private fun besides(frame: Frame): Primitive? {
    val raster = frame.raster
    val region = frame.region
    val columns = 0..<raster.width
    val rows = 0..<raster.height
    return when {
        region.columnStart > 0 -> Stripe(0..<region.columnStart, rows, 0)
        region.columnEnd < raster.width -> Stripe(region.columnEnd..<raster.width, rows, 0)
        region.rowStart > 0 -> Stripe(columns, 0..<region.rowStart, 0)
        region.rowEnd < raster.height -> Stripe(columns, region.rowEnd..<raster.height, 0)
        else -> null
    }
}

/** What [whole] covers, black and with alpha 0, so that its packed colour is 0; it says that it holds a megabyte. */
private class TransparentPrimitive(whole: Primitive) : Primitive by whole {
    override val heldBytes: Long get() = 1L shl 20

    override fun shade(fragment: Fragment): Unit = fragment.setColor(0f, 0f, 0f, 0f)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
}

/** Returns the frame with every second primitive as [TransparentPrimitive]. */
internal fun FrameCase.halfHeavyAndDark(): FrameCase {
    val primitives = frame.primitives.mapIndexed { index, it -> if (index % 2 == 1) TransparentPrimitive(it) else it }
    return FrameCase(
        Frame(frame.raster, primitives, frame.region),
        "$code\n    .let { SuiteFrames.halfHeavyAndDark(it) }",
    )
}

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
