package dev.lazyz.setup

import dev.lazyz.Fragment
import dev.lazyz.FragmentBatch
import dev.lazyz.Mesh
import dev.lazyz.Primitive
import dev.lazyz.Shader

/**
 * The opaque triangles of a mesh, set up for one raster and camera: snapped vertices in arrays, and nothing for each
 * triangle. Immutable and thread safe. Memory: 20 bytes a vertex, 12 without perspective.
 *
 * Triangle t is the primitive [first] + t, and that is what other renderers see of it, see [primitives]. Triangles that
 * have to be cut, or that show a side that is not drawn, are not drawn from here: [isDrawn] says which; those that have to
 * be cut are [exceptions].
 *
 * @property first submission index of triangle 0
 * @property grid column and row, 1/256 pixel, and depth of each vertex, [STRIDE] numbers a vertex: together, because triangles
 *   are visited in any order
 */
internal class TriangleBatch(
    val mesh: Mesh,
    val first: Int,
    private val setUp: PlanarSetUp,
    val grid: IntArray,
    private val inverseW: DoubleArray?,
    private val hidden: LongArray?,
    val exceptions: List<IndexedValue<Primitive>>,
) {
    /** Number of triangles. */
    val count: Int get() = mesh.triangleCount

    /** Vertex numbers, three a triangle. */
    val corners: IntArray get() = mesh.triangles

    /** Whether [triangle] is drawn from this batch. */
    fun isDrawn(triangle: Int): Boolean =
        hidden == null || hidden[triangle ushr WORD_SHIFT] ushr triangle and 1L == 0L

    /** 1 / w of a vertex. */
    fun inverseW(vertex: Int): Double = if (inverseW == null) 1.0 else inverseW[vertex]

    /** Returns what shades this batch's triangles; for one thread. */
    fun faces(): PlanarSetUp.FaceSetUp = setUp.face(mesh)

    /** Returns the triangles as primitives of their own. */
    fun primitives(): Sequence<Primitive> = setUp.mesh(mesh)

    companion object {
        /** Numbers a vertex in [grid]. */
        const val STRIDE: Int = 3

        /** Shift from a bit to its word of 64. */
        const val WORD_SHIFT: Int = 6
    }
}

/**
 * Attributes of one triangle of a batch at any sample: what [PlanarPrimitive] knows of itself, in a form that is filled
 * again for triangle after triangle. Belongs to one thread.
 */
internal class BatchFace {
    /** Submission index of the triangle that this is, or -1. */
    var index: Int = -1
        private set

    private val vertices = Vertices(3)

    /** What [attributes] fills in: bits [PlanarPrimitive.WORLD] to [PlanarPrimitive.COLOR]. */
    var fields: Int = 0
        private set
    private var normalSign = 1.0

    // Edge functions opposite to each vertex, and 1/w
    private var e0 = 0L
    private var e1 = 0L
    private var e2 = 0L
    private var e0dx = 0L
    private var e1dx = 0L
    private var e2dx = 0L
    private var e0dy = 0L
    private var e1dy = 0L
    private var e2dy = 0L
    private var over0 = 1.0
    private var over1 = 1.0
    private var over2 = 1.0

    /** What colours the triangle. */
    lateinit var shader: Shader
        private set

    /** Whether all samples have one colour, [argb]: nothing varies that a material's shader depends on. */
    var isConstant: Boolean = false
        private set

    /** The colour, packed, of a triangle that [isConstant]. */
    var argb: Int = 0
        private set

    /** Makes this triangle [triangle] of [batch]; [scratch] is for its colour. */
    fun fill(batch: TriangleBatch, triangle: Int, faces: PlanarSetUp.FaceSetUp, scratch: Fragment) {
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
        isConstant = shader is MaterialShader && isUniform()
        if (isConstant) {
            argb = color(scratch)
            return
        }
        over0 = batch.inverseW(a)
        over1 = batch.inverseW(b)
        over2 = batch.inverseW(c)
        val grid = batch.grid
        val ga = TriangleBatch.STRIDE * a
        val gb = TriangleBatch.STRIDE * b
        val gc = TriangleBatch.STRIDE * c
        edges(grid[ga], grid[ga + 1], grid[gb], grid[gb + 1], grid[gc], grid[gc + 1])
    }

