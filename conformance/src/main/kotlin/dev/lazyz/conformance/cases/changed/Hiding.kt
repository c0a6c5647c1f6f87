package dev.lazyz.conformance.cases.changed

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.NothingThere
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.Stripe
import java.util.Random

/** Returns variants of this frame, each with one additional translucent primitive that is invisible. */
internal fun FrameCase.withHiddenGlass(random: Random): List<FrameCase> {
    val raster = frame.raster
    val hidden = linkedMapOf<String, Primitive>(
        "covers nothing" to NothingThere(raster),
        "lies behind everything" to
            Stripe(0..<raster.width, 0..<raster.height, Rasters.behindAll(raster.depthTest)),
    )
    besides(frame)?.let { hidden["lies outside the region"] = it }
    return hidden.map { (where, primitive) ->
        val index = random.nextInt(frame.primitives.size + 1)
        val all = frame.primitives.take(index) + Glass(primitive) + frame.primitives.drop(index)
        FrameCase(
            Frame(raster, all, frame.region),
            "$code // and a translucent primitive as number $index, which $where",
        )
    }
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
