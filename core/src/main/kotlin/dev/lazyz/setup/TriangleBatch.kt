package dev.lazyz.setup

import dev.lazyz.ChangedPrimitive
import dev.lazyz.Checkpoint
import dev.lazyz.FrameContent
import dev.lazyz.Primitive
import dev.lazyz.PrimitiveBatch
import dev.lazyz.Region
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.Vertices
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh

/**
 * The opaque triangles of a mesh, set up for one raster and camera: arrays of snapped vertices, and no object for each
 * triangle. Immutable and thread safe. Memory: 20 bytes a vertex, 12 without perspective.
 *
 * Triangle t is the primitive with submission index [first] + t. Renderers that do not use batches get it from
 * [primitives]. Triangles that must be clipped, or whose visible side is not drawn, are not drawn from this batch, see
 * [isDrawn]. Those that must be clipped are in [exceptions].
 *
 * @property first submission index of triangle 0
 * @property grid column and row (1/256 pixel) and depth of each vertex, [STRIDE] numbers for each. They are stored
 *   together because triangles are visited in any order
 */
internal class TriangleBatch(
    val mesh: Mesh,
    override val first: Int,
    private val setUp: MeshStage,
    val grid: IntArray,
    private val inverseW: DoubleArray?,
    private val hidden: LongArray?,
    override val exceptions: List<IndexedValue<Primitive>>,
) : PrimitiveBatch {
    /** Number of triangles. */
    override val count: Int get() = mesh.triangleCount

    /** Vertex numbers, three for each triangle. */
    val corners: IntArray get() = mesh.triangles

    /** The transforms that made [grid]. */
    val stage: VertexStage get() = setUp.stage

    /** Returns the index in [grid] of the first number of vertex [corner], 0..2, of [triangle]. */
    fun place(triangle: Int, corner: Int): Int = STRIDE * corners[3 * triangle + corner]

    /** Passes the vertices of [triangle], in grid units, to [use]. */
    inline fun <R> vertices(
        triangle: Int,
        use: (ax: Int, ay: Int, bx: Int, by: Int, cx: Int, cy: Int) -> R,
    ): R {
        val a = place(triangle, 0)
        val b = place(triangle, 1)
        val c = place(triangle, 2)
        return use(grid[a], grid[a + 1], grid[b], grid[b + 1], grid[c], grid[c + 1])
    }

    override fun isDrawn(number: Int): Boolean =
        hidden == null || hidden[number ushr WORD_SHIFT] ushr number and 1L == 0L

    override fun boundsIn(region: Region, number: Int): Region? = vertices(number) { ax, ay, bx, by, cx, cy ->
        ScreenGrid.bounds(ax, ay, bx, by, cx, cy, region::intersect)
    }

    private fun depth(triangle: Int, corner: Int): Int = grid[place(triangle, corner) + 2]

    /** Rounding can move depths beyond those of the vertices by a unit. */
    override fun leastDepth(number: Int): Int =
        minOf(depth(number, 0), minOf(depth(number, 1), depth(number, 2))) - 1

    override fun greatestDepth(number: Int): Int =
        maxOf(depth(number, 0), maxOf(depth(number, 1), depth(number, 2))) + 1

    /** 1/w of a vertex. */
    fun inverseW(vertex: Int): Double = if (inverseW == null) 1.0 else inverseW[vertex]

    /** Returns an object that shades the triangles of this batch; for one thread. */
    fun faces(): FaceStage = setUp.face(mesh)

    override fun reader(): (Int) -> Primitive = faces()::primitive

    override fun unshaded(): TriangleBatch {
        val plain = Material(shading = Shading.CONSTANT, sides = mesh.material.sides)
        val bare = Mesh(mesh.positions, mesh.triangles, plain, origin = mesh.origin)
        return TriangleBatch(bare, first, setUp, grid, inverseW, hidden, exceptions)
    }

    override fun primitives(checkpoint: Checkpoint): Sequence<Primitive> = setUp.mesh(mesh, checkpoint)

    companion object {
        /** Numbers for each vertex in [grid]. */
        const val STRIDE: Int = 3

        /** Converts the index of a bit to the index of its 64-bit word, as a right shift. */
        const val WORD_SHIFT: Int = 6
    }
}

/** Returns batch [number] of [FrameContent.batches]. All batches are triangle batches. */
internal fun FrameContent.triangleBatch(number: Int): TriangleBatch = batches[number] as TriangleBatch

/** Returns the batch that draws the primitive with submission index [index]; there must be one. */
internal fun FrameContent.triangleBatchWith(index: Int): TriangleBatch = triangleBatch(batchNumber(index))

/** The vertices that this primitive references and shares with others, or null if it is known to share none. */
internal fun Primitive.sharedVertices(): Vertices? = when (this) {
    is PlanarPrimitive -> vertices
    is ChangedPrimitive -> whole.sharedVertices()
    else -> null
}