    private fun color(fragment: Fragment): Int {
        fragment.moveTo(0, 0)
        if (fields != 0) {
            fragment.vertexRed = vertices.get(0, Vertices.COLOR).toFloat()
            fragment.vertexGreen = vertices.get(0, Vertices.COLOR + 1).toFloat()
            fragment.vertexBlue = vertices.get(0, Vertices.COLOR + 2).toFloat()
            fragment.vertexAlpha = vertices.get(0, Vertices.COLOR + 3).toFloat()
        }
        shader.shade(fragment)
        return fragment.toArgb()
    }

    private fun edges(ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int) {
        val sign = if ((bx - ax).toLong() * (cy - ay) - (cx - ax).toLong() * (by - ay) < 0) -1L else 1L
        val steps = sign * ScreenGrid.STEPS
        e0dx = -steps * (cy - by)
        e0dy = steps * (cx - bx)
        e0 = sign * edge(bx, by, cx, cy)
        e1dx = -steps * (ay - cy)
        e1dy = steps * (ax - cx)
        e1 = sign * edge(cx, cy, ax, ay)
        e2dx = -steps * (by - ay)
        e2dy = steps * (bx - ax)
        e2 = sign * edge(ax, ay, bx, by)
    }

    private fun edge(fromX: Int, fromY: Int, toX: Int, toY: Int): Long =
        (toX - fromX).toLong() * (ScreenGrid.CENTER - fromY) - (toY - fromY).toLong() * (ScreenGrid.CENTER - fromX)

    private fun isUniform(): Boolean {
        if (fields == 0) return true
        if (fields != PlanarPrimitive.COLOR) return false
        for (k in Vertices.COLOR until Vertices.COLOR + 4) {
            if (!isSame(vertices.get(0, k), vertices.get(1, k), vertices.get(2, k))) return false
        }
        return true
    }

    /** Fills in the attributes of the samples [x] until [x] + [count] of row [y], from place [at] of [batch] on. */
    fun attributes(batch: FragmentBatch, at: Int, x: Int, y: Int, count: Int) {
        val end = at + count
        if (fields == 0) return

        if (count < LONG) {
            for (i in 0 until count) attributes(batch, at + i, x + i, y)
            return
        }
        weigh(batch, at, x, y, count)
        if (fields and PlanarPrimitive.WORLD != 0) {
            mix(batch, batch.worldX, at, end, Vertices.WORLD)
            mix(batch, batch.worldY, at, end, Vertices.WORLD + 1)
            mix(batch, batch.worldZ, at, end, Vertices.WORLD + 2)
        }
        if (fields and PlanarPrimitive.NORMAL != 0) {
            mixNormal(batch, batch.normalX, at, end, Vertices.NORMAL)
            mixNormal(batch, batch.normalY, at, end, Vertices.NORMAL + 1)
            mixNormal(batch, batch.normalZ, at, end, Vertices.NORMAL + 2)
        }
        if (fields and PlanarPrimitive.UV != 0) {
            mix(batch, batch.u, at, end, Vertices.UV)
            mix(batch, batch.v, at, end, Vertices.UV + 1)
        }
        if (fields and PlanarPrimitive.COLOR != 0) {
            mix(batch, batch.vertexRed, at, end, Vertices.COLOR)
            mix(batch, batch.vertexGreen, at, end, Vertices.COLOR + 1)
            mix(batch, batch.vertexBlue, at, end, Vertices.COLOR + 2)
            mix(batch, batch.vertexAlpha, at, end, Vertices.COLOR + 3)
        }
    }

