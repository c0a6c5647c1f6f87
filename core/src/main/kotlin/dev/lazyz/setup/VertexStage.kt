package dev.lazyz.setup

import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Vertices
import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import dev.lazyz.world.surface.Mesh

/**
 * The transforms of all vertices of a frame: from world space to clip space, and to the raster. Immutable and thread
 * safe.
 */
internal class VertexStage(camera: Camera, val viewport: Viewport) {
    val clipper: Clipper = clipper(ScreenGrid.GUARD)

    /** The clipper for lines. Its guard band is smaller, because lines are widened after clipping. */
    val lineClipper: Clipper = clipper(ScreenGrid.LINE_GUARD)

    /** Whether w can differ between vertices. */
    val isPerspective: Boolean = camera.projection is Projection.Perspective

    val worldToClip = camera.setUpMatrix(viewport.raster.width.toDouble() / viewport.raster.height)
    private val eye = camera.eye
    private val back = camera.toWorldDirection(0.0, 0.0, 1.0)

    /** Calls [action] with the clip-space position of the world-space point ([x], [y], [z]). */
    inline fun toClip(x: Double, y: Double, z: Double, action: (x: Double, y: Double, z: Double, w: Double) -> Unit) {
        val m = worldToClip
        action(
            m.m00 * x + m.m10 * y + m.m20 * z + m.m30,
            m.m01 * x + m.m11 * y + m.m21 * z + m.m31,
            m.m02 * x + m.m12 * y + m.m22 * z + m.m32,
            m.m03 * x + m.m13 * y + m.m23 * z + m.m33,
        )
    }

    /** Sets the clip-space position and the world position of [vertex] from the world-space point ([x], [y], [z]). */
    fun place(vertices: Vertices, vertex: Int, x: Double, y: Double, z: Double) {
        toClip(x, y, z) { clipX, clipY, clipZ, clipW ->
            vertices.set(vertex, Vertices.X, clipX)
            vertices.set(vertex, Vertices.Y, clipY)
            vertices.set(vertex, Vertices.Z, clipZ)
            vertices.set(vertex, Vertices.W, clipW)
        }
        vertices.set(vertex, Vertices.WORLD, x)
        vertices.set(vertex, Vertices.WORLD + 1, y)
        vertices.set(vertex, Vertices.WORLD + 2, z)
    }

    /** Sets position and attributes of [vertex] to those of vertex [from] of [mesh]. */
    fun place(vertices: Vertices, vertex: Int, mesh: Mesh, from: Int) {
        val p = mesh.positions
        place(vertices, vertex, p[3 * from].toDouble(), p[3 * from + 1].toDouble(), p[3 * from + 2].toDouble())
        vertices.setAttributes(vertex, mesh, from)
    }

    /** Positive if the viewer is on the side that [normal] points to, for a face with this vertex. */
    fun towardEye(vertices: Vertices, vertex: Int, normal: DoubleArray): Double = towardEye(
        vertices.get(vertex, Vertices.WORLD), vertices.get(vertex, Vertices.WORLD + 1),
        vertices.get(vertex, Vertices.WORLD + 2), normal[0], normal[1], normal[2],
    )

    /** Positive if the viewer is on the side that the normal points to, at the world-space point ([x], [y], [z]). */
    fun towardEye(x: Double, y: Double, z: Double, normalX: Double, normalY: Double, normalZ: Double): Double {
        if (!isPerspective) return normalX * back.x + normalY * back.y + normalZ * back.z
        return normalX * (eye.x() - x) + normalY * (eye.y() - y) + normalZ * (eye.z() - z)
    }

    private fun clipper(guard: Int) = Clipper(viewport.guardX(guard), viewport.guardY(guard), viewport.near)
}
