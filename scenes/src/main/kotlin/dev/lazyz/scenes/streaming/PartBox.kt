package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box

/** The smallest box around points that are added one by one. Points that are not finite are ignored. */
internal class PartBox {
    private var minX = Float.POSITIVE_INFINITY
    private var minY = Float.POSITIVE_INFINITY
    private var minZ = Float.POSITIVE_INFINITY
    private var maxX = Float.NEGATIVE_INFINITY
    private var maxY = Float.NEGATIVE_INFINITY
    private var maxZ = Float.NEGATIVE_INFINITY

    fun add(x: Float, y: Float, z: Float) {
        // The sum is finite only if all are; it cannot overflow to a wrong answer in double precision
        if (!(x.toDouble() + y + z).isFinite()) return
        minX = minOf(minX, x)
        minY = minOf(minY, y)
        minZ = minOf(minZ, z)
        maxX = maxOf(maxX, x)
        maxY = maxOf(maxY, y)
        maxZ = maxOf(maxZ, z)
    }

    /** Returns the box, or null if there was no point. */
    fun toBox(): Box? = if (minX > maxX) {
        null
    } else {
        Box(
            minX.toDouble(), minY.toDouble(), minZ.toDouble(), maxX.toDouble(), maxY.toDouble(), maxZ.toDouble(),
        )
    }
}
