package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.setup.PerspectiveWeights
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Srgb

/**
 * The loops of [FragmentShading] that run for every visible sample, except shading itself.
 *
 * All kernels give the same bits. No state except scratch memory; belongs to one thread.
 *
 * @param long fewest samples for which loops over arrays are worthwhile
 */
internal abstract class FragmentKernel(private val long: Int) {
    /**
     * Weight of each vertex at the samples, which [weigh] computes for [mix]. Vectors may write beyond the last sample.
     */
    protected val weight0: DoubleArray = DoubleArray(FragmentBatch.ROOM)
    protected val weight1: DoubleArray = DoubleArray(FragmentBatch.ROOM)
    protected val weight2: DoubleArray = DoubleArray(FragmentBatch.ROOM)

    /**
     * Fills in the attributes of [face] at the samples from number [at] of [fragments] on, in a tile whose first sample
     * is ([x], [y]). Footprints are [side] samples wide and high. Up to [FragmentBatch.SPARE] elements after the last
     * sample may be overwritten.
     */
    fun attributes(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int, side: Int) {
        val fields = face.fields
        val batch = fragments.batch
        val count = fragments.size - at
        if (fields == 0) return
        if (count < long || !face.isExact) {
            for (i in at until at + count) {
                face.attributes(batch, i, fragments.gridX(i, x), fragments.gridY(i, y), side)
            }
            return
        }
        weigh(face, fragments, at, x, y)
        if (fields and Attributes.WORLD != 0) {
            mix(face, Vertices.WORLD, 1.0, batch.worldX, at, count)
            mix(face, Vertices.WORLD + 1, 1.0, batch.worldY, at, count)
            mix(face, Vertices.WORLD + 2, 1.0, batch.worldZ, at, count)
        }
        if (fields and Attributes.NORMAL != 0) {
            mix(face, Vertices.NORMAL, face.normalSign, batch.normalX, at, count)
            mix(face, Vertices.NORMAL + 1, face.normalSign, batch.normalY, at, count)
            mix(face, Vertices.NORMAL + 2, face.normalSign, batch.normalZ, at, count)
        }
        if (fields and Attributes.UV != 0) {
            mix(face, Vertices.UV, 1.0, batch.u, at, count)
            mix(face, Vertices.UV + 1, 1.0, batch.v, at, count)
        }
        if (fields and Attributes.COLOR != 0) {
            mix(face, Vertices.COLOR, 1.0, batch.vertexRed, at, count)
            mix(face, Vertices.COLOR + 1, 1.0, batch.vertexGreen, at, count)
            mix(face, Vertices.COLOR + 2, 1.0, batch.vertexBlue, at, count)
            mix(face, Vertices.COLOR + 3, 1.0, batch.vertexAlpha, at, count)
        }
        if (fields and Attributes.UV2 != 0) {
            mix(face, Vertices.UV2, 1.0, batch.u2, at, count)
            mix(face, Vertices.UV2 + 1, 1.0, batch.v2, at, count)
        }
        if (fields and Attributes.TANGENT != 0) {
            mix(face, Vertices.TANGENT, face.normalSign, batch.tangentX, at, count)
            mix(face, Vertices.TANGENT + 1, face.normalSign, batch.tangentY, at, count)
            mix(face, Vertices.TANGENT + 2, face.normalSign, batch.tangentZ, at, count)
            mix(face, Vertices.TANGENT + 3, face.normalSign, batch.tangentW, at, count)
        }
        if (fields and Attributes.FOOTPRINT != 0) {
            for (i in at until at + count) {
                face.footprint(batch, i, fragments.gridX(i, x), fragments.gridY(i, y), side)
            }
        }
    }

    /**
     * Computes and stores the perspective-correct weights of the vertices at these samples, with the same result as
     * [Face.attributes]. Edge functions are exact as doubles, see [Face.isExact].
     */
    protected abstract fun weigh(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int)

    /**
     * Interpolates the vertices' [field] with the weights, times [sign], into [count] elements of [out] from [at] on.
     */
    protected abstract fun mix(face: Face, field: Int, sign: Double, out: FloatArray, at: Int, count: Int)

    /**
     * Returns the first index after [from] whose key in [keys] belongs to another primitive than the key at [from], or
     * [until]. The lower half of a key identifies the primitive.
     */
    abstract fun runEnd(keys: LongArray, from: Int, until: Int): Int

    /** Packs the colours of [batch] into [argb], which must have room for [FragmentBatch.SPARE] more elements. */
    abstract fun pack(batch: FragmentBatch, argb: IntArray)
}

/** Loops that run on any JVM. C2 can vectorize those over arrays. */
internal class ScalarFragmentKernel : FragmentKernel(long = 12) {
    override fun weigh(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int) {
        val first0 = face.at0(x, y).toDouble()
        val first1 = face.at1(x, y).toDouble()
        val first2 = face.at2(x, y).toDouble()
        val right0 = face.e0dx.toDouble()
        val right1 = face.e1dx.toDouble()
        val right2 = face.e2dx.toDouble()
        val down0 = face.e0dy.toDouble()
        val down1 = face.e1dy.toDouble()
        val down2 = face.e2dy.toDouble()
        val columns = fragments.columns
        val rows = fragments.rows
        for (i in 0 until fragments.size - at) {
            val column = columns[at + i]
            val row = rows[at + i]
            val at0 = first0 + column * right0 + row * down0
            val at1 = first1 + column * right1 + row * down1
            val at2 = first2 + column * right2 + row * down2
            PerspectiveWeights.of(at0, at1, at2, face.over0, face.over1, face.over2, face.least) { w0, w1, w2, _ ->
                weight0[i] = w0
                weight1[i] = w1
                weight2[i] = w2
            }
        }
    }

    override fun mix(face: Face, field: Int, sign: Double, out: FloatArray, at: Int, count: Int) {
        val a = face.vertices.get(0, field)
        val b = face.vertices.get(1, field)
        val c = face.vertices.get(2, field)
        if (face.isSame(a, b, c)) return out.fill((sign * a).toFloat(), at, at + count)
        for (i in 0 until count) out[at + i] = (sign * (weight0[i] * a + weight1[i] * b + weight2[i] * c)).toFloat()
    }

    override fun runEnd(keys: LongArray, from: Int, until: Int): Int {
        val rank = keys[from].toInt()
        var at = from + 1
        while (at < until && keys[at].toInt() == rank) at++
        return at
    }

    override fun pack(batch: FragmentBatch, argb: IntArray) {
        for (i in 0 until batch.size) {
            argb[i] = Srgb.pack(batch.red[i], batch.green[i], batch.blue[i], batch.alpha[i])
        }
    }
}
