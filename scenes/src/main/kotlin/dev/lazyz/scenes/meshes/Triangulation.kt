package dev.lazyz.scenes.meshes

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import earcut4j.Earcut

/**
 * Triangulates polygons, using only the polygon's own corners.
 *
 * The polygon is projected along its normal (M. E. Newell's: the sum over the edges, see I. E. Sutherland, R. F.
 * Sproull and R. A. Schumacker, "A Characterization of Ten Hidden-Surface Algorithms", 1974), by dropping the
 * coordinate in which the normal is longest. A convex polygon becomes a fan around its first corner. Any other
 * polygon is triangulated by ear clipping (earcut4j). The triangles have the same orientation as the polygon.
 *
 * A polygon with no area, or with a corner that is NaN or infinite, also becomes a fan, so that it has the number of
 * triangles that a reader expects. A polygon that crosses itself becomes triangles within its outline.
 */
internal object Triangulation {
    /** Maximum corners of a polygon. A reader need not look at the corners of a larger one. */
    const val MAX_CORNERS = 1 shl 18

    /** Maximum corners of a concave polygon, for which ear clipping may take quadratic time. */
    const val MAX_CONCAVE_CORNERS = 4096

    /** Maximum corners of a polygon that crosses itself, if only once: ear clipping takes cubic time, or more. */
    const val MAX_CROSSING_CORNERS = 256

    /** What is wrong with polygons without triangles. */
    const val TOO_MANY: String = "too many for one that is concave or crosses itself"

    /**
     * Returns the triangles, three corner numbers each, of the polygon with the corners [xyz] (x, y, z for each), or
     * null if there are too many corners: more than [MAX_CONCAVE_CORNERS] of a concave polygon, more than
     * [MAX_CROSSING_CORNERS] of one that crosses itself, or [MAX_CORNERS]. Fewer than three corners make no triangle.
     *
     * @param step counts steps of work; throws to end it
     */
    fun triangles(xyz: DoubleArray, step: (Int) -> Unit = {}): IntArray? {
        val corners = xyz.size / 3
        if (corners <= 3) return fan(corners)
        if (corners > MAX_CORNERS) return null
        val flat = project(xyz) ?: return fan(corners)
        if (isConvex(flat)) return fan(corners)
        if (corners > MAX_CONCAVE_CORNERS) return null
        if (corners > MAX_CROSSING_CORNERS && Crossings.areIn(flat, step)) return null
        step(corners * corners / STEPS_A_PAIR)
        val ears = Earcut.earcut(flat)
        if (ears.isEmpty()) return fan(corners)
        return counterClockwise(flat, ears)
    }

    /** Two corners are compared in this part of a step. */
    private const val STEPS_A_PAIR = 8

    private fun fan(corners: Int): IntArray {
        val triangles = IntArray(3 * maxOf(corners - 2, 0))
        for (i in 0 until corners - 2) {
            triangles[3 * i + 1] = i + 1
            triangles[3 * i + 2] = i + 2
        }
        return triangles
    }

    /** Returns x, y for each corner, counter-clockwise, or null if the polygon has no normal. */
    private fun project(xyz: DoubleArray): DoubleArray? {
        // Newell's normal: twice the areas of the polygon's projections on the three coordinate planes. Coordinates
        // are relative to corner 0, so that a polygon far from the origin loses no precision
        val local = DoubleArray(xyz.size) { xyz[it] - xyz[it % 3] }
        val normal = DoubleArray(3)
        var from = local.size - 3
        for (to in local.indices step 3) {
            for (axis in 0 until 3) {
                val a = (axis + 1) % 3
                val b = (axis + 2) % 3
                normal[axis] += (local[from + a] - local[to + a]) * (local[from + b] + local[to + b])
            }
            from = to
        }
        val longest = (0 until 3).maxByOrNull { StrictMath.abs(normal[it]) } ?: 0
        if (!normal.all { it.isFinite() } || normal[longest] == 0.0) return null

        val first = if (normal[longest] > 0.0) (longest + 1) % 3 else (longest + 2) % 3
        val second = 3 - longest - first
        return DoubleArray(xyz.size / 3 * 2) { local[it / 2 * 3 + if (it % 2 == 0) first else second] }
    }

    /** Whether the outline turns left or continues straight at every corner, and goes around only once. */
    private fun isConvex(xy: DoubleArray): Boolean {
        var turnsOfDirection = 0
        var lastSign = 0
        val corners = xy.size / 2
        for (i in 0..corners) {
            val a = 2 * (i % corners)
            val b = 2 * ((i + 1) % corners)
            val c = 2 * ((i + 2) % corners)
            val dx = xy[b] - xy[a]
            val dy = xy[b + 1] - xy[a + 1]
            val nextX = xy[c] - xy[b]
            val nextY = xy[c + 1] - xy[b + 1]
            val turn = dx * nextY - dy * nextX
            val isBackward = turn == 0.0 && dx * nextX + dy * nextY < 0.0
            if (turn < 0.0 || isBackward) return false

            // The x direction of a convex outline changes its sign only twice
            val sign = if (dx > 0.0) {
                1
            } else if (dx < 0.0) {
                -1
            } else {
                0
            }
            if (sign != 0 && lastSign != 0 && sign != lastSign) turnsOfDirection++
            if (sign != 0) lastSign = sign
        }
        return turnsOfDirection <= 2
    }

