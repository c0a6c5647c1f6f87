package dev.lazyz.drawing

import dev.lazyz.drawing.EdgeDrawing.DrawnCap
import dev.lazyz.endIfInterrupted
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.world.surface.Polygon
import kotlin.math.abs
import kotlin.math.floor
import org.joml.Vector3dc

/**
 * Caps in [space]. A corner has five numbers: those of [ViewSpace], and its place in the hatching, which is linear
 * along sides, too. Immutable.
 *
 * @param origin the origin of shading, as in the scene
 */
internal class CapView(private val space: ViewSpace, private val origin: Vector3dc) {
    /** Returns [cap] as the raster shows it; null if it shows its back, or is elsewhere. */
    fun of(cap: Polygon): DrawnCap? {
        if (!cap.contours.all { contour -> contour.all { it.isFinite } }) return null
        val hatching = cap.material.shader as? Hatching
        val period = hatching?.period ?: 1.0
        val contours = cap.contours.map { contour ->
            val corners = DoubleArray(SIZE * contour.size)
            for ((i, vertex) in contour.withIndex()) {
                space.place(vertex.x, vertex.y, vertex.z, corners, SIZE * i)
                val sum = (vertex.x - origin.x()) + (vertex.y - origin.y()) + (vertex.z - origin.z())
                corners[SIZE * i + PLACE] = sum / period
            }
            clipped(corners)
        }.filter { it.size >= 3 * SIZE }
        val places = contours.map(::places)

        // Counter-clockwise contours have a negative area if rows are counted downward
        if (!(places.sumOf(::area) < 0.0)) return null
        return DrawnCap(cap, places, if (hatching == null) emptyList() else stripes(contours, hatching.share))
    }

    /** Returns the part of a contour that is between the near and the far plane and near the raster. */
    private fun clipped(contour: DoubleArray): DoubleArray {
        val right = space.raster.width + MARGIN
        val bottom = space.raster.height + MARGIN
        return contour.cut { space.beyondNear(it[2], it[3]) }.cut { space.far - space.distance(it[2], it[3]) }
            .cut { it[0] + MARGIN * it[2] }.cut { right * it[2] - it[0] }
            .cut { it[1] + MARGIN * it[2] }.cut { bottom * it[2] - it[1] }
    }

    /** Returns the part of a contour where [height], which is linear, is not negative (Sutherland and Hodgman). */
    private inline fun DoubleArray.cut(height: (DoubleArray) -> Double): DoubleArray {
        val kept = ArrayList<DoubleArray>()
        for (i in indices step SIZE) {
            val a = copyOfRange(i, i + SIZE)
            val next = (i + SIZE) % size
            val b = copyOfRange(next, next + SIZE)
            val heightA = height(a)
            val heightB = height(b)
            if (heightA >= 0.0) kept += a
            if ((heightA >= 0.0) != (heightB >= 0.0)) kept += mixed(a, b, heightA / (heightA - heightB))
        }
        return DoubleArray(SIZE * kept.size) { kept[it / SIZE][it % SIZE] }
    }

    private fun mixed(a: DoubleArray, b: DoubleArray, t: Double) = DoubleArray(SIZE) { a[it] + t * (b[it] - a[it]) }

    private fun places(contour: DoubleArray) = DoubleArray(2 * (contour.size / SIZE)) {
        contour[SIZE * (it / 2) + it % 2] / contour[SIZE * (it / 2) + 2]
    }

    /** Twice the area in pixels. */
    private fun area(places: DoubleArray): Double {
        var sum = 0.0
        for (i in places.indices step 2) {
            val next = (i + 2) % places.size
            sum += (places[i] - places[0]) * (places[next + 1] - places[1]) -
                (places[next] - places[0]) * (places[i + 1] - places[1])
        }
        return sum
    }

    /** Returns the parts of contours that are in stripes: from where the fifth number is whole on, for a [share]. */
    private fun stripes(contours: List<DoubleArray>, share: Double): List<DoubleArray> {
        val numbers = contours.flatMap { contour -> (PLACE until contour.size step SIZE).map { contour[it] } }
        if (!(numbers.max() - numbers.min() <= DrawnCap.MAX_STRIPES)) return emptyList()
        if (numbers.any { abs(it) > MOST_PLACE }) return emptyList()
        val stripes = ArrayList<DoubleArray>()
        for (contour in contours) {
            var rest = contour
            val own = (PLACE until contour.size step SIZE).map { contour[it] }
            for (number in floor(own.min()).toLong()..floor(own.max()).toLong()) {
                endIfInterrupted()
                val stripe = rest.cut { number + share - it[PLACE] }.cut { it[PLACE] - number }
                if (stripe.size >= 3 * SIZE) stripes += places(stripe)
                rest = rest.cut { it[PLACE] - (number + 1) }
            }
        }
        return stripes
    }

    private companion object {
        /** Numbers of a corner, and the index of the last one. */
        const val SIZE = 5
        const val PLACE = 4

        /** How far beyond the raster a cap is kept, so that its new sides are not seen, pixels. */
        const val MARGIN = 2.0

        /** Up to here, 2^53, doubles have all whole numbers. */
        const val MOST_PLACE = 9_007_199_254_740_992.0
    }
}
