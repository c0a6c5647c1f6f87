package dev.lazyz.lighting

import kotlin.math.abs
import org.joml.Vector3dc

/**
 * How dark level ground is around a scene, on a square grid: the part of the [maps] from which no light arrives. It is
 * blurred so that the edges of single shadows do not show, and fades toward the border. Immutable and thread safe.
 * Memory: 4 bytes a node.
 *
 * @param maps the light
 * @param center middle of the grid, relative to the origin of the [maps], world units
 * @param halfX half of the extent of the scene along x, world units; [halfZ] is the same along z
 * @param spread by how much the grid is larger than the scene on each side, world units
 */
internal class ShadowGrid(
    private val maps: List<DistanceMap>,
    center: Vector3dc,
    halfX: Double,
    halfZ: Double,
    spread: Double,
) {
    private val centerX = center.x().toFloat()
    private val centerZ = center.z().toFloat()

    /** Half of the side of the grid, world units. */
    val reach: Float = (maxOf(halfX, halfZ) + spread).toFloat()
    private val shadows: FloatArray

    init {
        val y = center.y().toFloat()
        val raw = FloatArray(NODES * NODES)
        for (row in 0 until NODES) {
            val z = reach * place(row)
            for (column in 0 until NODES) {
                val x = reach * place(column)
                val fading = fading(x, halfX, spread) * fading(z, halfZ, spread)
                if (fading > 0f) raw[row * NODES + column] = fading * hidden(centerX + x, y, centerZ + z)
            }
        }
        shadows = blurred(blurred(raw))
    }

    /** Returns 1 from -[half] to [half], and 0 from [spread] beyond it. */
    private fun fading(place: Float, half: Double, spread: Double): Float {
        val beyond = ((abs(place) - half) / spread).toFloat()
        if (!(beyond < 1f)) return 0f
        val part = maxOf(beyond, 0f)
        return (1f - part * part) * (1f - part * part)
    }

    private fun hidden(x: Float, y: Float, z: Float): Float {
        var open = 0f
        for (map in maps) open += map.openness(x, y, z)
        return 1f - open / maps.size
    }

    /** Returns where a node is, -1..1. */
    private fun place(number: Int): Float = (2 * number + 1 - NODES) / (NODES - 1f)

    /** Returns the grid blurred along its rows and transposed. */
    private fun blurred(values: FloatArray): FloatArray {
        val result = FloatArray(NODES * NODES)
        for (row in 0 until NODES) {
            for (column in 0 until NODES) {
                var sum = 0f
                for (k in -RADIUS..RADIUS) {
                    val at = minOf(maxOf(column + k, 0), NODES - 1)
                    sum += WEIGHTS[k + RADIUS] * values[row * NODES + at]
                }
                result[column * NODES + row] = sum
            }
        }
        return result
    }

    /** Returns how dark the ground is at a point, 0..1; 0 beyond the grid. */
    fun at(x: Float, z: Float): Float {
        val column = ((x - centerX) / reach + 1f) * HALF
        val row = ((z - centerZ) / reach + 1f) * HALF
        return interpolated(column, row, NODES, outside = 0f) { shadows[it] }
    }

    private companion object {
        /** Nodes of a side. */
        const val NODES = 256
        const val HALF = (NODES - 1) / 2f

        /** Weights of the blur, nodes to each side: a sum of 1. */
        const val RADIUS = 4
        val WEIGHTS = floatArrayOf(1f, 8f, 28f, 56f, 70f, 56f, 28f, 8f, 1f).map { it / 256f }.toFloatArray()
    }
}
