package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.raster.EdgeForms
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.FaceStage
import dev.lazyz.setup.PerspectiveWeights
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.setup.PrimitiveAssembly
import dev.lazyz.setup.TextureFootprint
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.shading.MaterialShader
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader

/**
 * The data of a flat primitive, prepared for shading many of its samples: a reusable form of a [PlanarPrimitive].
 * Belongs to one thread.
 *
 * Attributes equal those of [PlanarPrimitive] bit for bit. Each edge function belongs to the edge opposite a vertex;
 * the origin is sample (0, 0).
 */
internal class Face : EdgeForms() {
    /** Submission index of the current primitive, or -1. */
    var index: Int = -1
        private set

    /** The three vertices between which attributes are interpolated. */
    @JvmField val vertices: Vertices = Vertices(3, Vertices.LONG_STRIDE)

    /** The attributes that [attributes] fills in: bits [Attributes.WORLD] to [Attributes.COLOR]. */
    var fields: Int = 0
        private set

    /** -1 to reverse normals, otherwise 1. */
    @JvmField var normalSign: Double = 1.0

    /** 1/w of each vertex. */
    @JvmField var over0: Double = 1.0

    @JvmField var over1: Double = 1.0

    @JvmField var over2: Double = 1.0

    /** A lower bound of the sum of the edge functions, each divided by its vertex's w. */
    @JvmField var least: Double = 0.0

    /** The primitive's shader. */
    lateinit var shader: Shader
        private set

    /** Whether all samples have the same colour, [argb]: the inputs of a material's shader do not vary. */
    var isConstant: Boolean = false
        private set

    /** The colour, packed, if it [isConstant]. */
    var argb: Int = 0
        private set

    /**
     * Whether the edge functions are exact as doubles at the primitive's samples, at all other samples of a tile that
     * contains some of them, and in the steps between them. The sum of the edge functions is the same everywhere, and
     * at the primitive's samples none exceeds four times that sum, 2^52: see [PrimitiveAssembly], which chooses the
     * triangle of a polygon. A step by a column or row is at most 2^36, and within a tile 2^45: see [ScreenGrid.GUARD].
     */
    val isExact: Boolean get() = e0 + e1 + e2 < EXACT

    /** Loads triangle number [triangle] of [batch]; [scratch] is used to compute its colour. */
    fun fill(batch: TriangleBatch, triangle: Int, faces: FaceStage, scratch: Fragment) {
        index = batch.first + triangle
        shader = faces.shader
        fields = faces.fields
        val a = batch.corners[3 * triangle]
        val b = batch.corners[3 * triangle + 1]
        val c = batch.corners[3 * triangle + 2]
        faces.load(vertices, 0, a)
        faces.load(vertices, 1, b)
        faces.load(vertices, 2, c)
        normalSign = faces.turn(vertices)
        least = 0.0
        if (findConstant(scratch)) return
        over0 = batch.inverseW(a)
        over1 = batch.inverseW(b)
        over2 = batch.inverseW(c)
        val grid = batch.grid
        val ga = TriangleBatch.STRIDE * a
        val gb = TriangleBatch.STRIDE * b
        val gc = TriangleBatch.STRIDE * c
        opposite(grid[ga], grid[ga + 1], grid[gb], grid[gb + 1], grid[gc], grid[gc + 1])
    }

    /** Loads the [primitive] with submission index [index]; [scratch] is used to compute its colour. */
    fun fill(index: Int, primitive: PlanarPrimitive, scratch: Fragment) {
        this.index = index
        shader = primitive.shader
        fields = primitive.fields
        for (i in 0 until 3) vertices.copy(primitive.vertices, primitive.corners[i], i)
        normalSign = primitive.normalSign
        val t = primitive.reference
        least = t.size.toDouble() * primitive.leastInverseW
        if (findConstant(scratch)) return
        over0 = 1.0 / vertices.get(0, Vertices.W)
        over1 = 1.0 / vertices.get(1, Vertices.W)
        over2 = 1.0 / vertices.get(2, Vertices.W)
        opposite(t.x0, t.y0, t.x1, t.y1, t.x2, t.y2)
    }

    private fun findConstant(scratch: Fragment): Boolean {
        isConstant = shader is MaterialShader && isUniform()
        if (isConstant) {
            shadeConstant(scratch)
            argb = scratch.toArgb()
        }
        return isConstant
    }

    /** Sets the colour of [fragment], if it [isConstant]. */
    fun shadeConstant(fragment: Fragment) {
        fragment.moveTo(0, 0)
        if (fields != 0) {
            fragment.vertexRed = vertices.get(0, Vertices.COLOR).toFloat()
            fragment.vertexGreen = vertices.get(0, Vertices.COLOR + 1).toFloat()
            fragment.vertexBlue = vertices.get(0, Vertices.COLOR + 2).toFloat()
            fragment.vertexAlpha = vertices.get(0, Vertices.COLOR + 3).toFloat()
        }
        shader.shade(fragment)
    }

    private fun isUniform(): Boolean {
        if (fields == 0) return true
        if (fields != Attributes.COLOR) return false
        for (k in Vertices.COLOR until Vertices.COLOR + 4) {
            if (!isSame(vertices.get(0, k), vertices.get(1, k), vertices.get(2, k))) return false
        }
        return true
    }

