package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Attributes
import dev.lazyz.FragmentBatch
import dev.lazyz.shading.Vertices

/**
 * What is done for every visible sample but shading itself: the loops of [TileShading].
 *
 * All kernels give the same bits. Stateless but for scratch: belongs to one thread.
 *
 * @param long samples from which on loops over arrays are worth it
 */
internal abstract class FragmentKernel(private val long: Int) {
    /** Weight of each vertex at the samples: what [weigh] leaves for [mix]. Vectors write behind its end. */
    protected val weight0: DoubleArray = DoubleArray(FragmentBatch.ROOM)
    protected val weight1: DoubleArray = DoubleArray(FragmentBatch.ROOM)
    protected val weight2: DoubleArray = DoubleArray(FragmentBatch.ROOM)

    /**
     * Fills in the attributes of [face] at the samples from number [at] of [fragments] on, in a tile whose first sample is
     * ([x], [y]). What stands behind the last, as far as [FragmentBatch.SPARE] further, may be overwritten.
     */
    fun attributes(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int) {
        val fields = face.fields
        val batch = fragments.batch
        val count = fragments.size - at
        if (fields == 0) return
        if (count < long || !face.isExact) {
            for (i in at until at + count) {
                face.attributes(batch, i, x + fragments.columns[i].toInt(), y + fragments.rows[i].toInt())
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
    }

    /**
     * Computes the perspective-correct weights of the vertices at these samples, as [Face.attributes] has them, and keeps
     * them. Edge functions are exact as doubles, see [Face.isExact].
     */
    protected abstract fun weigh(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int)

    /** Mixes the vertices' [field] by the weights, times [sign], into [count] places of [out] from [at] on. */
    protected abstract fun mix(face: Face, field: Int, sign: Double, out: FloatArray, at: Int, count: Int)

    /**
     * Returns the first place from [from] on whose key in [keys] is another primitive's than the one at [from], or [until].
     * The lower half of a key says whose it is.
     */
    abstract fun runEnd(keys: LongArray, from: Int, until: Int): Int

    /** Packs the colours of [batch] into [argb], which has room for [FragmentBatch.SPARE] more. */
    abstract fun pack(batch: FragmentBatch, argb: IntArray)
}
