package dev.lazyz.conformance.corpus

import dev.lazyz.Depth
import dev.lazyz.Rgba
import dev.lazyz.conformance.oracle.Coverage
import dev.lazyz.conformance.oracle.ExactLine
import dev.lazyz.conformance.oracle.ExactPoint
import dev.lazyz.conformance.oracle.ExactPolygon
import dev.lazyz.geometry.FillRule
import dev.lazyz.scenes.Tint
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d

/** A colour in linear light with straight alpha, in 255ths. */
internal class CorpusColor(val red: Int, val green: Int, val blue: Int, val alpha: Int) {
    val rgba: Rgba get() = Rgba(red / MOST, green / MOST, blue / MOST, alpha / MOST)

    override fun toString(): String = "[$red, $green, $blue, $alpha]"

    companion object {
        private const val MOST = 255f

        /** Distance from the middle between two codes within which other arithmetic may round to the other one. */
        private const val ROOM = 0.1

        /** Transparent black. */
        val NONE: CorpusColor = CorpusColor(0, 0, 0, 0)

        /** The 255ths whose 8-bit sRGB code any arithmetic finds. */
        private val clear: List<Int> = (0..255).filter {
            val light = it / 255.0
            val code = if (light <= 0.0031308) 12.92 * light else 1.055 * StrictMath.pow(light, 1 / 2.4) - 0.055
            val place = 255.0 * code
            StrictMath.abs(place - StrictMath.floor(place) - 0.5) > ROOM
        }

        /** Returns the colour of primitive [index]; [corner] gives others to its vertices. Few of [clear] are dark. */
        fun of(index: Int, corner: Int = 0, alpha: Int = 255, few: Int = clear.size): CorpusColor {
            val bits = Tint.hash(index, corner, 0, 0)
            fun part(shift: Int) = clear[(bits ushr shift and 0x3FF) % few]
            return CorpusColor(part(0), part(10), part(20), alpha)
        }
    }
}

/** A primitive of a scene of the corpus, in whole numbers on the contract's grid. */
internal sealed class CorpusShape(val color: CorpusColor) {
    val isTranslucent: Boolean get() = color.alpha < 255

    /** What a program must be able to do to draw it. */
    abstract val tags: Set<String>

    /** Returns the surface that becomes this primitive. */
    abstract fun surface(): Surface

    /** The members of the primitive in the scene's JSON, without those of [look]. */
    abstract val members: String

    /** The members of the JSON that say how it looks. */
    open val look: String get() = "\"color\": $color"

    /** The straight edges, in grid steps. A sphere has none. */
    abstract val edges: List<CorpusEdge>

    /** Whether all vertices are at 16ths of pixels near the raster, so that even floats of 24 bits are exact. */
    open val isCoarse: Boolean get() = edges.all { it.isCoarse }

    /** The depth, if it is the same everywhere. */
    abstract val level: Int?

    /** Whether a sample is within a step of the grid of the outline. */
    open fun isNearOutline(x: Int, y: Int): Boolean = edges.any { it.isNear(256.0 * x + 128, 256.0 * y + 128) }

    /** Returns whether both have the same depth everywhere, so that any arithmetic finds a tie. */
    open fun isCoplanar(other: CorpusShape): Boolean = level != null && level == other.level

    protected fun material(shader: Shader? = null): Material = Material(
        color.rgba,
        shading = Shading.CONSTANT,
        alphaMode = if (isTranslucent) AlphaMode.BLEND else AlphaMode.OPAQUE,
        shader = shader,
    )
}

/**
 * A polygon.
 *
 * @param color its colour; if there are [corners], only its alpha is used: less than 255 if theirs are
 * @param corners for a triangle with a colour at each vertex: these colours; otherwise empty
 * @param ws w of these vertices
 */
internal class CorpusPolygon(
    private val polygon: ExactPolygon,
    color: CorpusColor,
    private val corners: List<CorpusColor> = emptyList(),
    private val ws: List<Int> = emptyList(),
) : CorpusShape(color) {
    private val contours = polygon.contours.map { contour ->
        (contour.indices step 3).map { i -> List(3) { contour[i + it].toLong() } }
    }
    private val plane = polygon.planePoints()
    private val isTriangle = contours.singleOrNull()?.size == 3

    override val tags: Set<String> get() = setOfNotNull(
        if (isTriangle) "triangle" else "polygon",
        "colors".takeIf { isMixed },
        "perspective".takeIf { ws.distinct().size > 1 },
    )

    override val edges: List<CorpusEdge> = contours.flatMap { CorpusEdge.around(it) }

    override val level: Int? = plane.map { it[2].toInt() }.distinct().singleOrNull()

    override fun isCoplanar(other: CorpusShape): Boolean =
        (other is CorpusPolygon && plane == other.plane) || super.isCoplanar(other)

    /** Whether it has a colour at each vertex. */
    val isMixed: Boolean get() = corners.isNotEmpty()

    override fun surface(): Surface = Polygon(
        contours.map { contour ->
            contour.map { (x, y, depth) -> Vertex(x / 256.0, y / 256.0, Depth.toUnit(depth.toInt())) }
        },
        material(if (!isMixed) null else MixedColors(plane, corners.map { it.rgba }, ws)),
        polygon.fillRule,
    )

    override val members: String get() {
        val fill = if (polygon.fillRule == FillRule.EVEN_ODD) "even-odd" else "non-zero"
        val outline = contours.map { contour -> contour.map { it.take(2) } }
        return "\"kind\": \"polygon\", \"fill\": \"$fill\", \"contours\": $outline, \"plane\": $plane"
    }

    override val look: String get() = if (!isMixed) super.look else "\"colors\": $corners, \"w\": $ws"
}

