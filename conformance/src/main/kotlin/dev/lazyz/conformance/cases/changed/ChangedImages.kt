package dev.lazyz.conformance.cases.changed

import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Raster

/** Returns this picture with other indices for its primitives. The background's index is unchanged. */
internal fun Image.renumbered(number: (Int) -> Int): Image {
    val primitive = IntArray(primitive.size) {
        if (primitive[it] == DepthTest.BACKGROUND) DepthTest.BACKGROUND else number(primitive[it])
    }
    return Image(region, argb, depth, primitive, counters)
}

/** Returns this picture of [raster] in the lower right corner of one that is [right] columns and [down] rows larger. */
internal fun Image.moved(right: Int, down: Int, raster: Raster): Image {
    val wide = width + right
    fun row(values: IntArray, empty: Int) = IntArray(wide * (height + down)) {
        val x = it % wide - right
        val y = it / wide - down
        if (x < 0 || y < 0) empty else values[y * width + x]
    }
    return Image(
        wide,
        height + down,
        row(argb, raster.background.toArgb()),
        row(depth, raster.backgroundDepth),
        row(primitive, DepthTest.BACKGROUND),
        counters,
    )
}
