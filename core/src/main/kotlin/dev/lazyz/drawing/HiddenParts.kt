package dev.lazyz.drawing

/**
 * Finds the parts of a straight edge that faces hide. One edge at a time: [begin], then [behindTriangle] and
 * [behindPolygon] for each face that could be in front of it. Not thread safe.
 *
 * A point is hidden by a triangle if the ray from the camera meets the triangle before it. In [ViewSpace] these are
 * four conditions, each linear along the edge: it is inside three planes through the camera, and behind that of the
 * triangle. So the hidden part is an interval, exact up to the rounding of double precision, at any resolution. What is
 * nearer than the near plane is not drawn and hides nothing: for triangles of which a part is, this is a fifth
 * condition.
 *
 * Faces of which the edge is a side do not hide it. If a face has one end of the edge as a vertex, the distance of that
 * end from the face is 0 by definition, and not what rounding makes of it. Other faces hide only what is behind them by
 * more than [tolerance], so that faces that touch an edge do not hide it.
 *
 * @param places four numbers for each point, see [ViewSpace.place]
 * @param tolerance world units
 * @param isCounted whether it matters how many faces hide a part
 */
internal class HiddenParts(
    private val space: ViewSpace,
    private val places: DoubleArray,
    private val tolerance: Double,
    private val isCounted: Boolean = false,
) {
    /** The hidden parts of the edge: 0 is its first end and 1 its second. */
    val intervals: Intervals = Intervals()

    private var start = 0
    private var end = 0
    private var x0 = 0.0
    private var y0 = 0.0
    private var w0 = 0.0
    private var h0 = 0.0
    private var x1 = 0.0
    private var y1 = 0.0
    private var w1 = 0.0
    private var h1 = 0.0
    private var farthest = 0.0

    /** The tolerance in units of h. */
    private var margin = 0.0

    // The part of the edge that the conditions so far leave
    private val part = KeptPart()

    /** Whether one triangle hides the whole edge, so that others need not be examined. */
    private var isWhole = false

    private val crossings = Intervals()

    /** Begins with the edge between the points [start] and [end]; [distance] is that of its nearest visible point. */
    fun begin(start: Int, end: Int, distance: Double) {
        this.start = start
        this.end = end
        x0 = places[4 * start]
        y0 = places[4 * start + 1]
        w0 = places[4 * start + 2]
        h0 = places[4 * start + 3]
        x1 = places[4 * end]
        y1 = places[4 * end + 1]
        w1 = places[4 * end + 2]
        h1 = places[4 * end + 3]
        farthest = maxOf(space.distance(w0, h0), space.distance(w1, h1))
        margin = if (space.isPerspective) tolerance / distance else tolerance
        isWhole = false
        intervals.clear()
    }

    /** Adds the part that the triangle of the points [a], [b] and [c] hides. */
    fun behindTriangle(a: Int, b: Int, c: Int) {
        if (isWhole) return
        val hasStart = a == start || b == start || c == start
        val hasEnd = a == end || b == end || c == end
        if (hasStart && hasEnd) return
        val p = places
        val wa = p[4 * a + 2]
        val wb = p[4 * b + 2]
        val wc = p[4 * c + 2]
        val ha = p[4 * a + 3]
        val hb = p[4 * b + 3]
        val hc = p[4 * c + 3]
        val nearest = minOf(space.distance(wa, ha), space.distance(wb, hb), space.distance(wc, hc))
        if (nearest >= farthest) return

        // The planes through the camera and a side, and the determinant of the corners: twice the area in pixels,
        // times the three w
        val xa = p[4 * a]
        val ya = p[4 * a + 1]
        val xb = p[4 * b]
        val yb = p[4 * b + 1]
        val xc = p[4 * c]
        val yc = p[4 * c + 1]
        val ax = yb * wc - wb * yc
        val ay = wb * xc - xb * wc
        val aw = xb * yc - yb * xc
        val bx = yc * wa - wc * ya
        val by = wc * xa - xc * wa
        val bw = xc * ya - yc * xa
        val cx = ya * wb - wa * yb
        val cy = wa * xb - xa * wb
        val cw = xa * yb - ya * xb
        val whole = xa * ax + ya * ay + wa * aw
        if (!(StrictMath.abs(whole) > EDGE_ON * StrictMath.abs(wa * wb * wc))) return

        // The shares of the corners at both ends of the edge; they are linear in between
        val scale = 1.0 / whole
        val a0 = if (hasStart) share(a == start) else (x0 * ax + y0 * ay + w0 * aw) * scale
        val b0 = if (hasStart) share(b == start) else (x0 * bx + y0 * by + w0 * bw) * scale
        val c0 = if (hasStart) share(c == start) else (x0 * cx + y0 * cy + w0 * cw) * scale
        val a1 = if (hasEnd) share(a == end) else (x1 * ax + y1 * ay + w1 * aw) * scale
        val b1 = if (hasEnd) share(b == end) else (x1 * bx + y1 * by + w1 * bw) * scale
        val c1 = if (hasEnd) share(c == end) else (x1 * cx + y1 * cy + w1 * cw) * scale
        part.begin()
        part.keepPositive(a0 + SEAM, a1 + SEAM)
        part.keepPositive(b0 + SEAM, b1 + SEAM)
        part.keepPositive(c0 + SEAM, c1 + SEAM)
        if (part.isEmpty) return
        val height0 = a0 * ha + b0 * hb + c0 * hc
        val height1 = a1 * ha + b1 * hb + c1 * hc
        keepBehind(height0 - h0, height1 - h1, hasStart, hasEnd)
        if (nearest < space.near) part.keepPositive(space.beyondNear(w0, height0), space.beyondNear(w1, height1))
        if (part.high - part.low > LEAST_PART) intervals.add(part.low, part.high)
        isWhole = !isCounted && part.low == 0.0 && part.high == 1.0
    }

    private fun share(isCorner: Boolean) = if (isCorner) 1.0 else 0.0

    /** Keeps the part that is behind a plane; [gap0] and [gap1] say by how much both ends are. */
    private fun keepBehind(gap0: Double, gap1: Double, hasStart: Boolean, hasEnd: Boolean) = when {
        hasStart -> if (gap1 <= margin) part.clear() else Unit
        hasEnd -> if (gap0 <= margin) part.clear() else Unit
        else -> part.keepPositive(gap0 - margin, gap1 - margin)
    }

    /** Adds the parts that [face] hides. */
    fun behindPolygon(face: HidingPolygon) {
        val hasStart = face.has(start)
        val hasEnd = face.has(end)
        if (hasStart && hasEnd) return
        part.begin()
        val gap0 = face.height(x0, y0, w0) - h0
        val gap1 = face.height(x1, y1, w1) - h1
        keepBehind(gap0, gap1, hasStart, hasEnd)
        if (part.isEmpty) return
        val from = part.low
        val until = part.high

        // Between two crossings with the outline, all is inside or all is outside
        crossings.clear()
        for (contour in face.contours) {
            for (i in contour.indices step 4) addCrossing(contour, i, (i + 4) % contour.size, from, until)
        }
        crossings.add(until, until)
        crossings.join()
        var at = from
        for (i in 0 until crossings.count) {
            val next = crossings.from(i)
            if (next > at && isInside(face, (at + next) / 2)) intervals.add(at, next)
            at = maxOf(at, next)
        }
    }

    /**
     * Adds the place at which the edge crosses the side between the vertices of [contour] that are at the indices [a]
     * and [b], if it is between [from] and [until].
     */
    private fun addCrossing(contour: DoubleArray, a: Int, b: Int, from: Double, until: Double) {
        val side0 = side(contour, a, b, x0, y0, w0)
        val side1 = side(contour, a, b, x1, y1, w1)
        if ((side0 < 0.0) == (side1 < 0.0)) return
        val t = side0 / (side0 - side1)
        if (t > from && t < until) crossings.add(t, t)
    }

    /** Positive if a point is on one side of the plane through the camera and the vertices at [a] and [b] of [p]. */
    private fun side(p: DoubleArray, a: Int, b: Int, x: Double, y: Double, w: Double): Double =
        x * (p[a + 1] * p[b + 2] - p[a + 2] * p[b + 1]) +
            y * (p[a + 2] * p[b] - p[a] * p[b + 2]) +
            w * (p[a] * p[b + 1] - p[a + 1] * p[b])

    /** Whether the point [t] of the edge is inside [face] on the raster. */
    private fun isInside(face: HidingPolygon, t: Double): Boolean {
        val w = w0 + (w1 - w0) * t
        val x = (x0 + (x1 - x0) * t) / w
        val y = (y0 + (y1 - y0) * t) / w
        var windings = 0
        for (p in face.contours) {
            for (a in p.indices step 4) {
                val b = (a + 4) % p.size
                val ya = p[a + 1] / p[a + 2]
                val yb = p[b + 1] / p[b + 2]
                if ((ya <= y) == (yb <= y)) continue
                val xa = p[a] / p[a + 2]
                val xb = p[b] / p[b + 2]
                if (xa + (y - ya) / (yb - ya) * (xb - xa) > x) continue
                windings += if (ya < yb) 1 else -1
            }
        }
        return face.fillRule.isInside(windings)
    }

    companion object {
        /** Triangles of less than half this area in square pixels are seen from the side, and hide nothing. */
        private const val EDGE_ON = 1e-7

        /** A triangle that hides less of an edge only touches it, for example at an end. */
        const val LEAST_PART: Double = 1e-6

        /** How far a triangle extends beyond its sides, as a part of its size: neighbours leave no gap. */
        private const val SEAM = 1e-9
    }
}
