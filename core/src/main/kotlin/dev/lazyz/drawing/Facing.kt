package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.world.Camera
import dev.lazyz.world.Projection

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
