package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.raster.RowHull
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Lighting
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.MaterialShader
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Lines
import kotlin.math.ceil
import kotlin.math.round

/** Sets up the segments of one [Lines] surface, and holds the data that they share. Immutable and thread safe. */
internal class LineStrokes(private val lines: Lines, private val stage: VertexStage, lighting: Lighting) {
    private val material = lines.material.withoutTexture(Shading.CONSTANT)
    private val materialShader = MaterialShader(material, lighting, isPrelit = false)

    /** Half the width, grid steps. */
    private val half = ScreenGrid.half(lines.width)

    val raster: Raster get() = stage.viewport.raster

    /** The shader of all segments. */
    val shader: Shader get() = material.shader ?: materialShader

    /** Returns the segments as primitives, each set up when the sequence reaches it. */
    fun primitives(): Sequence<Primitive> = (0 until lines.segmentCount).asSequence().map { primitive(it) }

    private fun primitive(segment: Int): Primitive {
        // Clip the segment, and keep track of which part of it remains
        val vertices = Vertices(2)
        for (end in 0..1) {
            val from = 3 * lines.segments[2 * segment + end]
            val p = lines.positions
            stage.place(vertices, end, p[from].toDouble(), p[from + 1].toDouble(), p[from + 2].toDouble())
            vertices.set(end, PLACE, end.toDouble())
        }
        if (!vertices.isFinite(0) || !vertices.isFinite(1)) return EmptyPrimitive
        val (first, second) = stage.lineClipper.clipSegment(vertices, 0, 1) ?: return EmptyPrimitive
        val ends = intArrayOf(first, second)
        if (ends.any { !vertices.isFinite(it) || !(vertices.get(it, Vertices.W) > 0.0) }) return EmptyPrimitive

        // Project and snap
        val viewport = stage.viewport
        val whole = LinePrimitive(
            this, segment, half,
            viewport.gridX(vertices, first), viewport.gridY(vertices, first), viewport.depth(vertices, first),
            viewport.gridX(vertices, second), viewport.gridY(vertices, second), viewport.depth(vertices, second),
            1.0 / vertices.get(first, Vertices.W), 1.0 / vertices.get(second, Vertices.W),
            vertices.get(first, PLACE), vertices.get(second, PLACE),
        )
        if (whole.rowStart >= whole.rowEnd || whole.columnStart >= whole.columnEnd) return EmptyPrimitive
        if (material.alphaMode != AlphaMode.MASK) return whole
        return MaskedPrimitive(whole, materialShader, material.alphaCutoff)
    }

    /** Whether a segment is translucent anywhere, because of the material or a vertex colour. */
    fun isTranslucent(segment: Int): Boolean {
        if (material.isTranslucent) return true
        val colors = lines.colors
        if (material.alphaMode != AlphaMode.BLEND || colors == null) return false
        return (0..1).any { colors[4 * lines.segments[2 * segment + it] + 3] != 1f }
    }

    /** Sets the attributes of [fragment] to those of [segment] at [place]: 0 is its first vertex and 1 its second. */
    fun attributes(segment: Int, place: Double, fragment: Fragment) {
        val a = lines.segments[2 * segment]
        val b = lines.segments[2 * segment + 1]
        val p = lines.positions
        fragment.worldX = mix(p[3 * a], p[3 * b], place)
        fragment.worldY = mix(p[3 * a + 1], p[3 * b + 1], place)
        fragment.worldZ = mix(p[3 * a + 2], p[3 * b + 2], place)
        val colors = lines.colors ?: return
        fragment.vertexRed = mix(colors[4 * a], colors[4 * b], place)
        fragment.vertexGreen = mix(colors[4 * a + 1], colors[4 * b + 1], place)
        fragment.vertexBlue = mix(colors[4 * a + 2], colors[4 * b + 2], place)
        fragment.vertexAlpha = mix(colors[4 * a + 3], colors[4 * b + 3], place)
    }

    private fun mix(from: Float, to: Float, place: Double): Float =
        (from.toDouble() + place * (to.toDouble() - from.toDouble())).toFloat()

    private companion object {
        /**
         * The vertex field that stores the position on the segment. It is free because lines have no texture
         * coordinates.
         */
        const val PLACE = Vertices.UV
    }
}

/**
 * A line segment on the raster: a quad around its snapped ends, and the sample nearest to each end (contract rule
 * 2.10).
 *
 * Depth and attributes are functions of the position along the segment. Beyond an end they are constant.
 *
 * @param segment number of the segment in [strokes]
 * @param half half the width, grid steps
 * @param x0 column position of the first end on the 1/256 pixel grid; y0 its row position; x1 and y1 of the second end
 * @param z0 depth of the first end; z1 of the second
 * @param over0 1/w of the first end; over1 of the second
 * @param from position of the first end on the unclipped segment: 0 unless it has been clipped
 * @param until position of the second end on the unclipped segment: 1 unless it has been clipped
 */
