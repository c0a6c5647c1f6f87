package dev.lazyz.spark.triangles

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import org.joml.Matrix4d
import org.joml.Vector4d

/**
 * Where points are on the screen: a rectangle that is never too small. If a point is not in front of the near plane, it
 * is the whole raster, since clipping moves points. Not thread safe.
 */
internal class ScreenReach(private val raster: Raster, private val camera: Camera) {
    private val isOnScreen = camera.projection == Projection.Screen
    private val matrix: Matrix4d? = if (isOnScreen) {
        null
    } else {
        camera.projectionMatrix(raster.width.toDouble() / raster.height).mul(camera.viewMatrix())
    }
    private val point = Vector4d()
    private var left = 0.0
    private var top = 0.0
    private var right = 0.0
    private var bottom = 0.0
    private var isCut = false

    /** Forgets all points. */
    fun clear() {
        left = Double.POSITIVE_INFINITY
        top = Double.POSITIVE_INFINITY
        right = Double.NEGATIVE_INFINITY
        bottom = Double.NEGATIVE_INFINITY
        isCut = false
    }

    /** Adds a point of world space. */
    fun add(x: Double, y: Double, z: Double) {
        if (!(x + y + z).isFinite()) return
        if (matrix == null) return extend(x, y)
        matrix.transform(point.set(x, y, z, 1.0))
        if (point.z < -point.w || point.w <= 0.0) {
            isCut = true
        } else {
            extend((point.x / point.w + 1) / 2 * raster.width, (1 - point.y / point.w) / 2 * raster.height)
        }
    }

    private fun extend(x: Double, y: Double) {
        left = minOf(left, x)
        right = maxOf(right, x)
        top = minOf(top, y)
        bottom = maxOf(bottom, y)
    }

    /** Returns the samples that what is between the points can cover, or null if there are none. */
    fun region(): Region? {
        if (isCut) return raster.region
        val columnStart = side(left - MARGIN, raster.width)
        val rowStart = side(top - MARGIN, raster.height)
        val columnEnd = side(right + MARGIN, raster.width)
        val rowEnd = side(bottom + MARGIN, raster.height)
        return if (columnStart >= columnEnd || rowStart >= rowEnd) {
            null
        } else {
            Region(columnStart, rowStart, columnEnd, rowEnd)
        }
    }

    private fun side(at: Double, most: Int): Int = at.coerceIn(0.0, most.toDouble()).toInt()

    private companion object {
        /** More than what rounding and the grid of 1/256 pixels change, in pixels. */
        const val MARGIN = 2.0
    }
}