/** Colours of a triangle's vertices, mixed as contract rule 3.6 says. */
internal class MixedColors(plane: List<List<Long>>, val colors: List<Rgba>, private val ws: List<Int>) : Shader {
    private val x = LongArray(3) { plane[it][0] }
    private val y = LongArray(3) { plane[it][1] }

    override fun shade(fragment: Fragment) {
        val column = 256L * fragment.x + 128
        val row = 256L * fragment.y + 128
        val parts = DoubleArray(3) {
            val a = (it + 1) % 3
            val b = (it + 2) % 3
            val area = (x[b] - x[a]) * (y[it] - y[a]) - (y[b] - y[a]) * (x[it] - x[a])
            val edge = (x[b] - x[a]) * (row - y[a]) - (y[b] - y[a]) * (column - x[a])
            (if (area < 0) -edge else edge).toDouble() * (1.0 / ws[it])
        }
        val scale = 1.0 / (parts[0] + parts[1] + parts[2])
        fun mixed(part: (Rgba) -> Float) = (
            part(colors[0]) * (parts[0] * scale) + part(colors[1]) * (parts[1] * scale) +
                part(colors[2]) * (parts[2] * scale)
            ).toFloat()
        fragment.setColor(mixed { it.red }, mixed { it.green }, mixed { it.blue }, mixed { it.alpha })
    }
}

/** A square around a vertex. */
internal class CorpusPoint(
    private val x: Int,
    private val y: Int,
    private val unit: Float,
    private val half: Int,
    color: CorpusColor,
) : CorpusShape(color) {
    override val level: Int = Depth.ofUnit(unit.toDouble())

    override val tags: Set<String> get() = setOf("point")

    override val edges: List<CorpusEdge> = CorpusEdge.square(x.toLong(), y.toLong(), half.toLong())

    override fun surface(): Surface = Points(floatArrayOf(x / 256f, y / 256f, unit), half / 128.0, material())

    override val members: String get() = "\"kind\": \"point\", \"at\": [$x, $y, $level], \"half\": $half"
}

/** A line between two vertices: [ends] has x, y and, as fractions of the range, depth. */
internal class CorpusLine(
    private val ends: List<Int>,
    private val units: List<Float>,
    private val half: Int,
    color: CorpusColor,
) : CorpusShape(color) {
    private val depths = units.map { Depth.ofUnit(it.toDouble()) }
    private val exact = intArrayOf(ends[0], ends[1], depths[0], ends[2], ends[3], depths[1])
        .let { ExactLine(it, half / 128.0).quad }
    private val quad =
        exact.contours.single().toList().chunked(3).map { (x, y) -> listOf(x.toLong(), y.toLong()) }
    private val squares = ends.chunked(2).map { (x, y) -> ExactPoint(x, y, 0, 1.0) }

    override val level: Int? = depths.distinct().singleOrNull()

    /** Whether both ends are at the same place. */
    val isPoint: Boolean get() = ends.take(2) == ends.drop(2)

    /** Whether a sample is in the square at this [end], 0 or 1, and in no other part. */
    fun isOnlyAtEnd(end: Int, x: Int, y: Int): Boolean =
        isCovered(end, x, y) && !isCovered(1 - end, x, y) && !exact.covers(x, y)

    private fun isCovered(end: Int, x: Int, y: Int) = squares[end].coverage(x, y) == Coverage.COVERED

    override val tags: Set<String> get() = setOf("line")

    override val edges: List<CorpusEdge> = CorpusEdge.around(quad) +
        CorpusEdge.square(ends[0].toLong(), ends[1].toLong(), 128) +
        CorpusEdge.square(ends[2].toLong(), ends[3].toLong(), 128)

    override fun isCoplanar(other: CorpusShape): Boolean =
        (other is CorpusLine && ends == other.ends && depths == other.depths) || super.isCoplanar(other)

    override fun surface(): Surface = Lines(
        floatArrayOf(ends[0] / 256f, ends[1] / 256f, units[0], ends[2] / 256f, ends[3] / 256f, units[1]),
        intArrayOf(0, 1), half / 128.0, material(),
    )

    override val members: String get() = "\"kind\": \"line\", \"from\": [${ends[0]}, ${ends[1]}, ${depths[0]}], " +
        "\"to\": [${ends[2]}, ${ends[3]}, ${depths[1]}], \"quad\": $quad"
}

