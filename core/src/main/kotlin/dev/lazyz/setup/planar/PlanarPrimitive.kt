package dev.lazyz.setup.planar

import dev.lazyz.Attributes
import dev.lazyz.Fragment
import dev.lazyz.LinearForm
import dev.lazyz.Primitive
import dev.lazyz.Shader
import dev.lazyz.ShadingCursor
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import dev.lazyz.raster.EdgeFunctions
import dev.lazyz.raster.EdgeTable
import dev.lazyz.raster.ReferenceTriangle
import dev.lazyz.raster.TrapezoidCursor
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Vertices

/**
 * A flat primitive: a triangle, or a polygon with any contours.
 *
 * Attributes are interpolated with three weights, one for each vertex of the reference triangle: the opposite edge
 * function divided by w of the vertex, see [PerspectiveWeights]. The same three edge functions serve any number of
 * attributes (contract rule 3.6). They are computed when the primitive is first shaded.
 *
 * Source: James Blinn, "Hyperbolic Interpolation", IEEE Computer Graphics and Applications 12 (1992).
 *
 * @param isTriangle whether the primitive is a triangle, which is then also the [reference] triangle
 * @param reference the reference triangle on the grid
 * @param corners the vertices of the reference triangle in [vertices]
 * @param leastInverseW lower bound of the interpolated 1/w: the smallest 1/w of the vertices; 0 for a triangle, which
 *   needs no bound, because interpolated values inside it are never smaller than at the vertices
 * @param normalSign -1 to reverse the vertex normals so that they face the viewer; otherwise 1
 * @param fields the attributes that the vertices have and the shader uses, see [Attributes]
 */
internal class PlanarPrimitive(
    private val edges: EdgeTable,
    override val columnStart: Int,
    override val columnEnd: Int,
    override val depthForm: LinearForm,
    val isTriangle: Boolean,
    val reference: ReferenceTriangle,
    val vertices: Vertices,
    val corners: IntArray,
    val leastInverseW: Double,
    val normalSign: Double,
    val fields: Int,
    val shader: Shader,
    override val leastDepth: Int,
    override val greatestDepth: Int,
    override val isTranslucent: Boolean,
) : AttributedPrimitive {
    override val rowStart: Int get() = edges.rowStart
    override val rowEnd: Int get() = edges.rowEnd

    /** Without [vertices], which the triangles of a mesh share. */
    override val heldBytes: Long get() = HELD_BYTES + edges.heldBytes

    /** Created on first use. The object is immutable and always the same, so a race between threads is harmless. */
    private var edgeFunctions: EdgeFunctions? = null

    override fun spans(y: Int, spans: Spans) {
        edges.spans(y, spans)
    }

    override fun cursor(y: Int): SpanCursor = TrapezoidCursor(edges, y)

    override fun depth(x: Int, y: Int): Int = (depthForm.at(x, y) shr 32).toInt()

    override fun shade(fragment: Fragment) {
        attributes(fragment)
        shader.shade(fragment)
    }

    override fun attributes(fragment: Fragment) {
        if (fields == 0) return
        val forms = edgeFunctions()
        mix(
            fragment,
            forms.first.at(fragment.x, fragment.y),
            forms.second.at(fragment.x, fragment.y),
            forms.third.at(fragment.x, fragment.y),
        )
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? =
        if (fields == 0) null else WeightCursor(edgeFunctions(), x, y)

    /**
     * Measured: a step (three additions to fields of a cursor) takes as long as a direct evaluation (six
     * multiplications and nine additions), see docs/algorithms/coherent-shading.md.
     */
    override val shadingStartCost: Int get() = 0

    private fun edgeFunctions(): EdgeFunctions =
        edgeFunctions ?: EdgeFunctions(reference).also { edgeFunctions = it }

    /** Steps the three edge functions along a row. */
    private inner class WeightCursor(private val forms: EdgeFunctions, x: Int, y: Int) : ShadingCursor {
        private var first = forms.first.at(x, y)
        private var second = forms.second.at(x, y)
        private var third = forms.third.at(x, y)

        override fun step() {
            first += forms.first.dx
            second += forms.second.dx
            third += forms.third.dx
        }

        override fun shade(fragment: Fragment) {
            mix(fragment, first, second, third)
            shader.shade(fragment)
        }
    }

    /** Sets the attributes from the values of the three edge functions. */
    private fun mix(fragment: Fragment, first: Long, second: Long, third: Long) {
        PerspectiveWeights.of(
            first.toDouble(), second.toDouble(), third.toDouble(),
            1.0 / vertices.get(corners[0], Vertices.W), 1.0 / vertices.get(corners[1], Vertices.W),
            1.0 / vertices.get(corners[2], Vertices.W), reference.size.toDouble() * leastInverseW,
        ) { w0, w1, w2 -> mix(fragment, w0, w1, w2) }
    }

    /** Interpolates the attributes that the shader uses. */
    private fun mix(fragment: Fragment, w0: Double, w1: Double, w2: Double) {
        if (fields and Attributes.WORLD != 0) {
            fragment.worldX = mixed(w0, w1, w2, Vertices.WORLD).toFloat()
            fragment.worldY = mixed(w0, w1, w2, Vertices.WORLD + 1).toFloat()
            fragment.worldZ = mixed(w0, w1, w2, Vertices.WORLD + 2).toFloat()
        }
        if (fields and Attributes.NORMAL != 0) {
            fragment.normalX = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL)).toFloat()
            fragment.normalY = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL + 1)).toFloat()
            fragment.normalZ = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL + 2)).toFloat()
        }
        if (fields and Attributes.UV != 0) {
            fragment.u = mixed(w0, w1, w2, Vertices.UV).toFloat()
            fragment.v = mixed(w0, w1, w2, Vertices.UV + 1).toFloat()
        }
        if (fields and Attributes.COLOR != 0) {
            fragment.vertexRed = mixed(w0, w1, w2, Vertices.COLOR).toFloat()
            fragment.vertexGreen = mixed(w0, w1, w2, Vertices.COLOR + 1).toFloat()
            fragment.vertexBlue = mixed(w0, w1, w2, Vertices.COLOR + 2).toFloat()
            fragment.vertexAlpha = mixed(w0, w1, w2, Vertices.COLOR + 3).toFloat()
        }
    }

    private fun mixed(w0: Double, w1: Double, w2: Double, field: Int): Double =
        vertices.mixed(field, corners[0], w0, corners[1], w1, corners[2], w2)

    override fun toString(): String =
        "PlanarPrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd, $depthForm)"

    companion object {
        /**
         * Bytes of this object, the reference triangle, the corners, the depth form and, after shading, the edge
         * functions: nine objects with 40 fields, counted as 8 bytes for each field.
         */
        private const val HELD_BYTES = 9 * 16L + 40 * 8L
    }
}
