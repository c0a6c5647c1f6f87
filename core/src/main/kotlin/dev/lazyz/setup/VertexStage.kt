package dev.lazyz.setup

import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Vertices
import dev.lazyz.world.Camera
import dev.lazyz.world.Mesh
import dev.lazyz.world.Projection

/** What all vertices of a frame go through: from the world to clip space, and on to the raster. Immutable and thread safe. */
internal class VertexStage(camera: Camera, val viewport: Viewport) {
    val clipper: Clipper = clipper(ScreenGrid.GUARD)

    /** As [clipper], for lines, which are widened after they have been clipped. */
    val lineClipper: Clipper = clipper(ScreenGrid.LINE_GUARD)

    /** Whether w differs from vertex to vertex. */
    val isPerspective: Boolean = camera.projection is Projection.Perspective

    val worldToClip = camera.setUpMatrix(viewport.raster.width.toDouble() / viewport.raster.height)
    private val eye = camera.eye
    private val back = camera.toWorldDirection(0.0, 0.0, 1.0)

    /** Calls [action] with the position in clip space of a point of the world. */
    inline fun toClip(x: Double, y: Double, z: Double, action: (x: Double, y: Double, z: Double, w: Double) -> Unit) {
        val m = worldToClip
        action(
            m.m00 * x + m.m10 * y + m.m20 * z + m.m30,
            m.m01 * x + m.m11 * y + m.m21 * z + m.m31,
            m.m02 * x + m.m12 * y + m.m22 * z + m.m32,
            m.m03 * x + m.m13 * y + m.m23 * z + m.m33,
        )
    }

    /** Sets the clip-space and the world position of a vertex. */
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

    /** Makes vertex [vertex] that of [mesh] with number [from]. */
    fun place(vertices: Vertices, vertex: Int, mesh: Mesh, from: Int) {
        val p = mesh.positions
        place(vertices, vertex, p[3 * from].toDouble(), p[3 * from + 1].toDouble(), p[3 * from + 2].toDouble())
        vertices.setAttributes(vertex, mesh, from)
    }

    /** Positive if the viewer is on the side of [normal] of a face with this vertex. */
    fun towardEye(vertices: Vertices, vertex: Int, normal: DoubleArray): Double = towardEye(
        vertices.get(vertex, Vertices.WORLD), vertices.get(vertex, Vertices.WORLD + 1),
        vertices.get(vertex, Vertices.WORLD + 2), normal[0], normal[1], normal[2],
    )

    /** Positive if the viewer is on the side that a normal points to, at the point ([x], [y], [z]) of the world. */
    fun towardEye(x: Double, y: Double, z: Double, normalX: Double, normalY: Double, normalZ: Double): Double {
        if (!isPerspective) return normalX * back.x + normalY * back.y + normalZ * back.z
        return normalX * (eye.x() - x) + normalY * (eye.y() - y) + normalZ * (eye.z() - z)
    }

    private fun clipper(guard: Int) = Clipper(viewport.guardX(guard), viewport.guardY(guard), viewport.near)
}
