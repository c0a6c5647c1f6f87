package dev.lazyz.conformance.oracle

import dev.lazyz.Raster
import dev.lazyz.world.camera.Camera
import org.joml.Vector3d

/**
 * A vertex or a sample of a face, [SIZE] numbers: clip space (until it is projected), world space, normal, texture
 * coordinates, colour, second texture coordinates, tangent and the sign of the bitangent.
 */
internal class Corner(val n: DoubleArray) {
    val world: Vector3d get() = Vector3d(n[WORLD], n[WORLD + 1], n[WORLD + 2])
    val normal: Vector3d get() = Vector3d(n[NORMAL], n[NORMAL + 1], n[NORMAL + 2])

    fun with(at: Int, vararg values: Double): Corner = Corner(n.copyOf().also { values.copyInto(it, at) })

    companion object {
        const val W: Int = 3
        const val WORLD: Int = 4
        const val NORMAL: Int = 7
        const val UV: Int = 10
        const val COLOR: Int = 12
        const val UV2: Int = 16
        const val TANGENT: Int = 18
        const val SIZE: Int = 22
    }
}

/**
 * Computes a face's attributes at a sample: contract rules 1.3, 3.5, 3.6 and 9.1 in double precision, independently of
 * set-up.
 *
 * @param contours vertices whose positions and attributes are in world space
 */
internal class ExactFace(raster: Raster, camera: Camera, contours: List<List<Corner>>) {
    /** Whether too much is undefined: vertices very far away, on a plane, or beyond the guard band, or no area. */
    val isOpen: Boolean

    private var reference: List<Corner> = emptyList()
    private var grid: List<LongArray> = emptyList()
    private var area = 0L
    private var least = 0.0

    /** Whether the face is a triangle, so that an attribute that is equal at its vertices is constant. */
    var isTriangle: Boolean = false
        private set

    init {
        val m = camera.projectionMatrix(raster.width.toDouble() / raster.height).mul(camera.viewMatrix())
        val all = contours.flatten()
        var isFar = all.any { corner -> (0 until 3).any { !(Math.abs(corner.n[Corner.WORLD + it]) < FAR) } }
        var pieces = contours.map { contour ->
            contour.map { corner ->
                val clip = m.transform(org.joml.Vector4d(corner.world, 1.0))
                corner.with(0, clip.x, clip.y, clip.z, clip.w)
            }
        }
        for (sign in listOf(1, -1)) {
            fun inside(corner: Corner) = corner.n[Corner.W] + sign * corner.n[2]
            if (pieces.flatten().any { Math.abs(inside(it)) < CLOSE }) isFar = true
            pieces = pieces.map { cut(it, ::inside) }.filter { it.isNotEmpty() }
        }
        val left = pieces.flatten()
        val snapped = left.map { corner ->
            val x = (corner.n[0] / corner.n[Corner.W] + 1) / 2 * raster.width
            val y = (1 - corner.n[1] / corner.n[Corner.W]) / 2 * raster.height
            if (!(maxOf(Math.abs(x), Math.abs(y)) < GUARD)) isFar = true
            longArrayOf(Math.floor(256 * x + 0.5).toLong(), Math.floor(256 * y + 0.5).toLong())
        }
        isTriangle = left.size == 3 && pieces.size == 1
        if (!isFar && left.size >= 3) refer(left, snapped)
        isOpen = isFar || area == 0L
    }

    /** Rule 3.5: the first vertex, the one farthest from it, and the one farthest from the line through both. */
    private fun refer(left: List<Corner>, snapped: List<LongArray>) {
        val first = snapped[0]
        var numbers = listOf(0, 1, 2)
        if (left.size > 3) {
            val second = snapped.indices.maxBy {
                val dx = snapped[it][0] - first[0]
                val dy = snapped[it][1] - first[1]
                dx * dx + dy * dy
            }
            numbers = listOf(0, second, snapped.indices.maxBy { Math.abs(twice(first, snapped[second], snapped[it])) })
        }
        reference = numbers.map { left[it] }
        grid = numbers.map { snapped[it] }
        area = twice(grid[0], grid[1], grid[2])
        if (!isTriangle) least = Math.abs(area) * left.minOf { 1 / it.n[Corner.W] }
    }

    /** Rule 3.6. */
    fun at(x: Int, y: Int): Corner {
        val sample = longArrayOf(256L * x + 128, 256L * y + 128)
        val weights = (0 until 3).map {
            val opposite = twice(sample, grid[(it + 1) % 3], grid[(it + 2) % 3])
            (if (area < 0) -opposite else opposite) / reference[it].n[Corner.W]
        }
        val sum = maxOf(weights.sum(), least)
        return Corner(
            DoubleArray(Corner.SIZE) { k ->
                val values = reference.map { it.n[k] }
                if (isTriangle && values[0] == values[1] && values[0] == values[2]) {
                    values[0]
                } else {
                    (0 until 3).sumOf { weights[it] / sum * values[it] }
                }
            },
        )
    }

    /** Whether attribute [k] is equal at all vertices of a triangle. */
    fun isSame(k: Int): Boolean = isTriangle && reference.all { it.n[k] == reference[0].n[k] }

    private companion object {
        const val FAR = 1e4
        const val CLOSE = 1e-7
        const val GUARD = (1 shl 18).toDouble()

        /** Twice the signed area of a triangle. */
        fun twice(a: LongArray, b: LongArray, c: LongArray): Long =
            (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])

        /** Rule 9.1: for each vertex the intersection on the edge to it, if any, then the vertex itself. */
        fun cut(contour: List<Corner>, inside: (Corner) -> Double): List<Corner> {
            val left = ArrayList<Corner>()
            for ((i, to) in contour.withIndex()) {
                val from = contour[(i + contour.size - 1) % contour.size]
                val d = inside(from)
                val e = inside(to)
                if (d >= 0 != e >= 0) {
                    val t = d / (d - e)
                    left.add(Corner(DoubleArray(Corner.SIZE) { from.n[it] + t * (to.n[it] - from.n[it]) }))
                }
                if (e >= 0) left.add(to)
            }
            return left
        }
    }
}
