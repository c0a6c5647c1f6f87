package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
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

/**
 * Which faces of [model] show their front to [camera], which is relative to the model's origin. Passes [checkpoint] for
 * each face. Immutable.
 */
internal class Facing(private val model: EdgeModel, camera: Camera, checkpoint: Checkpoint) {
    private val fronts = BooleanArray(model.faceCount)

    /** Faces without a normal. */
    private val isLine = BooleanArray(model.faceCount)

    init {
        val isPerspective = camera.projection is Projection.Perspective
        val back = camera.toWorldDirection(0.0, 0.0, 1.0)
        val eye = camera.eye
        val normal = DoubleArray(3)
        for (face in fronts.indices) {
            checkpoint.pass()
            val at = 3 * (model.corner(face) ?: continue)
            model.normal(face, normal)
            val p = model.points
            val toward = if (isPerspective) {
                normal[0] * (eye.x() - p[at]) + normal[1] * (eye.y() - p[at + 1]) + normal[2] * (eye.z() - p[at + 2])
            } else {
                normal[0] * back.x + normal[1] * back.y + normal[2] * back.z
            }
            fronts[face] = if (face < model.triangleCount) toward > 0.0 else toward >= 0.0
            isLine[face] = normal.all { it == 0.0 }
        }
    }

    /** Whether [face] shows its front. */
    fun isFront(face: Int): Boolean = fronts[face]

    /** Whether one face of [edge] shows its front and the other its back. */
    fun isSilhouette(edge: Int): Boolean {
        val first = model.firstFace(edge)
        val second = model.secondFace(edge)
        if (second < 0 || isLine[first] || isLine[second]) return false
        val differs = fronts[first] != fronts[second]
        return differs != model.isTwisted(edge)
    }

    /** Whether a face of [edge] is drawn. */
    fun isDrawn(edge: Int): Boolean {
        val second = model.secondFace(edge)
        return isDrawnFace(model.firstFace(edge)) || (second >= 0 && isDrawnFace(second)) ||
            (second == EdgeModel.MANY_FACES && model.moreFaces(edge).any(::isDrawnFace))
    }

    private fun isDrawnFace(face: Int) = model.isDrawn(face, fronts[face])

    /** Whether [face] hides what is behind it. */
    fun isHiding(face: Int): Boolean = model.isHiding(face, fronts[face])
}