    /** Reverses clockwise triangles. Triangles without area stay unchanged. */
    private fun counterClockwise(xy: DoubleArray, triangles: List<Int>): IntArray {
        val result = triangles.toIntArray()
        for (i in result.indices step 3) {
            val a = 2 * result[i]
            val b = 2 * result[i + 1]
            val c = 2 * result[i + 2]
            val area = (xy[b] - xy[a]) * (xy[c + 1] - xy[a + 1]) - (xy[b + 1] - xy[a + 1]) * (xy[c] - xy[a])
            if (area < 0.0) {
                result[i + 1] = c / 2
                result[i + 2] = b / 2
            }
        }
        return result
    }
}

/** Finds out whether the outline of a polygon in the plane crosses itself. Edges that only touch do not cross. */
internal object Crossings {
    /**
     * Whether the outline with the corners [xy] crosses itself. The time is quadratic in the number of corners.
     *
     * @param step counts steps of work; throws to end it
     */
    fun areIn(xy: DoubleArray, step: (Int) -> Unit): Boolean {
        val corners = xy.size / 2
        for (i in 0 until corners) {
            step(corners - i)
            val a = 2 * i
            val b = 2 * ((i + 1) % corners)
            val left = minOf(xy[a], xy[b])
            val right = maxOf(xy[a], xy[b])
            for (j in i + 2 until corners) {
                val c = 2 * j
                val d = 2 * ((j + 1) % corners)
                if ((xy[c] < left && xy[d] < left) || (xy[c] > right && xy[d] > right)) continue
                if (areApart(xy, a, b, c, d) && areApart(xy, c, d, a, b)) return true
            }
        }
        return false
    }

    /** Whether the corners at [c] and [d] are on different sides of the line from [a] to [b]. */
    private fun areApart(xy: DoubleArray, a: Int, b: Int, c: Int, d: Int): Boolean {
        val first = side(xy, a, b, c)
        val second = side(xy, a, b, d)
        return (first < 0.0 && second > 0.0) || (first > 0.0 && second < 0.0)
    }

    private fun side(xy: DoubleArray, a: Int, b: Int, c: Int): Double =
        (xy[b] - xy[a]) * (xy[c + 1] - xy[a + 1]) - (xy[b + 1] - xy[a + 1]) * (xy[c] - xy[a])
}

/**
 * Triangulates polygons, and leaves out those whose vertices are missing. Not thread safe.
 *
 * @param vertexCount number of vertices that are there
 * @param positions the positions of the vertices
 */
internal class PolygonCutting(
    private val source: Source,
    private val vertexCount: Int,
    private val positions: VertexPositions,
) {
    private var withoutVertices = 0

    /** Adds the corners of the triangles of [polygon] to [corners], as numbers among the corners of all [polygons]. */
    fun cut(polygons: Polygons, polygon: Int, corners: Ints) {
        val start = polygons.start(polygon)
        val count = polygons.end(polygon) - start
        source.step(count)
        if (!haveVertices(polygons, start, count)) {
            withoutVertices++
        } else if (count == 3) {
            corners.add(start, start + 1, start + 2)
        } else {
            val isSmall = count <= Triangulation.MAX_CORNERS
            val local = if (isSmall) Triangulation.triangles(xyz(polygons, start, count), source::step) else null
            if (local == null) {
                source.warn("", "a face of $count corners", ", ${Triangulation.TOO_MANY}, is left out")
            } else {
                for (corner in local) corners.add(start + corner)
            }
        }
    }

    private fun xyz(polygons: Polygons, start: Int, count: Int): DoubleArray =
        DoubleArray(3 * count) { positions.get(polygons.vertex(start + it / 3), it % 3).toDouble() }

    private fun haveVertices(polygons: Polygons, start: Int, count: Int): Boolean {
        for (corner in start until start + count) if (polygons.vertex(corner) >= vertexCount) return false
        return true
    }

    /** Reports the polygons without vertices. */
    fun warn() {
        if (withoutVertices > 0) {
            source.warn("$withoutVertices faces are left out, because some of their vertices are missing")
        }
    }
}

/** Positions by number. */
internal fun interface VertexPositions {
    /** Returns coordinate [axis], 0..2, of [vertex]. */
    fun get(vertex: Int, axis: Int): Float
}
