package dev.lazyz.geometry

import java.util.BitSet
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Points given as x, y, z triples, with a box around each block of points. So the farthest point along a direction is
 * found without a look at most of the points: only blocks whose box extends far enough are searched.
 *
 * Points with a NaN or infinite coordinate are ignored. The array is not copied. Immutable and thread safe. Cost of the
 * constructor: linear in the number of points and of their uses; memory: 24 bytes a block, and a bit a point if some
 * are not used.
 *
 * @param uses numbers of the points that count, or null if all do
 */
internal class PointBlocks(private val xyz: FloatArray, uses: IntArray? = null) {
    /** The points that count, or null if all do. */
    private val used: BitSet? = uses?.let { numbers ->
        val set = BitSet(xyz.size / 3)
        for (number in numbers) set.set(number)
        set.takeIf { it.cardinality() < xyz.size / 3 }
    }

    private val count = (xyz.size / 3 + SIZE - 1) / SIZE

    /** Six numbers for each block: least x, y, z, greatest x, y, z. A block without points that count has NaN. */
    private val boxes = FloatArray(6 * count)

    /** The smallest box around all points that count, or null if there is none. */
    val bounds: Box?

    init {
        val all = Extent()
        val one = Extent()
        for (block in 0 until count) {
            one.clear()
            one.include(block)
            one.store(block)
            all.include(one)
        }
        bounds = all.box()
    }

    /**
     * Returns the point whose dot product with [direction] is greatest, or null if there is none; of several, the first
     * in the order of x, then y, then z, so that the result does not depend on the order of the points. The direction
     * can have any finite length. A new vector for each call.
     */
    fun farthest(direction: Vector3dc): Vector3d? {
        // Begin with the most promising block, so that few others remain
        val search = Search(direction.x(), direction.y(), direction.z())
        var first = -1
        var reach = Double.NEGATIVE_INFINITY
        for (block in 0 until count) {
            val other = search.reach(block)
            if (other > reach) {
                first = block
                reach = other
            }
        }
        if (first < 0) return null
        search.look(first)
        for (block in 0 until count) if (search.reach(block) >= search.most) search.look(block)
        val at = 3 * search.point
        return if (at < 0) null else Vector3d(xyz[at].toDouble(), xyz[at + 1].toDouble(), xyz[at + 2].toDouble())
    }

    private inner class Search(private val x: Double, private val y: Double, private val z: Double) {
        var point = -1
        var most = Double.NEGATIVE_INFINITY

        /** Index of the bound of x that is greatest along the direction, and so on. */
        private val cornerX = if (x < 0.0) 0 else 3
        private val cornerY = if (y < 0.0) 1 else 4
        private val cornerZ = if (z < 0.0) 2 else 5

        /**
         * Returns the dot product for the farthest corner of a block. Rounding keeps order, so no point of the block
         * has a greater one.
         */
        fun reach(block: Int): Double =
            x * boxes[6 * block + cornerX] + y * boxes[6 * block + cornerY] + z * boxes[6 * block + cornerZ]

        fun look(block: Int) {
            for (i in 3 * SIZE * block until minOf(3 * SIZE * (block + 1), xyz.size) step 3) {
                val product = x * xyz[i] + y * xyz[i + 1] + z * xyz[i + 2]
                if (product >= most && counts(i) && (product > most || isBefore(i, 3 * point))) {
                    most = product
                    point = i / 3
                }
            }
        }
    }

    private fun isBefore(i: Int, j: Int): Boolean = when {
        xyz[i] != xyz[j] -> xyz[i] < xyz[j]
        xyz[i + 1] != xyz[j + 1] -> xyz[i + 1] < xyz[j + 1]
        else -> xyz[i + 2] < xyz[j + 2]
    }

    private fun counts(i: Int): Boolean =
        xyz[i].isFinite() && xyz[i + 1].isFinite() && xyz[i + 2].isFinite() && used?.get(i / 3) != false

    private inner class Extent {
        private var minX = 0f
        private var minY = 0f
        private var minZ = 0f
        private var maxX = 0f
        private var maxY = 0f
        private var maxZ = 0f

        init {
            clear()
        }

        fun clear() {
            minX = Float.POSITIVE_INFINITY
            minY = Float.POSITIVE_INFINITY
            minZ = Float.POSITIVE_INFINITY
            maxX = Float.NEGATIVE_INFINITY
            maxY = Float.NEGATIVE_INFINITY
            maxZ = Float.NEGATIVE_INFINITY
        }

        fun include(block: Int) {
            for (i in 3 * SIZE * block until minOf(3 * SIZE * (block + 1), xyz.size) step 3) {
                if (!counts(i)) continue
                minX = minOf(minX, xyz[i])
                minY = minOf(minY, xyz[i + 1])
                minZ = minOf(minZ, xyz[i + 2])
                maxX = maxOf(maxX, xyz[i])
                maxY = maxOf(maxY, xyz[i + 1])
                maxZ = maxOf(maxZ, xyz[i + 2])
            }
        }

        fun include(other: Extent) {
            minX = minOf(minX, other.minX)
            minY = minOf(minY, other.minY)
            minZ = minOf(minZ, other.minZ)
            maxX = maxOf(maxX, other.maxX)
            maxY = maxOf(maxY, other.maxY)
            maxZ = maxOf(maxZ, other.maxZ)
        }

        fun store(block: Int) {
            if (minX > maxX) return boxes.fill(Float.NaN, 6 * block, 6 * block + 6)
            boxes[6 * block] = minX
            boxes[6 * block + 1] = minY
            boxes[6 * block + 2] = minZ
            boxes[6 * block + 3] = maxX
            boxes[6 * block + 4] = maxY
            boxes[6 * block + 5] = maxZ
        }

        fun box(): Box? = if (minX > maxX) {
            null
        } else {
            Box(
                minX.toDouble(), minY.toDouble(), minZ.toDouble(), maxX.toDouble(), maxY.toDouble(), maxZ.toDouble(),
            )
        }
    }

    companion object {
        /** Points in a block. */
        private const val SIZE = 256

        /** Whether [a] is before [b] in the order of x, then y, then z. */
        fun isBefore(a: Vector3dc, b: Vector3dc): Boolean = when {
            a.x() != b.x() -> a.x() < b.x()
            a.y() != b.y() -> a.y() < b.y()
            else -> a.z() < b.z()
        }
    }
}
