package dev.lazyz.lighting

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.camera.Camera
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * How far a scene reaches toward a distant light, on a square grid: which points see the light from there. Immutable
 * and thread safe. Memory: 2 bytes a texel.
 *
 * @property direction direction to the light; unit length
 * @param center the middle of the scene, world space
 * @param origin what points are relative to, world space
 * @param radius of a sphere around the scene, world units, above 0
 * @param size number of texels of a side
 */
internal class DistanceMap(
    val direction: Vector3dc,
    private val center: Vector3dc,
    origin: Vector3dc,
    private val radius: Double,
    private val size: Int,
) {
    private val heights = ShortArray(size * size)

    // From points to columns, rows and heights of the grid: three factors and a summand each
    private val columns: FloatArray
    private val rows: FloatArray
    private val levels: FloatArray

    init {
        val axes = camera()
        val middle = Vectors.minus(center, origin)
        columns = form(axes.toWorldDirection(1.0, 0.0, 0.0), middle, size / 2.0, size / 2.0 - 0.5)
        rows = form(axes.toWorldDirection(0.0, -1.0, 0.0), middle, size / 2.0, size / 2.0 - 0.5)
        levels = form(direction, middle, LEVELS / 2.0, LEVELS / 2.0)
    }

    /** The direction in single precision. */
    @JvmField val x: Float = direction.x().toFloat()

    @JvmField val y: Float = direction.y().toFloat()

    @JvmField val z: Float = direction.z().toFloat()

    /** The camera whose picture is the map, looking from the light at the scene. */
    fun camera(): Camera = Camera.orthographic(
        Vector3d(
            center.x() + 2 * radius * direction.x(), center.y() + 2 * radius * direction.y(),
            center.z() + 2 * radius * direction.z(),
        ),
        center, Vector3d(0.0, 1.0, 0.0), 2 * radius, radius, 3 * radius,
    )

    /** Fills the map with the depths of [image], which was rendered by [camera]. */
    fun fill(image: Image) {
        for (i in heights.indices) {
            heights[i] = if (image.primitive[i] == DepthTest.BACKGROUND) {
                0
            } else {
                ((1.0 - Depth.toUnit(image.depth[i])) * LEVELS).toInt().coerceIn(1, LEVELS).toShort()
            }
        }
    }

    /**
     * Returns which part of the light reaches the point ([px], [py], [pz]), 0..1: the four texels around it each let
     * the light pass or not, and their answers are interpolated. Points outside the grid see the light.
     */
    fun openness(px: Float, py: Float, pz: Float): Float {
        val column = columns[0] * px + columns[1] * py + columns[2] * pz + columns[3]
        val row = rows[0] * px + rows[1] * py + rows[2] * pz + rows[3]
        val level = levels[0] * px + levels[1] * py + levels[2] * pz + levels[3] + SLACK
        return interpolated(column, row, size, outside = 1f) { open(it, level) }
    }

    private fun open(at: Int, level: Float): Float {
        val height = heights[at].toInt() and LEVELS
        return if (height == 0 || height <= level) 1f else 0f
    }

    private fun form(axis: Vector3dc, middle: Vector3dc, scale: Double, offset: Double): FloatArray {
        val factor = scale / radius
        return floatArrayOf(
            (axis.x() * factor).toFloat(), (axis.y() * factor).toFloat(), (axis.z() * factor).toFloat(),
            (offset - Vectors.dot(axis, middle) * factor).toFloat(),
        )
    }

    private companion object {
        /** The greatest height; 0 means that nothing is there. */
        const val LEVELS = 0xFFFF

        /** By how much a point may be lower than what it belongs to, because heights are rounded. */
        const val SLACK = 8f
    }
}

/**
 * Returns the [value]s of the four nodes around a place on a square grid, interpolated; [outside] if the place is
 * beyond the grid. Nodes are numbered by rows, and node 0 is at column 0 and row 0.
 *
 * @param size number of nodes of a side
 */
internal inline fun interpolated(
    column: Float,
    row: Float,
    size: Int,
    outside: Float,
    value: (node: Int) -> Float,
): Float {
    if (!(column >= 0f && row >= 0f && column < size - 1 && row < size - 1)) return outside
    val left = column.toInt()
    val top = row.toInt()
    val right = column - left
    val down = row - top
    val at = top * size + left
    val upper = value(at) * (1f - right) + value(at + 1) * right
    val lower = value(at + size) * (1f - right) + value(at + size + 1) * right
    return upper * (1f - down) + lower * down
}
