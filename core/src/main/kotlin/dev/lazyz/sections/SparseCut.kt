package dev.lazyz.sections

import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import org.joml.Vector3dc

/** Cuts points and lines by a plane. */
internal object SparseCut {
    /** Returns the points that are kept; null if there is none. */
    fun of(points: Points, plane: SectionPlane): Points? {
        val p = points.positions
        val kept = (0 until p.size / 3).filter { height(p, points.origin, it, plane) <= 0.0 }
        if (kept.isEmpty()) return null
        return Points(
            gathered(p, kept, 3), points.size, points.material, points.normals?.let { gathered(it, kept, 3) },
            points.colors?.let { gathered(it, kept, 4) },
            points.origin, points.name,
        )
    }

    /** Returns the parts of the segments that are kept; null if there is none. */
    fun of(lines: Lines, plane: SectionPlane): Lines? {
        val p = lines.positions
        val colors = lines.colors
        val positions = ArrayList<Float>()
        val shades = ArrayList<Float>()
        fun add(array: FloatArray, width: Int, a: Int, b: Int, t: Double, out: MutableList<Float>) {
            for (k in 0 until width) {
                val from = array[width * a + k].toDouble()
                out += (from + t * (array[width * b + k] - from)).toFloat()
            }
        }
        for (i in lines.segments.indices step 2) {
            val a = lines.segments[i]
            val b = lines.segments[i + 1]
            val heightA = height(p, lines.origin, a, plane)
            val heightB = height(p, lines.origin, b, plane)
            if (!(heightA <= 0.0 || heightB <= 0.0)) continue
            val t = heightA / (heightA - heightB)
            for (place in listOf(if (heightA > 0.0) t else 0.0, if (heightB > 0.0) t else 1.0)) {
                add(p, 3, a, b, place, positions)
                if (colors != null) add(colors, 4, a, b, place, shades)
            }
        }
        if (positions.isEmpty()) return null
        val segments = IntArray(positions.size / 3) { it }
        val all = if (colors == null) null else shades.toFloatArray()
        return Lines(positions.toFloatArray(), segments, lines.width, lines.material, all, lines.origin, lines.name)
    }

    private fun height(p: FloatArray, origin: Vector3dc, i: Int, plane: SectionPlane): Double =
        plane.height(p[3 * i] + origin.x(), p[3 * i + 1] + origin.y(), p[3 * i + 2] + origin.z())

    private fun gathered(array: FloatArray, kept: List<Int>, width: Int): FloatArray =
        FloatArray(width * kept.size) { array[width * kept[it / width] + it % width] }
}
