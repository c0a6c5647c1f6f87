package dev.lazyz.setup.planar

import dev.lazyz.FrameContent
import dev.lazyz.Primitive
import dev.lazyz.PrimitiveBatch
import dev.lazyz.world.Mesh

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
    override val first: Int,
    private val setUp: PlanarSetUp,
    val grid: IntArray,
    private val inverseW: DoubleArray?,
    private val hidden: LongArray?,
    override val exceptions: List<IndexedValue<Primitive>>,
) : PrimitiveBatch {
    /** Number of triangles. */
    override val count: Int get() = mesh.triangleCount

    /** Vertex numbers, three a triangle. */
    val corners: IntArray get() = mesh.triangles

    /** Where in [grid] the numbers of vertex [corner], 0..2, of [triangle] begin. */
    fun place(triangle: Int, corner: Int): Int = STRIDE * corners[3 * triangle + corner]

    override fun isDrawn(number: Int): Boolean =
        hidden == null || hidden[number ushr WORD_SHIFT] ushr number and 1L == 0L

    /** 1 / w of a vertex. */
    fun inverseW(vertex: Int): Double = if (inverseW == null) 1.0 else inverseW[vertex]

    /** Returns what shades this batch's triangles; for one thread. */
    fun faces(): FaceSetUp = setUp.face(mesh)

    override fun primitives(): Sequence<Primitive> = setUp.mesh(mesh)

    companion object {
        /** Numbers a vertex in [grid]. */
        const val STRIDE: Int = 3

        /** Shift from a bit to its word of 64. */
        const val WORD_SHIFT: Int = 6
    }
}

/** Returns the batch with a number in [FrameContent.batches]; batches of triangles are the only kind. */
internal fun FrameContent.triangleBatch(number: Int): TriangleBatch = batches[number] as TriangleBatch

/** Returns the batch that the primitive with a submission index is drawn from; there must be one. */
internal fun FrameContent.triangleBatchWith(index: Int): TriangleBatch = triangleBatch(batchNumber(index))
