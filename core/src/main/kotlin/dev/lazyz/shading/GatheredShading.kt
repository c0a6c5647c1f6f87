package dev.lazyz.shading

import dev.lazyz.FrameContent
import dev.lazyz.RecentPrimitives
import dev.lazyz.endIfInterrupted
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch

/**
 * Gathers samples of any primitives, and then shades them: together where consecutive ones have the same
 * [BatchShader]. The colours are those of shading one by one. Used by one thread.
 *
 * @param footprintSide how many samples wide and high a footprint is, see [Fragment.footprintSide]
 * @param room the most samples that can be gathered
 */
internal class GatheredShading(content: FrameContent, footprintSide: Int, room: Int) {
    private val primitives = RecentPrimitives(content)
    private val fragment = Fragment().also { it.footprintSide = footprintSide }
    private val indices = IntArray(room)
    private val xs = IntArray(room)
    private val ys = IntArray(room)

    /** The colours of the samples by their number, `0xAARRGGBB`, after [shade]. */
    val argb: IntArray = IntArray(room)

    /** Number of samples. */
    var size: Int = 0
        private set

    private val batch = FragmentBatch(FragmentBatch.CAPACITY).also { it.begin(Attributes.ALL) }

    /** The numbers of the samples in [batch]. */
    private val numbers = IntArray(FragmentBatch.CAPACITY)

    /** Adds a sample of the primitive [index], and returns its number. */
    fun add(index: Int, x: Int, y: Int): Int {
        indices[size] = index
        xs[size] = x
        ys[size] = y
        return size++
    }

    /** Computes [argb] of all samples. Ends if the calling thread is interrupted. */
    fun shade() {
        var together: BatchShader? = null
        batch.size = 0
        for (number in 0 until size) {
            endIfInterrupted()
            val primitive = primitives[indices[number]]
            val attributed = ((primitive as? MaskedPrimitive)?.whole ?: primitive) as? AttributedPrimitive
            val shader = attributed?.shader as? BatchShader
            fragment.moveTo(xs[number], ys[number])
            if (shader == null) {
                primitive.shade(fragment)
                argb[number] = fragment.toArgb()
                continue
            }
            if (shader !== together || batch.size == FragmentBatch.CAPACITY) {
                together?.let { shadeBatch(it) }
                together = shader
            }
            attributed.attributes(fragment)
            numbers[batch.size] = number
            batch.add(fragment)
        }
        together?.let { shadeBatch(it) }
    }

    private fun shadeBatch(shader: BatchShader) {
        if (batch.size > 0) batch.shade(shader)
        for (i in 0 until batch.size) argb[numbers[i]] = batch.toArgb(i)
        batch.size = 0
    }

    /** Removes all samples. */
    fun clear() {
        size = 0
    }

    companion object {
        /** Bytes of a sample: primitive, column, row and colour. */
        private const val SAMPLE_BYTES = 16L

        /** Arrays of a batch, with scratch memory of shaders, and the numbers of its fragments. */
        private const val BATCH_ARRAYS = 64L

        /** Bytes held with this [room], without primitives. */
        fun bytes(room: Int): Long = SAMPLE_BYTES * room + BATCH_ARRAYS * Int.SIZE_BYTES * FragmentBatch.CAPACITY
    }
}
