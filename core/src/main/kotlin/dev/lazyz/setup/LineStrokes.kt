package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Shader
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Lighting
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.MaterialShader
import dev.lazyz.shading.Vertices
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Lines

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
