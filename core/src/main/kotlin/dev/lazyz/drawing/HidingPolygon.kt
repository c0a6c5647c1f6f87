package dev.lazyz.drawing

import dev.lazyz.geometry.FillRule

/**
 * The part of a polygon that is at or beyond the near plane, in [ViewSpace]. It has a plane: h as a function of the
 * other three numbers. Immutable.
 *
 * @property contours four numbers for each vertex, see [ViewSpace.place]
 */
internal class HidingPolygon private constructor(
    private val face: OutlinedFace,
    val contours: List<DoubleArray>,
    private val x: Double,
    private val y: Double,
    private val w: Double,
) {
    val fillRule: FillRule get() = face.fillRule

    /** Whether [point] is a vertex of the whole polygon. */
    fun has(point: Int): Boolean = face.has(point)

    /** Returns h of the point of the plane that is on the ray with these three numbers. */
    fun height(x: Double, y: Double, w: Double): Double = this.x * x + this.y * y + this.w * w

    companion object {
        /**
         * Returns the part of [face] in front of the camera, with the plane through three vertices of it that are far
         * apart; null if nothing is left or it is seen from the side.
         *
         * @param places four numbers for each point
         */
        fun of(face: OutlinedFace, places: DoubleArray, space: ViewSpace): HidingPolygon? {
            val contours = face.contours.map { cut(it, places, space) }
            val all = contours.flatMap { it.asIterable() }.toDoubleArray()
            val vertices = 0 until all.size / 4
            if (vertices.count() < 3) return null
            val a = 0
            val b = vertices.maxBy { square(all, a, it) }
            val c = vertices.maxBy { StrictMath.abs(area(all, a, b, it)) }
            val whole = area(all, a, b, c)
            val size = all[4 * a + 2] * all[4 * b + 2] * all[4 * c + 2]
            if (!(StrictMath.abs(whole) > LEAST_AREA * size)) return null

            // Cramer's rule
            fun column(k: Int, m: Int): Double {
                fun at(vertex: Int, place: Int) = all[4 * vertex + place]
                return at(a, 3) * (at(b, k) * at(c, m) - at(b, m) * at(c, k)) +
                    at(b, 3) * (at(c, k) * at(a, m) - at(c, m) * at(a, k)) +
                    at(c, 3) * (at(a, k) * at(b, m) - at(a, m) * at(b, k))
            }
            return HidingPolygon(
                face, contours, column(1, 2) / whole, column(2, 0) / whole, column(0, 1) / whole,
            )
        }

        /**
         * Returns the part of [contour] that is at or beyond the near plane (Sutherland and Hodgman). If it has several
         * parts, sides in the near plane connect them.
         */
        private fun cut(contour: IntArray, places: DoubleArray, space: ViewSpace): DoubleArray {
            val kept = DoubleArray(8 * contour.size)
            var size = 0
            for (i in contour.indices) {
                val a = 4 * contour[i]
                val b = 4 * contour[(i + 1) % contour.size]
                val fromA = space.beyondNear(places[a + 2], places[a + 3])
                val fromB = space.beyondNear(places[b + 2], places[b + 3])
                if (fromA >= 0.0) {
                    places.copyInto(kept, size, a, a + 4)
                    size += 4
                }
                if ((fromA >= 0.0) == (fromB >= 0.0)) continue
                val t = StrictMath.abs(fromA) / (StrictMath.abs(fromA) + StrictMath.abs(fromB))
                kept[size] = places[a] + t * (places[b] - places[a])
                kept[size + 1] = places[a + 1] + t * (places[b + 1] - places[a + 1])
                kept[size + 2] = if (space.isPerspective) space.near else 1.0
                kept[size + 3] = if (space.isPerspective) 1.0 else -space.near
                size += 4
            }
            return kept.copyOf(size)
        }

        /** Square of the distance of two vertices on the raster. */
        private fun square(p: DoubleArray, a: Int, b: Int): Double {
            val dx = p[4 * b] / p[4 * b + 2] - p[4 * a] / p[4 * a + 2]
            val dy = p[4 * b + 1] / p[4 * b + 2] - p[4 * a + 1] / p[4 * a + 2]
            return dx * dx + dy * dy
        }

        /** The determinant of three vertices: twice the area on the raster, times the three w. */
        private fun area(p: DoubleArray, a: Int, b: Int, c: Int): Double =
            p[4 * a] * (p[4 * b + 1] * p[4 * c + 2] - p[4 * b + 2] * p[4 * c + 1]) +
                p[4 * a + 1] * (p[4 * b + 2] * p[4 * c] - p[4 * b] * p[4 * c + 2]) +
                p[4 * a + 2] * (p[4 * b] * p[4 * c + 1] - p[4 * b + 1] * p[4 * c])

        /** Square pixels. */
        private const val LEAST_AREA = 1e-7
    }
}
