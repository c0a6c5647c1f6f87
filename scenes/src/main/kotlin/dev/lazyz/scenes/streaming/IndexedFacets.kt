package dev.lazyz.scenes.streaming

import dev.lazyz.geometry.Box
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.MeshSource
import org.joml.Vector3dc

/**
 * Triangles in the files of an [IndexedSpool], in parts as those of [FacetFile].
 *
 * @param triangles three vertex numbers for each triangle
 * @param positions x, y, z of each vertex
 * @param vertexColors red, green, blue, alpha of each vertex, or null if they have no colours
 * @param triangleColors the same for each triangle; used if vertices have none
 */
internal class IndexedFacets(
    private val triangles: WordSpool,
    private val positions: WordSpool,
    private val vertexColors: WordSpool?,
    private val triangleColors: WordSpool?,
    override val triangleCount: Int,
    override val origin: Vector3dc,
    private val boxes: List<Box?>,
) : MeshSource {
    override val hasColors: Boolean get() = vertexColors != null || triangleColors != null

    override val partCount: Int get() = boxes.size

    override fun triangleCount(number: Int): Int = minOf(FacetFile.PART, triangleCount - number * FacetFile.PART)

    override fun bounds(number: Int): Box? = boxes[number]

    override fun read(first: Int, count: Int): Mesh {
        val start = first * FacetFile.PART
        val corners = 3 * minOf(count * FacetFile.PART, triangleCount - start)
        val numbers = IntArray(corners) { triangles[3L * start + it] }
        val xyz = FloatArray(3 * corners)
        for (corner in 0 until corners) gather(positions, 3, numbers[corner], xyz, corner)
        return Mesh(xyz, IntArray(corners) { it }, colors = colors(start, numbers), origin = origin)
    }

    private fun colors(start: Int, numbers: IntArray): FloatArray? {
        if (!hasColors) return null
        val all = FloatArray(4 * numbers.size)
        for (corner in numbers.indices) {
            if (vertexColors != null) {
                gather(vertexColors, 4, numbers[corner], all, corner)
            } else if (triangleColors != null) {
                gather(triangleColors, 4, start + corner / 3, all, corner)
            }
        }
        return all
    }

    private fun gather(from: WordSpool, width: Int, number: Int, to: FloatArray, corner: Int) {
        for (i in 0 until width) to[width * corner + i] = Float.fromBits(from[width.toLong() * number + i])
    }
}