/** A sphere whose centre is [deep] steps of the grid behind the near plane. */
internal class CorpusSphere(
    private val x: Int,
    private val y: Int,
    private val deep: Int,
    private val radius: Int,
    color: CorpusColor,
) : CorpusShape(color) {
    override val tags: Set<String> get() = setOf("sphere")

    override val edges: List<CorpusEdge> get() = emptyList()

    override val level: Int? get() = null

    override val isCoarse: Boolean get() = listOf(x, y, radius).all { it % 16 == 0 }

    /** Returns the square of the height above the centre at a point, in grid steps. */
    fun height(x: Long, y: Long): Long =
        radius.toLong() * radius - (x - this.x) * (x - this.x) - (y - this.y) * (y - this.y)

    override fun isNearOutline(x: Int, y: Int): Boolean {
        val right = 256.0 * x + 128 - this.x
        val down = 256.0 * y + 128 - this.y
        return StrictMath.abs(StrictMath.sqrt(right * right + down * down) - radius) < 1.0
    }

    override fun isCoplanar(other: CorpusShape): Boolean = other is CorpusSphere && members == other.members

    override fun surface(): Surface =
        Sphere(Vector3d(x / 256.0, y / 256.0, deep / 256.0), radius / 256.0, material())

    override val members: String get() = "\"kind\": \"sphere\", \"center\": [$x, $y, " +
        "${Depth.NEAR + deep.toLong() * DEPTH_OF_STEP}], \"radius\": $radius, \"depth_of_step\": $DEPTH_OF_STEP"

    companion object {
        /** How much depth grows in a step of the grid. */
        const val DEPTH_OF_STEP: Int = 1 shl 17

        /** Distance of the far plane in pixels. */
        const val FAR: Double = (Depth.FAR.toDouble() - Depth.NEAR) / 256 / DEPTH_OF_STEP
    }
}

/** A straight part of an outline, downward. */
internal class CorpusEdge private constructor(val x0: Long, val y0: Long, val x1: Long, val y1: Long) {
    val isHorizontal: Boolean get() = y0 == y1

    val isCoarse: Boolean get() = !isFar && listOf(x0, y0, x1, y1).all { it % 16 == 0L }

    /** Whether an end is far from the raster. */
    val isFar: Boolean get() = listOf(x0, y0, x1, y1).any { it !in -FAR_OFF..FAR_OFF }

    /** Whether a point is on the edge, and not an end. */
    fun isThrough(x: Long, y: Long): Boolean =
        if (isHorizontal) y == y0 && x > minOf(x0, x1) && x < maxOf(x0, x1) else y > y0 && y < y1 && side(x, y) == 0

    /** Whether floats of 24 bits find a point on the other side. */
    fun isMissedByFloats(x: Long, y: Long): Boolean {
        val left = (x - x0).toFloat() * (y1 - y0).toFloat()
        val right = (y - y0).toFloat() * (x1 - x0).toFloat()
        return y in y0 until y1 && (left >= right) != (side(x, y) >= 0)
    }

    /** Whether integers of 56 bits, which overflow, find a point on the other side. */
    fun isMissedByIntegers(x: Long, y: Long): Boolean {
        val left = (x - x0) * (y1 - y0) shl 8
        val right = (y - y0) * (x1 - x0) shl 8
        return y in y0 until y1 && (left >= right) != (side(x, y) >= 0)
    }

    private fun side(x: Long, y: Long): Int = ((x - x0) * (y1 - y0)).compareTo((y - y0) * (x1 - x0))

    /** Whether a point is less than a step away. */
    fun isNear(x: Double, y: Double): Boolean {
        val dx = (x1 - x0).toDouble()
        val dy = (y1 - y0).toDouble()
        val square = dx * dx + dy * dy
        val along = (x - x0) * dx + (y - y0) * dy
        val t = if (square > 0.0) (along / square).coerceIn(0.0, 1.0) else 0.0
        val right = x - x0 - t * dx
        val down = y - y0 - t * dy
        return right * right + down * down < 1.0
    }

    companion object {
        /** In grid steps: 64 pixels. */
        private const val FAR_OFF = 64L * 256

        /** Returns the sides of a closed contour through these corners. */
        fun around(corners: List<List<Long>>): List<CorpusEdge> = corners.indices.map {
            val (x0, y0) = corners[it]
            val (x1, y1) = corners[(it + 1) % corners.size]
            if (y0 <= y1) CorpusEdge(x0, y0, x1, y1) else CorpusEdge(x1, y1, x0, y0)
        }

        /** Returns the sides of the square around a point. */
        fun square(x: Long, y: Long, half: Long): List<CorpusEdge> = around(
            listOf(
                listOf(x - half, y - half), listOf(x + half, y - half), listOf(x + half, y + half),
                listOf(x - half, y + half),
            ),
        )
    }
}
