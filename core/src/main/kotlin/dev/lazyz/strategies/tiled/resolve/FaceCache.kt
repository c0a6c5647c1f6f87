package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.Fragment
import dev.lazyz.FrameContent
import dev.lazyz.setup.planar.FaceSetUp
import dev.lazyz.setup.planar.PlanarPrimitive
import dev.lazyz.setup.planar.triangleBatch

/**
 * Flat primitives lately seen: one is met again on the next row. Belongs to one thread.
 *
 * @property isUsed whether there are faces at all
 */
internal class FaceCache(private val content: FrameContent, val isUsed: Boolean) {
    /** By the lower bits of their indices. */
    private val faces = arrayOfNulls<Face>(if (isUsed) FACES else 0)

    /** What sets up the triangles of each batch, made when it is first met. */
    private val setUps = arrayOfNulls<FaceSetUp>(content.batches.size)
    private var lastBatch = -1
    private val scratch = Fragment()

    /** Bytes held at most. */
    val bytes: Long get() = faces.size * Face.BYTES

    /** Whether primitive [index] has a face. */
    fun isFlat(index: Int): Boolean = isUsed && (batch(index) >= 0 || content.single(index) is PlanarPrimitive)

    /** Returns the face of primitive [index] if that has one colour, and if this is to be seen without the face. */
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
        val flat = if (number < 0) content.single(index) as? PlanarPrimitive ?: return null else null
        val face = known ?: Face().also { faces[slot] = it }
        if (flat != null) {
            face.fill(index, flat, scratch)
        } else {
            val batch = content.triangleBatch(number)
            face.fill(batch, index - batch.first, setUp(number), scratch)
        }
        return face
    }

    /** Returns the number of the batch that a primitive is drawn from, or -1; mostly it is that of the one before. */
    fun batch(index: Int): Int {
        if (lastBatch >= 0) {
            val triangle = index - content.batches[lastBatch].first
            if (triangle >= 0 && triangle < content.batches[lastBatch].count &&
                content.batches[lastBatch].isDrawn(triangle)
            ) {
                return lastBatch
            }
        }
        val number = content.batchNumber(index)
        if (number >= 0) lastBatch = number
        return number
    }

    /** Returns what sets up the triangles of batch [number]. */
    fun setUp(number: Int): FaceSetUp =
        setUps[number] ?: content.triangleBatch(number).faces().also { setUps[number] = it }

    private companion object {
        /** Primitives that are remembered, a power of two. */
        const val FACES = 64
    }
}
