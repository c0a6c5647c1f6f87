package dev.lazyz.world.surface

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.PointBlocks
import org.joml.Vector3d
import org.joml.Vector3dc

/** Finds points of [source] by reading only those parts whose boxes extend far enough. Thread safe. */
internal class FarthestPart(private val source: MeshSource) {
    /** The parts that were read last: directions that follow each other lead to the same ones. */
    private val recent = object : LinkedHashMap<Int, Mesh>(16, 0.75f, true) {
        override fun removeEldestEntry(eldest: Map.Entry<Int, Mesh>?): Boolean = size > RECENT
    }

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
        for (number in boxes.indices.filter { boxes[it] != null }.sortedByDescending { reaches[it] }) {
            if (reaches[number] < most) break
            val part = part(number)
            val positions = part.positions
            for (vertex in part.triangles) {
                val px = positions[3 * vertex]
                val py = positions[3 * vertex + 1]
                val pz = positions[3 * vertex + 2]
                val product = x * px + y * py + z * pz
                if (!(product >= most) || !(px.isFinite() && py.isFinite() && pz.isFinite())) continue
                val point = Vector3d(px.toDouble(), py.toDouble(), pz.toDouble())
                if (product > most || PointBlocks.isBefore(point, checkNotNull(best))) best = point
                most = product
            }
        }
        return best
    }

    private fun part(number: Int): Mesh {
        synchronized(recent) { recent[number] }?.let { return it }
        return source.part(number).also { synchronized(recent) { recent[number] = it } }
    }

    private companion object {
        /** Number of parts that are kept in memory. */
        const val RECENT = 32
    }
}
