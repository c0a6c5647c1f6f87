package dev.lazyz.sections

import dev.lazyz.geometry.DistinctTriples

/**
 * Directed segments in a plane, and the closed contours that they make. Points are equal if their coordinates are. Two
 * segments of opposite direction between the same points cancel each other; segments that are there twice count once.
 * Not thread safe. Cost: linear.
 */
internal class Contours {
    private val points = DistinctTriples()
    private val pairs = DistinctTriples()

    /** By pair of points: how many more segments lead from the lower number to the higher than back. */
    private var balance = IntArray(16)

    private var next = IntArray(0)
    private var firstAt = IntArray(0)
    private var isUsed = BooleanArray(0)

    /** The segments that are in no closed contour: x, y and z of both ends. Known after [loops]. */
    val openSegments: MutableList<FloatArray> = ArrayList()

    /** Number of contours that do not close. Known after [loops]. */
    var openCount: Int = 0
        private set

    /** Adds the segment from [from] to [to]. */
    fun add(from: FloatArray, to: FloatArray) {
        val a = number(from)
        val b = number(to)
        if (a == b || a < 0 || b < 0) return
        val pair = pairs.add(minOf(a, b), maxOf(a, b), 0)
        if (pair == balance.size) balance = balance.copyOf(2 * pair)
        balance[pair] += if (a < b) 1 else -1
    }

    /** Adds segments given as x, y and z of both ends. */
    fun addAll(segments: List<FloatArray>) {
        for (segment in segments) add(segment.copyOfRange(0, 3), segment.copyOfRange(3, 6))
    }

    private fun number(point: FloatArray): Int = if (point.all { it.isFinite() }) {
        points.addPoint(point[0], point[1], point[2])
    } else {
        -1
    }

    /** Returns the closed contours, x, y and z of each point. */
    fun loops(): List<FloatArray> {
        connect()

        // Where an odd number of segments meet, an open contour begins: first where one of them leads away
        val degree = IntArray(points.size)
        for (pair in 0 until pairs.size) {
            if (balance[pair] == 0) continue
            degree[pairs.get(pair, 0)]++
            degree[pairs.get(pair, 1)]++
        }
        for (isDirected in listOf(true, false)) {
            for (point in degree.indices) {
                if (degree[point] % 2 == 0 || unused(point, isDirected) < 0) continue
                val path = path(point, isClosed = false)
                openCount++
                for (i in 1 until path.size) addOpen(path[i - 1], path[i])
                degree[path.first()]--
                degree[path.last()]--
            }
        }

        // At all points, an even number of segments is left: all other paths are closed
        val loops = ArrayList<FloatArray>()
        for (pair in 0 until pairs.size) {
            if (balance[pair] == 0 || isUsed[pair]) continue
            val path = path(pairs.get(pair, if (balance[pair] > 0) 0 else 1), isClosed = true)
            val forward = (1 until path.size).count { isForward(path[it - 1], path[it]) }
            val loop = if (2 * forward >= path.size - 1) path.drop(1) else path.drop(1).reversed()
            if (loop.size >= 3) loops += FloatArray(3 * loop.size) { Float.fromBits(points.get(loop[it / 3], it % 3)) }
        }
        return loops
    }

    /** Adds the segment between [from] and [to] to the open ones, in its own direction. */
    private fun addOpen(from: Int, to: Int) {
        openSegments += if (isForward(from, to)) place(from) + place(to) else place(to) + place(from)
    }

    /** Lists the pairs at each point: those of point p are a chain of numbers 2 x pair + end. */
    private fun connect() {
        isUsed = BooleanArray(pairs.size)
        firstAt = IntArray(points.size) { -1 }
        next = IntArray(2 * pairs.size)
        for (i in next.indices.reversed()) {
            val point = pairs.get(i / 2, i % 2)
            next[i] = firstAt[point]
            firstAt[point] = i
        }
    }

    /** Returns the points of a path of unused segments that ends where it began, if [isClosed], or where it must. */
    private fun path(start: Int, isClosed: Boolean): List<Int> {
        val path = arrayListOf(start)
        var at = start
        while (true) {
            var step = unused(at, true)
            if (step < 0) step = unused(at, false)
            if (step < 0) return path
            isUsed[step / 2] = true
            at = pairs.get(step / 2, 1 - step % 2)
            path += at
            if (isClosed && at == start) return path
        }
    }

    /** Returns an unused segment at [point], which leads away from it if [isDirected]; -1 if there is none. */
    private fun unused(point: Int, isDirected: Boolean): Int {
        // Those that are used up at the beginning of the chain are not looked at again
        while (firstAt[point] >= 0 && isGone(firstAt[point] / 2)) firstAt[point] = next[firstAt[point]]
        var i = firstAt[point]
        while (i >= 0) {
            val leadsAway = (balance[i / 2] > 0) == (i % 2 == 0)
            if (!isGone(i / 2) && (leadsAway || !isDirected)) return i
            i = next[i]
        }
        return -1
    }

    private fun isGone(pair: Int): Boolean = isUsed[pair] || balance[pair] == 0

    private fun isForward(from: Int, to: Int): Boolean {
        val pair = pairs.add(minOf(from, to), maxOf(from, to), 0)
        return (balance[pair] > 0) == (from < to)
    }

    private fun place(point: Int) = FloatArray(3) { Float.fromBits(points.get(point, it)) }
}
