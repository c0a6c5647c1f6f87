package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.scenes.meshes.VertexPositions
import org.joml.Vector3dc

/**
 * Temporary files of the positions and colours of vertices, so that faces can refer to them. Not thread safe.
 *
 * @param space where to create the files, and the room that they may take
 * @property origin what positions are relative to
 */
internal class VertexSpool(private val space: SpoolSpace, private val source: Source, val origin: Vector3dc) :
    VertexPositions,
    AutoCloseable {
    private val positions = FloatSpool(space, 3)
    private var colors: FloatSpool? = null
    private val box = PartBox()
    private var counted = 0

    /** The smallest box around all vertices so far. */
    val bounds: Box? get() = box.toBox()

    /** Number of vertices so far. */
    val size: Int get() = positions.size

    /** Whether a vertex has a colour. */
    val hasColors: Boolean get() = colors != null

    /** Adds the first [count] vertices of [block]. */
    fun add(block: VertexArrays, count: Int) {
        for (vertex in 0 until count) {
            val at = 3 * vertex
            add(block.positions[at], block.positions[at + 1], block.positions[at + 2])
            val from = block.colors ?: continue
            color(from[4 * vertex], from[4 * vertex + 1], from[4 * vertex + 2], from[4 * vertex + 3])
        }
    }

    /** Adds a vertex. Fails if there are more vertices than the limits allow. */
    fun add(x: Float, y: Float, z: Float) {
        positions.add(x)
        positions.add(y)
        positions.add(z)
        box.add(x, y, z)
        if (size - counted == COUNTED) count()
    }

    private fun count() {
        source.loading.streamedVertices(source, (size - counted).toLong())
        counted = size
    }

    /** Sets the colour of the vertex that was added last. Vertices without one are white. */
    fun color(red: Float, green: Float, blue: Float, alpha: Float) {
        val to = colors ?: FloatSpool(space, 4).also { colors = it }
        to.fill(size - 1)
        to.add(red)
        to.add(green)
        to.add(blue)
        to.add(alpha)
    }

    private fun FloatSpool.fill(count: Int) {
        while (this.size < count) repeat(4) { add(1f) }
    }

    /** Ends writing: from now on, vertices can be read. */
    fun finish() {
        count()
        positions.finish()
        colors?.fill(size)
        colors?.finish()
    }

    override fun get(vertex: Int, axis: Int): Float = positions.get(vertex, axis)

    /** Adds the three corners of a triangle to [facets], and the colours of its vertices if they have any. */
    fun addTo(facets: FacetSpool, a: Int, b: Int, c: Int) {
        corner(facets, a)
        corner(facets, b)
        corner(facets, c)
        val colors = colors ?: return
        color(facets, colors, a)
        color(facets, colors, b)
        color(facets, colors, c)
    }

    private fun corner(facets: FacetSpool, vertex: Int) =
        facets.add(positions.get(vertex, 0), positions.get(vertex, 1), positions.get(vertex, 2))

    private fun color(facets: FacetSpool, colors: FloatSpool, vertex: Int) =
        facets.color(colors.get(vertex, 0), colors.get(vertex, 1), colors.get(vertex, 2), colors.get(vertex, 3))

    /** Deletes the files. */
    override fun close() {
        colors?.close()
        positions.close()
    }

    private companion object {
        /** Vertices after which the limits are checked. */
        const val COUNTED = 1 shl 14
    }
}
