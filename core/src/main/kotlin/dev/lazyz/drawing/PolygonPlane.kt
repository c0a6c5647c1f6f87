package dev.lazyz.drawing

/** The plane of a polygon in [ViewSpace]: h as a function of the other three numbers. Immutable. */
internal class PolygonPlane private constructor(private val x: Double, private val y: Double, private val w: Double) {
    /** Returns h of the point of the plane that is on the ray with these three numbers. */
    fun height(x: Double, y: Double, w: Double): Double = this.x * x + this.y * y + this.w * w

    companion object {
        /**
         * Returns the plane through three vertices of [face] that are far apart, or null if it is seen from the side or
         * crosses the plane of the camera.
         */
        fun of(face: OutlinedFace, places: DoubleArray): PolygonPlane? {
            val all = face.contours.flatMap { it.asIterable() }
            if (all.size < 3 || all.any { !(places[4 * it + 2] > 0.0) }) return null
            val a = all[0]
            val b = all.maxBy { square(places, a, it) }
            val c = all.maxBy { StrictMath.abs(area(places, a, b, it)) }
            val whole = area(places, a, b, c)
            val size = places[4 * a + 2] * places[4 * b + 2] * places[4 * c + 2]
            if (!(StrictMath.abs(whole) > LEAST_AREA * size)) return null

            // Cramer's rule
            fun column(k: Int, m: Int): Double {
                fun at(point: Int, place: Int) = places[4 * point + place]
                return at(a, 3) * (at(b, k) * at(c, m) - at(b, m) * at(c, k)) +
                    at(b, 3) * (at(c, k) * at(a, m) - at(c, m) * at(a, k)) +
                    at(c, 3) * (at(a, k) * at(b, m) - at(a, m) * at(b, k))
            }
            return PolygonPlane(column(1, 2) / whole, column(2, 0) / whole, column(0, 1) / whole)
        }

        /** Square of the distance of two points on the raster. */
        private fun square(places: DoubleArray, a: Int, b: Int): Double {
            val dx = places[4 * b] / places[4 * b + 2] - places[4 * a] / places[4 * a + 2]
            val dy = places[4 * b + 1] / places[4 * b + 2] - places[4 * a + 1] / places[4 * a + 2]
            return dx * dx + dy * dy
        }

        /** The determinant of three points: twice the area on the raster, times the three w. */
        private fun area(p: DoubleArray, a: Int, b: Int, c: Int): Double =
            p[4 * a] * (p[4 * b + 1] * p[4 * c + 2] - p[4 * b + 2] * p[4 * c + 1]) +
                p[4 * a + 1] * (p[4 * b + 2] * p[4 * c] - p[4 * b] * p[4 * c + 2]) +
                p[4 * a + 2] * (p[4 * b] * p[4 * c + 1] - p[4 * b + 1] * p[4 * c])

        /** Square pixels. */
        private const val LEAST_AREA = 1e-7
    }
}
