package dev.lazyz.conformance.strangers4

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.Renderer

/** Whether the bounds of this primitive reach into [region]. */
internal fun Primitive.touches(region: Region): Boolean =
    rowStart < rowEnd && columnStart < columnEnd && rowStart < region.rowEnd && rowEnd > region.rowStart &&
        columnStart < region.columnEnd && columnEnd > region.columnStart

/** Whether the greatest depth wins. */
internal val DepthTest.isGreatestFirst: Boolean get() = this == DepthTest.GREATER || this == DepthTest.GREATER_OR_EQUAL

/** Returns a key that no fragment of [primitive] is before. */
internal fun DepthTest.boundOf(primitive: Primitive, index: Int): Long =
    key(if (isGreatestFirst) primitive.greatestDepth else primitive.leastDepth, index)

/** Refuses a frame with translucent primitives, see rule 5.6. */
internal fun Renderer.refuseTranslucent(frame: Frame) {
    if (!frame.hasTranslucency) return
    val index = frame.primitives.indexOfFirst { it.isTranslucent }
    throw IllegalArgumentException(
        "primitive $index is translucent, and '$id' does not blend: " +
            "use a renderer with TRANSPARENCY, or make it opaque with asOpaque()",
    )
}
