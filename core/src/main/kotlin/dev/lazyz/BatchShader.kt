package dev.lazyz

/**
 * A [Shader] that colours many fragments per call, in loops that the JVM can vectorise. It is faster than a plain
 * shader if the computation is long, and as fast otherwise. Keep loops short, with few arrays in each: compilers do not
 * vectorise long loops.
 *
 * The colour of a fragment must depend only on the attributes of that fragment, not on its index in the batch or on
 * other fragments. Each renderer fills batches differently, and some shade fragments one by one. Must be thread safe,
 * like all shaders. Use only the arithmetic of contract rule 6.3.
 *
 * ```
 * val stripes = BatchShader { batch ->
 *     for (i in 0 until batch.size) {
 *         batch.red[i] = batch.u[i] * batch.vertexRed[i]
 *         batch.green[i] = batch.v[i]
 *         batch.blue[i] = 0.5f
 *     }
 * }
 * ```
 */
public fun interface BatchShader : Shader {
    /**
     * Reads the attributes of the first [FragmentBatch.size] elements of [batch], and writes their colours. It must not
     * write to other arrays. A colour that is not written is opaque black.
     */
    public fun shade(batch: FragmentBatch)

    /** Shades one fragment, as a batch of one. */
    override fun shade(fragment: Fragment) {
        fragment.singleBatch.shade(fragment, this)
    }
}
