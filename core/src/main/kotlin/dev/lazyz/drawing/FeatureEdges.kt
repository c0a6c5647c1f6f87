package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.Camera
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh

/**
 * Finds the edges of a mesh that a line drawing shows, without regard to what is hidden. Vertices at the same position
 * count as one vertex. Immutable and thread safe.
 *
 * - A *boundary* is an edge of one triangle.
 * - A *crease* is an edge of two triangles whose normals differ by more than [creaseAngle] degrees. An edge of three or
 *   more triangles counts as a crease, too.
 * - A *silhouette* is an edge of two triangles of which one shows its front and the other its back to the camera.
 *
 * Duplicate triangles count once. Triangles with two corners at the same position or with a position that is NaN or
 * infinite are ignored. A triangle whose corners are in one line belongs to its edges, but makes no crease and no
 * silhouette. If two neighbours have opposite orders of vertices, one of them is taken reversed.
 *
 * @property creaseAngle degrees, 0..180
 * @throws IllegalArgumentException if [creaseAngle] is out of range
 */
public class FeatureEdges @JvmOverloads constructor(public val creaseAngle: Double = DEFAULT_CREASE_ANGLE) {
    init {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
    }

    /**
     * Returns the creases and boundaries of [mesh] and, if [camera] is not null, its silhouettes. Each edge is one
     * segment; vertices are numbered by position. Cost: linear in the size of the mesh.
     */
    @JvmOverloads
    public fun of(mesh: Mesh, camera: Camera? = null): Lines {
        val model = EdgeModel(listOf(mesh), creaseAngle, Checkpoint.NONE)
        val facing = camera?.let { Facing(model, it.relativeTo(model.origin), Checkpoint.NONE) }
        val found = (0 until model.edgeCount).filter { model.isFeature(it) || facing?.isSilhouette(it) == true }
        val segments = IntArray(2 * found.size) { model.end(found[it / 2], it % 2) }
        return Lines(model.points, segments, origin = Vectors.minus(model.origin, Vectors.ZERO))
    }

    override fun toString(): String = "FeatureEdges(creases from $creaseAngle degrees)"

    public companion object {
        /** The default of [creaseAngle], degrees. */
        public const val DEFAULT_CREASE_ANGLE: Double = 30.0
    }
}
