package dev.lazyz.setup

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.raster.EdgeForms
import dev.lazyz.raster.EdgeTable
import dev.lazyz.raster.ReferenceTriangle
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.raster.TrapezoidCursor
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans

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
    override val shader: Shader,
    override val leastDepth: Int,
    override val greatestDepth: Int,
    override val isTranslucent: Boolean,
) : AttributedPrimitive {
    override val rowStart: Int get() = edges.rowStart
    override val rowEnd: Int get() = edges.rowEnd

    /** Without [vertices], which the triangles of a mesh share. */
    override val heldBytes: Long get() = HeapLayout.PLANAR + edges.heldBytes

    /** Created on first use, perhaps by several threads, and not changed later; volatile, so that all see it whole. */
    @Volatile
    private var edgeForms: EdgeForms? = null

    override fun spans(y: Int, spans: Spans) {
        edges.spans(y, spans)
    }

    override fun cursor(y: Int): SpanCursor = TrapezoidCursor(edges, y)

    override fun depth(x: Int, y: Int): Int = (depthForm.at(x, y) shr 32).toInt()

    override fun attributes(fragment: Fragment) {
        if (fields != 0) mixAt(fragment, fields)
    }

    override fun geometry(fragment: Fragment): Unit = mixAt(fragment, GEOMETRY)

    /** Sets the attributes [fields] to those at the sample of [fragment], or as far from it as the fragment says. */
    private fun mixAt(fragment: Fragment, fields: Int) {
        val forms = edgeForms()
        val x = ScreenGrid.STEPS * fragment.x + fragment.gridRight
        val y = ScreenGrid.STEPS * fragment.y + fragment.gridDown
        mix(fragment, fields, forms.atGrid0(x, y), forms.atGrid1(x, y), forms.atGrid2(x, y))
    }

    /** Returns where this triangle is shaded in a pixel, see [ShadingPoints.find]. */
    fun shadingPoint(points: ShadingPoints, left: Int, top: Int): Int = points.find(edgeForms(), left, top)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? =
        if (fields == 0) null else WeightCursor(edgeForms(), x, y)

    /**
     * Measured: a step (three additions to fields of a cursor) takes as long as a direct evaluation (six
     * multiplications and nine additions), see docs/algorithms/coherent-shading.md.
     */
    override val shadingStartCost: Int get() = 0

    private fun edgeForms(): EdgeForms = edgeForms ?: EdgeForms().also {
        it.opposite(reference.x0, reference.y0, reference.x1, reference.y1, reference.x2, reference.y2)
        edgeForms = it
    }

    /** Steps the three edge functions along a row. */
    private inner class WeightCursor(private val forms: EdgeForms, x: Int, y: Int) : ShadingCursor {
        private var first = forms.at0(x, y)
        private var second = forms.at1(x, y)
        private var third = forms.at2(x, y)

        override fun step() {
            first += forms.e0dx
            second += forms.e1dx
            third += forms.e2dx
        }

        override fun shade(fragment: Fragment) {
            mix(fragment, fields, first, second, third)
            shader.shade(fragment)
        }
    }

    /** Sets the attributes [fields] from the values of the three edge functions. */
    private fun mix(fragment: Fragment, fields: Int, first: Long, second: Long, third: Long) {
        PerspectiveWeights.of(
            first.toDouble(), second.toDouble(), third.toDouble(),
            1.0 / vertices.get(corners[0], Vertices.W), 1.0 / vertices.get(corners[1], Vertices.W),
            1.0 / vertices.get(corners[2], Vertices.W), reference.size.toDouble() * leastInverseW,
        ) { w0, w1, w2, _ -> mix(fragment, fields, w0, w1, w2) }
        if (fields and Attributes.FOOTPRINT != 0) footprint(fragment, first, second, third)
    }

    /** Interpolates the attributes [fields]. */
    private fun mix(fragment: Fragment, fields: Int, w0: Double, w1: Double, w2: Double) {
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
        if (fields and Attributes.UV2 != 0) {
            fragment.u2 = mixed(w0, w1, w2, Vertices.UV2).toFloat()
            fragment.v2 = mixed(w0, w1, w2, Vertices.UV2 + 1).toFloat()
        }
        if (fields and Attributes.TANGENT != 0) {
            fragment.tangentX = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT)).toFloat()
            fragment.tangentY = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT + 1)).toFloat()
            fragment.tangentZ = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT + 2)).toFloat()
            fragment.tangentW = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT + 3)).toFloat()
        }
    }

    /** Sets the derivatives of the texture coordinates (contract rules 6.6 and 6.12). */
    private fun footprint(fragment: Fragment, first: Long, second: Long, third: Long) {
        val forms = edgeForms()
        TextureFootprint.of(
            first.toDouble(), second.toDouble(), third.toDouble(),
            forms.e0dx, forms.e1dx, forms.e2dx,
            forms.e0dy, forms.e1dy, forms.e2dy,
            1.0 / vertices.get(corners[0], Vertices.W), 1.0 / vertices.get(corners[1], Vertices.W),
            1.0 / vertices.get(corners[2], Vertices.W), reference.size.toDouble() * leastInverseW,
            fragment.footprintSide,
        ) { w0, w1, w2, right0, right1, right2, down0, down1, down2 ->
            if (fields and Attributes.UV != 0) {
                TextureFootprint.derivatives(
                    vertices, Vertices.UV, corners[0], corners[1], corners[2],
                    w0, w1, w2, right0, right1, right2, down0, down1, down2,
                ) { uRight, vRight, uDown, vDown ->
                    fragment.dudx = uRight
                    fragment.dvdx = vRight
                    fragment.dudy = uDown
                    fragment.dvdy = vDown
                }
            }
            if (fields and Attributes.UV2 != 0) {
                TextureFootprint.derivatives(
                    vertices, Vertices.UV2, corners[0], corners[1], corners[2],
                    w0, w1, w2, right0, right1, right2, down0, down1, down2,
                ) { uRight, vRight, uDown, vDown ->
                    fragment.du2dx = uRight
                    fragment.dv2dx = vRight
                    fragment.du2dy = uDown
                    fragment.dv2dy = vDown
                }
            }
        }
    }

    private fun mixed(w0: Double, w1: Double, w2: Double, field: Int): Double =
        vertices.mixed(field, corners[0], w0, corners[1], w1, corners[2], w2)

    override fun toString(): String =
        "PlanarPrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd, $depthForm)"

    companion object {
        /** What [geometry] sets. Vertices have room for all of it; what a surface does not have is 0. */
        private const val GEOMETRY = Attributes.WORLD or Attributes.NORMAL or Attributes.UV
    }
}

/** Interpolation in perspective between three vertices (contract rule 3.6). */
internal object PerspectiveWeights {
    /**
     * Passes the weights of the vertices at a sample to [use], and the factor by which the products of edge functions
     * and 1/w are scaled so that their sum is 1. The only division for a fragment.
     *
     * @param e0 edge function opposite to vertex 0 at the sample; e1 and e2 for the other vertices
     * @param over0 1/w of vertex 0; over1 and over2 of the other vertices
     * @param least a lower bound of the sum of the edge functions, each multiplied by its 1/w
     */
    inline fun of(
        e0: Double,
        e1: Double,
        e2: Double,
        over0: Double,
        over1: Double,
        over2: Double,
        least: Double,
        use: (w0: Double, w1: Double, w2: Double, scale: Double) -> Unit,
    ) {
        val part0 = e0 * over0
        val part1 = e1 * over1
        val part2 = e2 * over2
        val scale = 1.0 / maxOf(part0 + part1 + part2, least)
        use(part0 * scale, part1 * scale, part2 * scale, scale)
    }
}