internal class LinePrimitive(
    private val strokes: LineStrokes,
    private val segment: Int,
    half: Int,
    private val x0: Int,
    private val y0: Int,
    private val z0: Int,
    private val x1: Int,
    private val y1: Int,
    private val z1: Int,
    private val over0: Double,
    private val over1: Double,
    private val from: Double,
    private val until: Double,
) : AttributedPrimitive {
    private val runX: Long get() = (x1 - x0).toLong()
    private val runY: Long get() = (y1 - y0).toLong()

    /** Square of the length, square grid steps. */
    private val square: Long get() = runX * runX + runY * runY

    /**
     * A vector of half the width in the direction of the segment, grid steps. Rotated by 90 degrees, it points across
     * the segment.
     */
    private val alongX: Int
    private val alongY: Int

    init {
        val length = StrictMath.sqrt(square.toDouble())
        alongX = if (square == 0L) half else share(half, runX, length)
        alongY = if (square == 0L) 0 else share(half, runY, length)
    }

    override val rowStart: Int
    override val rowEnd: Int
    override val columnStart: Int
    override val columnEnd: Int

    init {
        // The quad extends beyond the ends by at most the sum of both components, and the sample of an end by half a
        // pixel
        val reach = maxOf(Math.abs(alongX) + Math.abs(alongY), ScreenGrid.CENTER)
        rowStart = maxOf(ScreenGrid.firstSample(minOf(y0, y1) - reach), 0)
        rowEnd = minOf(ScreenGrid.firstSample(maxOf(y0, y1) + reach), strokes.raster.height)
        columnStart = maxOf(ScreenGrid.firstSample(minOf(x0, x1) - reach), 0)
        columnEnd = minOf(ScreenGrid.firstSample(maxOf(x0, x1) + reach), strokes.raster.width)
    }

    private val isLevel: Boolean get() = z0 == z1 || square == 0L
    override val depthForm: LinearForm? get() = if (isLevel) LinearForm.constant(z0) else null
    override val leastDepth: Int get() = if (isLevel) z0 else minOf(z0, z1)
    override val greatestDepth: Int get() = if (isLevel) z0 else maxOf(z0, z1)
    override val isTranslucent: Boolean get() = strokes.isTranslucent(segment)
    override val shader: Shader get() = strokes.shader
    override val heldBytes: Long get() = HeapLayout.LINE

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        val row = RowHull(y)
        val ax = x0 - alongX - alongY
        val ay = y0 - alongY + alongX
        val bx = x1 + alongX - alongY
        val by = y1 + alongY + alongX
        val cx = x1 + alongX + alongY
        val cy = y1 + alongY - alongX
        val dx = x0 - alongX + alongY
        val dy = y0 - alongY - alongX
        row.addEdge(ax, ay, bx, by)
        row.addEdge(bx, by, cx, cy)
        row.addEdge(cx, cy, dx, dy)
        row.addEdge(dx, dy, ax, ay)
        row.endShape()
        row.addPixel(x0, y0)
        row.addPixel(x1, y1)
        val start = maxOf(row.start, columnStart)
        val end = minOf(row.end, columnEnd)
        if (start < end) spans.add(start, end)
    }

    override fun depth(x: Int, y: Int): Int =
        if (isLevel) z0 else z0 + round(along(x, y) * (z1.toDouble() - z0.toDouble())).toInt()

    /**
     * Returns the position of a sample along the segment: 0 at the first end and before it, 1 at the second end and
     * beyond.
     */
    private fun along(x: Int, y: Int): Double {
        val right = (x * ScreenGrid.STEPS + ScreenGrid.CENTER - x0).toLong()
        val down = (y * ScreenGrid.STEPS + ScreenGrid.CENTER - y0).toLong()
        val product = runX * right + runY * down
        if (product <= 0L) return 0.0
        val whole = square
        return if (product >= whole) 1.0 else product.toDouble() / whole.toDouble()
    }

    override fun attributes(fragment: Fragment) {
        // Perspective-correct (rule 3.6)
        val t = along(fragment.x, fragment.y)
        val weight0 = (1.0 - t) * over0
        val weight1 = t * over1
        val place = from + weight1 / (weight0 + weight1) * (until - from)
        strokes.attributes(segment, place, fragment)
    }

    override fun toString(): String = "LinePrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd)"

    private companion object {
        /** Returns the component of [half] in one direction, rounded away from zero so that no line is too thin. */
        fun share(half: Int, run: Long, length: Double): Int {
            val size = ceil(half.toDouble() * Math.abs(run).toDouble() / length).toInt()
            return if (run < 0L) -size else size
        }
    }
}
