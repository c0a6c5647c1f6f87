package dev.lazyz.world.surface

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.geometry.PointBlocks
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Finds points of [source] by reading only those parts whose boxes extend far enough. The points of the parts that were
 * used last stay in memory, up to an eighth of the heap: directions that follow each other lead to the same parts.
 * Thread safe.
 */
internal class FarthestPart(private val source: MeshSource) {
    private val boxes: List<Box?> = List(source.partCount) { source.bounds(it) }

    /** The smallest box around all parts, relative to the origin of the source, or null if there are no vertices. */
    val bounds: Box? = boxes.filterNotNull().reduceOrNull(Box::union)

    private val recent = RecentPoints()

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
        val first = reaches.indices.maxByOrNull { reaches[it] } ?: return null
        if (boxes[first] == null) return null
        var best: Vector3d? = null
        var most = Double.NEGATIVE_INFINITY
        fun look(number: Int) {
            val points = points(number)
            for (at in points.indices step 3) {
                val product = x * points[at] + y * points[at + 1] + z * points[at + 2]
                if (product < most) continue
                val point = Vector3d(points[at].toDouble(), points[at + 1].toDouble(), points[at + 2].toDouble())
                if (product > most || PointBlocks.isBefore(point, checkNotNull(best))) best = point
                most = product
            }
        }

        // Begin with the most promising part, so that few others remain
        look(first)
        val others = reaches.indices.filter { it != first && boxes[it] != null && reaches[it] >= most }
        for (number in others.sortedByDescending { reaches[it] }) if (reaches[number] >= most) look(number)
        return best
    }

    /** Returns x, y, z of the different vertices of part [number] that its triangles use and that are finite. */
    private fun points(number: Int): FloatArray {
        synchronized(recent) { recent[number] }?.let { return it }
        val part = source.read(number, 1)
        val distinct = DistinctTriples(part.triangleCount)
        for (vertex in part.triangles) {
            val x = part.positions[3 * vertex]
            val y = part.positions[3 * vertex + 1]
            val z = part.positions[3 * vertex + 2]
            if (x.isFinite() && y.isFinite() && z.isFinite()) distinct.addPoint(x, y, z)
        }
        val points = FloatArray(3 * distinct.size) { Float.fromBits(distinct.get(it / 3, it % 3)) }
        synchronized(recent) { recent.add(number, points) }
        return points
    }

    /** The points of parts, by the number of the part; those that were not used for the longest time are dropped. */
    private class RecentPoints : LinkedHashMap<Int, FloatArray>(16, 0.75f, true) {
        private val most = Runtime.getRuntime().maxMemory() / 8
        private var bytes = 0L

        fun add(number: Int, points: FloatArray) {
            put(number, points)
            bytes += Float.SIZE_BYTES * points.size
        }

        override fun removeEldestEntry(eldest: Map.Entry<Int, FloatArray>): Boolean {
            val isFull = bytes > most
            if (isFull) bytes -= Float.SIZE_BYTES * eldest.value.size
            return isFull
        }
    }
}
