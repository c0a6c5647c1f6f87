package dev.lazyz.world

import dev.lazyz.Frame
import dev.lazyz.FrameContent
import dev.lazyz.FramePart
import dev.lazyz.FrameParts
import dev.lazyz.FrameView
import dev.lazyz.NoView
import dev.lazyz.Reach
import dev.lazyz.geometry.Box
import dev.lazyz.setup.SceneSetUp
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.distanceAt
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface
import kotlin.math.nextDown
import kotlin.math.nextUp
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * From the [surfaces] of a scene to the content of a frame. Used once.
 */
internal class SceneContent(private val surfaces: List<Surface>, private val setUp: SceneSetUp) {
    /** Submission index of the first primitive of each surface. */
    private val starts = IntArray(surfaces.size)

    /**
     * Returns the primitives of all surfaces in submission order; those of a scene with a [StreamedMesh] in parts, see
     * [Frame.isStreamed].
     *
     * @throws IllegalArgumentException if a streamed scene has 2^31-1 primitives or more
     */
    fun content(): FrameContent = if (surfaces.any { it is StreamedMesh }) streamed() else inMemory()

    private fun view(): FrameView = SceneView(setUp.camera, setUp.origin, starts, surfaces.map { it.name })

    private fun inMemory(): FrameContent {
        val content = FrameContent.Builder()
        for ((number, surface) in surfaces.withIndex()) {
            starts[number] = content.next
            content.add(surface)
        }
        return content.build(view())
    }

    private fun FrameContent.Builder.add(surface: Surface) {
        val batch = if (surface is Mesh) setUp.batch(surface, next) else null
        if (batch != null) return add(batch)
        for (primitive in surface.primitives(setUp)) {
            setUp.checkpoint.pass()
            add(primitive)
        }
    }

    private fun streamed(): FrameContent {
        val next = NextIndex()
        var hasTranslucency = false
        val parts = ArrayList<FramePart>()
        for ((number, surface) in surfaces.withIndex()) {
            starts[number] = next.index
            if (surface is StreamedMesh) {
                hasTranslucency = hasTranslucency || surface.isTranslucent
                for (pieces in surface.groups()) {
                    val size = pieces.sumOf { surface.source.triangleCount(it) }
                    val reach = BoxReach(setUp).of(pieces.mapNotNull { surface.bounds(it) }.reduceOrNull(Box::union))
                    parts += FramePart(next.take(size), size, reach) { part(surface.read(pieces)) }
                }
            } else {
                // Surfaces in memory are set up once
                val part = part(surface)
                hasTranslucency = hasTranslucency || part.hasTranslucency
                parts += FramePart(next.take(part.size), part.size, null) { part }
            }
        }
        return FrameContent.streamed(FrameParts(next.index, hasTranslucency) { parts.iterator() }, view())
    }

    private fun part(surface: Surface): FrameContent =
        FrameContent.Builder().apply { add(surface) }.build(NoView)

    /** Counts primitives. */
    private class NextIndex {
        var index = 0
            private set

        /** Returns the index of the first of [count] primitives. */
        fun take(count: Int): Int {
            val first = index
            val end = first.toLong() + count
            require(end < Int.MAX_VALUE) { "a frame has at most 2^31-2 primitives: at least $end" }
            index = end.toInt()
            return first
        }
    }
}

/**
 * The view of a scene's frame.
 *
 * @param starts submission index of the first primitive of each surface
 */
internal class SceneView(
    private val camera: Camera,
    private val origin: Vector3dc,
    private val starts: IntArray,
    override val objectNames: List<String>,
) : FrameView {
    override val near: Double get() = camera.near
    override val far: Double get() = camera.far
    override val originX: Double get() = origin.x()
    override val originY: Double get() = origin.y()
    override val originZ: Double get() = origin.z()

    override fun distance(unit: Double): Double = camera.distanceAt(unit)

    override fun distance(x: Float, y: Float, z: Float): Double {
        val dx = camera.eye.x() - originX - x
        val dy = camera.eye.y() - originY - y
        val dz = camera.eye.z() - originZ - z
        return camera.backward.x * dx + camera.backward.y * dy + camera.backward.z * dz
    }

    override fun objectOf(index: Int): Int {
        // The last surface that does not begin later: surfaces without primitives begin where the next one does
        var low = 0
        var high = starts.size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (starts[middle] <= index) low = middle + 1 else high = middle
        }
        return low - 1
    }

    override fun firstOf(number: Int): Int = starts[number]
}

/** Where what is in a box can be on the raster of [setUp]. */
internal class BoxReach(private val setUp: SetUp) {
    /**
     * Returns a rectangle that contains all samples of triangles in [box], or null if it is not known because the box
     * reaches beyond the near plane, the far plane or the guard band. A null box is empty.
     *
     * The projection of a box is the convex hull of its projected corners. The rectangle is larger by a sample on each
     * side than the corners, because vertices are snapped. Before that, vertices are rounded to 32-bit floats relative
     * to the origin of the set-up, so corners are rounded outwards.
     */
    fun of(box: Box?): Reach? {
        if (box == null) return Reach(0, 0, 0, 0)
        var left = Double.POSITIVE_INFINITY
        var top = Double.POSITIVE_INFINITY
        var right = Double.NEGATIVE_INFINITY
        var bottom = Double.NEGATIVE_INFINITY
        for (number in 0 until 8) {
            val corner = setUp.project(rounded(box.corner(number), number)) ?: return null
            left = minOf(left, corner.x)
            top = minOf(top, corner.y)
            right = maxOf(right, corner.x)
            bottom = maxOf(bottom, corner.y)
        }
        return Reach(
            StrictMath.floor(left).toInt() - 1, StrictMath.floor(top).toInt() - 1,
            StrictMath.ceil(right).toInt() + 1, StrictMath.ceil(bottom).toInt() + 1,
        )
    }

    private fun rounded(corner: Vector3d, number: Int): Vector3d {
        val origin = setUp.origin
        return Vector3d(
            outwards(corner.x, origin.x(), number and 1 != 0),
            outwards(corner.y, origin.y(), number and 2 != 0),
            outwards(corner.z, origin.z(), number and 4 != 0),
        )
    }

    /** Returns a float relative to [origin] that is not between [value] and the middle of the box. */
    private fun outwards(value: Double, origin: Double, isMaximum: Boolean): Double {
        val nearest = (value - origin).toFloat()
        return origin + (if (isMaximum) nearest.nextUp() else nearest.nextDown()).toDouble()
    }
}
