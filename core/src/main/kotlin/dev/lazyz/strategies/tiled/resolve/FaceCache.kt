package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.FrameContent
import dev.lazyz.HeapLayout
import dev.lazyz.PrimitiveBatch
import dev.lazyz.setup.FaceStage
import dev.lazyz.setup.PixelShadedPrimitive
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.setup.ShadingPoints
import dev.lazyz.setup.triangleBatch
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Fragment

/**
 * A cache of recently used flat primitives: a primitive is often used again on the next row. Belongs to one thread.
 *
 * @property isUsed whether the cache is enabled
 */
internal class FaceCache(private val content: FrameContent, val isUsed: Boolean) {
    /** Where primitives are shaded that have one colour in each pixel; null if none has. */
    val points: ShadingPoints? = content.shading as ShadingPoints?

    /** Faces by the lower bits of their indices. */
    private val faces = arrayOfNulls<Face>(if (isUsed) FACES else 0)

    /** The set-up of the triangles of each batch, created on first use. */
    private val setUps = arrayOfNulls<FaceStage>(content.batches.size)

    /** The last batch that was looked up, its number, and its primitives. */
    private var last: PrimitiveBatch? = null
    private var lastNumber = -1
    private var lastFirst = 0
    private var lastCount = 0
    private val scratch = Fragment()

    /** Peak number of bytes held. */
    val bytes: Long get() = faces.size * (HeapLayout.FACE + 3 * Vertices.LONG_STRIDE * Double.SIZE_BYTES)

    /** Whether primitive [index] has a face. */
    fun isFlat(index: Int): Boolean = isUsed && (batch(index) >= 0 || flat(index) != null)

    /**
     * Returns the flat primitive that single primitive [index] is; a triangle also if it has one colour in a pixel, at
     * the [points] of this content. One that comes from another frame has points of its own, and finds them itself.
     */
    private fun flat(index: Int): PlanarPrimitive? {
        val single = content.single(index)
        if (single !is PixelShadedPrimitive) return single as? PlanarPrimitive
        return (single.whole as? PlanarPrimitive)?.takeIf { it.isTriangle && single.points === points }
    }

    /** Whether primitive [index] has one colour in each pixel, see [ShadingPoints]. */
    fun isOnce(index: Int): Boolean {
        val points = points ?: return false
        val number = if (isUsed) batch(index) else content.batchNumber(index)
        return if (number >= 0) points.isOnce(setUp(number).shader) else content.single(index) is PixelShadedPrimitive
    }

    /** Returns the face of primitive [index] if its colour is constant and this is known without loading the face. */
    fun constant(index: Int): Face? {
        val number = batch(index)
        if (number < 0 || !setUp(number).isConstant(index - content.batches[number].first)) return null
        return face(index)?.takeIf { it.isConstant }
    }

    /** Returns the face of primitive [index], or null if it has none. */
    fun face(index: Int): Face? {
        if (!isUsed) return null
        val slot = index and FACES - 1
        val known = faces[slot]
        if (known != null && known.index == index) return known
        val number = batch(index)
        val flat = if (number < 0) flat(index) ?: return null else null
        val face = known ?: Face().also { faces[slot] = it }
        if (flat != null) {
            face.fill(index, flat, scratch)
        } else {
            val batch = content.triangleBatch(number)
            face.fill(batch, index - batch.first, setUp(number), scratch)
        }
        return face
    }

    /** Returns the number of a primitive's batch, or -1; in most cases it is the same as for the previous primitive. */
    fun batch(index: Int): Int {
        val triangle = index - lastFirst
        if (triangle >= 0 && triangle < lastCount && last!!.isDrawn(triangle)) return lastNumber
        val number = content.batchNumber(index)
        if (number >= 0) {
            val batch = content.batches[number]
            last = batch
            lastNumber = number
            lastFirst = batch.first
            lastCount = batch.count
        }
        return number
    }

    /** Returns the set-up of the triangles of batch [number]. */
    fun setUp(number: Int): FaceStage =
        setUps[number] ?: content.triangleBatch(number).faces().also { setUps[number] = it }

    private companion object {
        /** Number of cached primitives, a power of two. */
        const val FACES = 64
    }
}
