package dev.lazyz.world.surface

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.PointBlocks
import org.joml.Vector3d
import org.joml.Vector3dc

/** Finds points of [source] by reading only those parts whose boxes extend far enough. Thread safe. */
internal class FarthestPart(private val source: MeshSource) {
    private val boxes: List<Box?> = List(source.partCount) { source.bounds(it) }

    /** The smallest box around all parts, relative to the origin of the source, or null if there are no vertices. */
    val bounds: Box? = boxes.filterNotNull().reduceOrNull(Box::union)

    /**
     * Returns the vertex that is farthest along [direction], relative to the origin of the source; of several the one
     * that [PointBlocks] defines. Null if there are no vertices.
     */
    fun farthest(direction: Vector3dc): Vector3d? {
        val x = direction.x()
        val y = direction.y()
        val z = direction.z()

        // Rounding keeps order, so no point of a part has a greater product than the farthest corner of its box
        val reaches = DoubleArray(boxes.size) { number ->
            val corner = boxes[number]?.farthest(direction)
            if (corner == null) Double.NEGATIVE_INFINITY else x * corner.x + y * corner.y + z * corner.z
        }
        var best: Vector3d? = null
        var most = Double.NEGATIVE_INFINITY
        val first = reaches.indices.maxByOrNull { reaches[it] } ?: return null
        for (number in sequenceOf(first) + reaches.indices.asSequence().filter { it != first }) {
            if (boxes[number] == null || reaches[number] < most) continue
            val point = source.part(number).farthestFromOrigin(direction) ?: continue
            val product = x * point.x + y * point.y + z * point.z
            if (best == null || product > most || (product == most && PointBlocks.isBefore(point, best))) {
                most = product
                best = point
            }
        }
        return best
    }
}