    /**
     * Whether interpolation between these values of the three vertices gives exactly the first of them after rounding
     * to single precision. Outside the triangle of the vertices, which a polygon may extend beyond, equal values do not
     * guarantee this.
     */
    fun isSame(a: Double, b: Double, c: Double): Boolean {
        val bits = a.toRawBits()
        return bits == b.toRawBits() && bits == c.toRawBits() && a.isFinite() && a.toFloat().toDouble() == a &&
            least == 0.0
    }

    /**
     * Fills in the attributes of one fragment, at index [i] of [batch], at a point that is [x] grid units right of
     * sample (0, 0) and [y] below it.
     *
     * @param side see [Fragment.footprintSide]
     */
    fun attributes(batch: FragmentBatch, i: Int, x: Int, y: Int, side: Int) {
        val at0 = atGrid0(x, y).toDouble()
        val at1 = atGrid1(x, y).toDouble()
        val at2 = atGrid2(x, y).toDouble()
        PerspectiveWeights.of(at0, at1, at2, over0, over1, over2, least) { w0, w1, w2, _ -> mix(batch, i, w0, w1, w2) }
        if (fields and Attributes.FOOTPRINT != 0) footprint(batch, i, x, y, side)
    }

    /** Fills in the derivatives of the texture coordinates of one fragment, see [attributes]. */
    fun footprint(batch: FragmentBatch, i: Int, x: Int, y: Int, side: Int) {
        TextureFootprint.of(
            atGrid0(x, y).toDouble(), atGrid1(x, y).toDouble(), atGrid2(x, y).toDouble(),
            e0dx, e1dx, e2dx, e0dy, e1dy, e2dy, over0, over1, over2, least, side,
        ) { w0, w1, w2, right0, right1, right2, down0, down1, down2 ->
            if (fields and Attributes.UV != 0) {
                TextureFootprint.derivatives(
                    vertices, Vertices.UV, 0, 1, 2, w0, w1, w2, right0, right1, right2, down0, down1, down2,
                ) { uRight, vRight, uDown, vDown ->
                    batch.dudx[i] = uRight
                    batch.dvdx[i] = vRight
                    batch.dudy[i] = uDown
                    batch.dvdy[i] = vDown
                }
            }
            if (fields and Attributes.UV2 != 0) {
                TextureFootprint.derivatives(
                    vertices, Vertices.UV2, 0, 1, 2, w0, w1, w2, right0, right1, right2, down0, down1, down2,
                ) { uRight, vRight, uDown, vDown ->
                    batch.du2dx[i] = uRight
                    batch.dv2dx[i] = vRight
                    batch.du2dy[i] = uDown
                    batch.dv2dy[i] = vDown
                }
            }
        }
    }

    private fun mix(batch: FragmentBatch, i: Int, w0: Double, w1: Double, w2: Double) {
        if (fields and Attributes.WORLD != 0) {
            batch.worldX[i] = mixed(w0, w1, w2, Vertices.WORLD).toFloat()
            batch.worldY[i] = mixed(w0, w1, w2, Vertices.WORLD + 1).toFloat()
            batch.worldZ[i] = mixed(w0, w1, w2, Vertices.WORLD + 2).toFloat()
        }
        if (fields and Attributes.NORMAL != 0) {
            batch.normalX[i] = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL)).toFloat()
            batch.normalY[i] = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL + 1)).toFloat()
            batch.normalZ[i] = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL + 2)).toFloat()
        }
        if (fields and Attributes.UV != 0) {
            batch.u[i] = mixed(w0, w1, w2, Vertices.UV).toFloat()
            batch.v[i] = mixed(w0, w1, w2, Vertices.UV + 1).toFloat()
        }
        if (fields and Attributes.COLOR != 0) {
            batch.vertexRed[i] = mixed(w0, w1, w2, Vertices.COLOR).toFloat()
            batch.vertexGreen[i] = mixed(w0, w1, w2, Vertices.COLOR + 1).toFloat()
            batch.vertexBlue[i] = mixed(w0, w1, w2, Vertices.COLOR + 2).toFloat()
            batch.vertexAlpha[i] = mixed(w0, w1, w2, Vertices.COLOR + 3).toFloat()
        }
        if (fields and Attributes.UV2 != 0) {
            batch.u2[i] = mixed(w0, w1, w2, Vertices.UV2).toFloat()
            batch.v2[i] = mixed(w0, w1, w2, Vertices.UV2 + 1).toFloat()
        }
        if (fields and Attributes.TANGENT != 0) {
            batch.tangentX[i] = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT)).toFloat()
            batch.tangentY[i] = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT + 1)).toFloat()
            batch.tangentZ[i] = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT + 2)).toFloat()
            batch.tangentW[i] = (normalSign * mixed(w0, w1, w2, Vertices.TANGENT + 3)).toFloat()
        }
    }

    private fun mixed(w0: Double, w1: Double, w2: Double, field: Int): Double =
        vertices.mixed(field, 0, w0, 1, w1, 2, w2)

    companion object {
        /** Bound of the sum: all integers up to eight times this, 2^53, are exact as doubles. */
        private const val EXACT = 1L shl 50
    }
}
