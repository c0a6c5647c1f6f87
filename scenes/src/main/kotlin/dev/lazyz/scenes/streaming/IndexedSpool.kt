package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import java.nio.file.Path
import org.joml.Vector3dc

/**
 * Vertices, and triangles with vertex numbers, in temporary files: 12 bytes a vertex and 12 a triangle, and 16 bytes for
 * each of those that have colours. Not thread safe.
 *
 * @param folder where to create the files
 * @param origin what positions are relative to
 */
internal class IndexedSpool(private val folder: Path, private val source: Source, val origin: Vector3dc) : AutoCloseable {
    private val files = ArrayList<WordSpool>()
    private val positions = words()
    private val triangles = words()
    private var vertexColors: WordSpool? = null
    private var triangleColors: WordSpool? = null
    private val extent = PartBox()
    private val boxes = ArrayList<Box?>()
    private var box = PartBox()
    private var inPart = 0

    /** Number of vertices so far. */
    val vertexCount: Int get() = (positions.size / 3).toInt()

    /** Whether a vertex has a colour. */
    val hasVertexColors: Boolean get() = vertexColors != null

    /** The smallest box around all vertices so far, used or not. */
    val bounds: Box? get() = extent.toBox()

    private fun words(): WordSpool = WordSpool(folder).also { files += it }

    /**
     * Adds the first [count] of [vertices] with their colours. Fails if there are more vertices than [Loading.limits]
     * allow.
     */
    fun vertices(vertices: VertexArrays, count: Int) {
        source.loading.spooled(source, count.toLong())
        if (vertexCount.toLong() + count >= Int.MAX_VALUE) {
            source.fail(null, "has ${Int.MAX_VALUE} vertices or more", "split it")
        }
        vertices.colors?.let { colors ->
            val to = vertexColors ?: words().also { vertexColors = it }
            to.whiten(vertexCount)
            for (i in 0 until 4 * count) to.add(colors[i].toRawBits())
        }
        val xyz = vertices.positions
        for (i in 0 until 3 * count step 3) {
            extent.add(xyz[i], xyz[i + 1], xyz[i + 2])
            for (axis in 0 until 3) positions.add(xyz[i + axis].toRawBits())
        }
    }

    /** Returns a coordinate of a vertex. */
    fun coordinate(vertex: Int, axis: Int): Float = Float.fromBits(positions[3L * vertex + axis])

    /**
     * Adds a triangle of vertices that were added before. Fails if there are more triangles than [Loading.limits] allow.
     */
    fun triangle(a: Int, b: Int, c: Int) {
        triangles.add(a)
        triangles.add(b)
        triangles.add(c)
        enclose(a)
        enclose(b)
        enclose(c)
        if (++inPart == FacetFile.PART) endPart()
    }

    private fun enclose(vertex: Int) = box.add(coordinate(vertex, 0), coordinate(vertex, 1), coordinate(vertex, 2))

    /** Sets the colour of the triangle that was added last. Earlier ones without a colour are white. */
    fun color(rgba: FloatArray) {
        val to = triangleColors ?: words().also { triangleColors = it }
        to.whiten((triangles.size / 3).toInt() - 1)
        for (channel in 0 until 4) to.add(rgba[channel].toRawBits())
    }

    private fun endPart() {
        source.loading.streamed(source, inPart.toLong())
        if (triangles.size / 3 > FacetSpool.MOST) {
            source.fail(null, "has more than ${FacetSpool.MOST} triangles", "split it")
        }
        boxes += box.toBox()
        box = PartBox()
        inPart = 0
    }

    /** Returns the triangles. No more can be added. */
    fun finish(): IndexedFacets {
        if (inPart > 0) endPart()
        val count = (triangles.size / 3).toInt()
        vertexColors?.whiten(vertexCount)
        triangleColors?.whiten(count)
        return IndexedFacets(triangles, positions, vertexColors, triangleColors, count, origin, boxes)
    }

    /** Deletes the files. */
    override fun close() = files.forEach { it.close() }

    private companion object {
        val WHITE = 1f.toRawBits()

        /** Adds white until there are [count] colours. */
        fun WordSpool.whiten(count: Int) {
            while (size < 4L * count) add(WHITE)
        }
    }
}
