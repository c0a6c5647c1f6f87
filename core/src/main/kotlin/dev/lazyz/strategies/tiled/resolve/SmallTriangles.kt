package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.FrameContent
import dev.lazyz.bytes
import dev.lazyz.raster.EdgeForms
import dev.lazyz.setup.triangleBatch
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer

/**
 * Waiting fragments of triangles that are too small to load a face for each: all of one batch. Belongs to one thread;
 * reused for each tile.
 */
internal class SmallTriangles(
    private val content: FrameContent,
    private val keys: VisibilityBuffer,
    private val faces: FaceCache,
) {
    val fragments: WaitingFragments = WaitingFragments()
    private val triangles = IntArray(FragmentBatch.CAPACITY)
    private var batch = -1
    private val attributes = ScatteredAttributes()
    private val edges = EdgeForms()

    /** Bytes held. */
    val bytes: Long get() = fragments.bytes + attributes.bytes + triangles.bytes

    /** Whether triangles of batch number [batch] can be shaded so: they have attributes of the mesh alone. */
    fun accepts(batch: Int): Boolean =
        batch >= 0 && faces.setUp(batch).isShared && faces.setUp(batch).fields and Attributes.FOOTPRINT == 0

    /** Whether there is room for [count] more fragments of batch number [batch]. */
    fun hasRoom(batch: Int, count: Int): Boolean = batch == this.batch && count <= fragments.room

    /** Begins to collect fragments of batch number [batch]; none are waiting. */
    fun begin(batch: Int) {
        this.batch = batch
        fragments.batch.begin(faces.setUp(batch).fields)
    }

    /** Adds samples of primitive [index], see [FragmentShading.add]. There must be room for them. */
    fun add(index: Int, start: Int, length: Int) {
        val first = fragments.size
        val triangle = index - content.batches[batch].first
        if (PrimitiveRuns.isOfPixels(start)) {
            fragments.addPixels(start, length, faces.points!!.side)
        } else if (faces.isOnce(index)) {
            content.triangleBatch(batch).vertices(triangle) { ax, ay, bx, by, cx, cy ->
                edges.opposite(ax, ay, bx, by, cx, cy)
            }
            fragments.addPart(start, length, keys, faces.points!!, edges)
        } else {
            fragments.add(start, length)
        }
        triangles.fill(triangle, first, fragments.size)
    }

    /** Computes the attributes of the fragments, and returns their shader. */
    fun complete(): Shader {
        val setUp = faces.setUp(batch)
        fragments.locate(keys.columnStart, keys.rowStart)
        attributes.fill(
            fragments, keys.columnStart, keys.rowStart, content.triangleBatch(batch), triangles, setUp,
        )
        return setUp.shader
    }
}