    /** As [attributes], for one sample: in short runs loops over arrays cost more than they save. */
    private fun attributes(batch: FragmentBatch, i: Int, x: Int, y: Int) {
        val part0 = (e0 + e0dx * x + e0dy * y).toDouble() * over0
        val part1 = (e1 + e1dx * x + e1dy * y).toDouble() * over1
        val part2 = (e2 + e2dx * x + e2dy * y).toDouble() * over2
        val scale = 1.0 / (part0 + part1 + part2)
        val w0 = part0 * scale
        val w1 = part1 * scale
        val w2 = part2 * scale
        if (fields and PlanarPrimitive.WORLD != 0) {
            batch.worldX[i] = mixed(w0, w1, w2, Vertices.WORLD).toFloat()
            batch.worldY[i] = mixed(w0, w1, w2, Vertices.WORLD + 1).toFloat()
            batch.worldZ[i] = mixed(w0, w1, w2, Vertices.WORLD + 2).toFloat()
        }
        if (fields and PlanarPrimitive.NORMAL != 0) {
            batch.normalX[i] = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL)).toFloat()
            batch.normalY[i] = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL + 1)).toFloat()
            batch.normalZ[i] = (normalSign * mixed(w0, w1, w2, Vertices.NORMAL + 2)).toFloat()
        }
        if (fields and PlanarPrimitive.UV != 0) {
            batch.u[i] = mixed(w0, w1, w2, Vertices.UV).toFloat()
            batch.v[i] = mixed(w0, w1, w2, Vertices.UV + 1).toFloat()
        }
        if (fields and PlanarPrimitive.COLOR != 0) {
            batch.vertexRed[i] = mixed(w0, w1, w2, Vertices.COLOR).toFloat()
            batch.vertexGreen[i] = mixed(w0, w1, w2, Vertices.COLOR + 1).toFloat()
            batch.vertexBlue[i] = mixed(w0, w1, w2, Vertices.COLOR + 2).toFloat()
            batch.vertexAlpha[i] = mixed(w0, w1, w2, Vertices.COLOR + 3).toFloat()
        }
    }

    private fun mixed(w0: Double, w1: Double, w2: Double, field: Int): Double =
        w0 * vertices.get(0, field) + w1 * vertices.get(1, field) + w2 * vertices.get(2, field)

    /** Perspective-correct weights, as [PlanarPrimitive] has them. */
    private fun weigh(batch: FragmentBatch, at: Int, x: Int, y: Int, count: Int) {
        val v0 = e0 + e0dx * x + e0dy * y
        val v1 = e1 + e1dx * x + e1dy * y
        val v2 = e2 + e2dx * x + e2dy * y
        val w0 = batch.weight0
        val w1 = batch.weight1
        val w2 = batch.weight2
        if (v0 + v1 + v2 < EXACT) {
            // Within a triangle no edge function is greater than their sum: all are exact as doubles, and so are steps
            val first0 = v0.toDouble()
            val first1 = v1.toDouble()
            val first2 = v2.toDouble()
            val step0 = e0dx.toDouble()
            val step1 = e1dx.toDouble()
            val step2 = e2dx.toDouble()
            for (i in 0 until count) {
                val part0 = (first0 + i * step0) * over0
                val part1 = (first1 + i * step1) * over1
                val part2 = (first2 + i * step2) * over2
                val scale = 1.0 / (part0 + part1 + part2)
                w0[at + i] = part0 * scale
                w1[at + i] = part1 * scale
                w2[at + i] = part2 * scale
            }
        } else {
            for (i in 0 until count) {
                val part0 = (v0 + i * e0dx).toDouble() * over0
                val part1 = (v1 + i * e1dx).toDouble() * over1
                val part2 = (v2 + i * e2dx).toDouble() * over2
                val scale = 1.0 / (part0 + part1 + part2)
                w0[at + i] = part0 * scale
                w1[at + i] = part1 * scale
                w2[at + i] = part2 * scale
            }
        }
    }

    private fun mix(batch: FragmentBatch, out: FloatArray, at: Int, end: Int, field: Int) {
        val a = vertices.get(0, field)
        val b = vertices.get(1, field)
        val c = vertices.get(2, field)
        if (isSame(a, b, c)) return out.fill(a.toFloat(), at, end)
        val w0 = batch.weight0
        val w1 = batch.weight1
        val w2 = batch.weight2
        for (i in at until end) out[i] = (w0[i] * a + w1[i] * b + w2[i] * c).toFloat()
    }

    /** Whether interpolation between these gives the first of them, to the bit, when it is rounded to single precision. */
    private fun isSame(a: Double, b: Double, c: Double): Boolean {
        val bits = a.toRawBits()
        return bits == b.toRawBits() && bits == c.toRawBits() && a.isFinite() && a.toFloat().toDouble() == a
    }

    private fun mixNormal(batch: FragmentBatch, out: FloatArray, at: Int, end: Int, field: Int) {
        val a = vertices.get(0, field)
        val b = vertices.get(1, field)
        val c = vertices.get(2, field)
        val w0 = batch.weight0
        val w1 = batch.weight1
        val w2 = batch.weight2
        val sign = normalSign
        for (i in at until end) out[i] = (sign * (w0[i] * a + w1[i] * b + w2[i] * c)).toFloat()
    }

    private companion object {
        /** Samples from which on a run is worth loops over arrays. */
        const val LONG = 12

        /** Integers below this one are exact as doubles. */
        const val EXACT = 1L shl 53
    }
}
