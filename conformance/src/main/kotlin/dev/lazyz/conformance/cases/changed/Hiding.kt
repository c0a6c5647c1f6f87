package dev.lazyz.conformance.cases.changed

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.NothingThere
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.Stripe
import java.util.Random

/** Where a primitive is that is invisible. */
internal enum class HidingPlace(private val primitive: (Frame) -> Primitive?) {
    NOWHERE({ NothingThere(it.raster) }),
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
