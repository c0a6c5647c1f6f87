package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.FaceStage
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.shading.Vertices
import dev.lazyz.spi.Attributes
import dev.lazyz.spi.FragmentBatch

/**
 * Attributes of fragments that may each belong to a different triangle. Each step processes all fragments, without any
 * set-up for a triangle. The results equal those of [dev.lazyz.strategies.tiled.resolve.Face] bit for bit. Belongs to
 * one thread.
 *
 * There is only one implementation: most of the time is spent waiting for memory, and vector gather loads did not make
 * it faster.
 */
internal class ScatteredAttributes {
    /** Weight of each of a fragment's vertices. */
    private val weight0 = DoubleArray(FragmentBatch.CAPACITY)
    private val weight1 = DoubleArray(FragmentBatch.CAPACITY)
    private val weight2 = DoubleArray(FragmentBatch.CAPACITY)

    /** Numbers of each fragment's vertices. */
    private val vertex0 = IntArray(FragmentBatch.CAPACITY)
    private val vertex1 = IntArray(FragmentBatch.CAPACITY)
    private val vertex2 = IntArray(FragmentBatch.CAPACITY)

    /** Factors of attributes: 1, or for normals the sign that makes each fragment's normal face the viewer. */
    private val signs = DoubleArray(FragmentBatch.CAPACITY)
    private val vertices = Vertices(3)

    /** Bytes held. */
    val bytes: Long get() = FragmentBatch.CAPACITY * (4L * Double.SIZE_BYTES + 3L * Int.SIZE_BYTES)

    /**
     * Fills in the attributes of all [fragments], in a tile whose first sample is ([x], [y]). They belong to the
     * triangles [numbers] of [triangles]. Requires [FaceStage.isShared], and no [Attributes.FOOTPRINT].
     */
    fun fill(
        fragments: WaitingFragments,
        x: Int,
        y: Int,
        triangles: TriangleBatch,
        numbers: IntArray,
        faces: FaceStage,
    ) {
        val fields = faces.fields
        if (fields == 0) return
        val batch = fragments.batch
        val count = batch.size
        for (i in 0 until count) weigh(triangles, numbers[i], fragments.gridX(i, x), fragments.gridY(i, y), i)
        normalize(count)
        val mesh = triangles.mesh
        signs.fill(1.0, 0, count)
        if (fields and Attributes.WORLD != 0) {
            mix(mesh.positions, 3, 0, batch.worldX, count)
            mix(mesh.positions, 3, 1, batch.worldY, count)
            mix(mesh.positions, 3, 2, batch.worldZ, count)
        }
        mesh.uvs?.takeIf { fields and Attributes.UV != 0 }?.let { uvs ->
            mix(uvs, 2, 0, batch.u, count)
            mix(uvs, 2, 1, batch.v, count)
        }
        mesh.uvs2?.takeIf { fields and Attributes.UV2 != 0 }?.let { uvs ->
            mix(uvs, 2, 0, batch.u2, count)
            mix(uvs, 2, 1, batch.v2, count)
        }
        mesh.colors?.takeIf { fields and Attributes.COLOR != 0 }?.let { colors ->
            mix(colors, 4, 0, batch.vertexRed, count)
            mix(colors, 4, 1, batch.vertexGreen, count)
            mix(colors, 4, 2, batch.vertexBlue, count)
            mix(colors, 4, 3, batch.vertexAlpha, count)
        }
        mesh.normals?.takeIf { fields and Attributes.NORMAL != 0 }?.let { normals ->
            for (i in 0 until count) signs[i] = faces.normalSign(triangles, numbers[i], vertices)
            mix(normals, 3, 0, batch.normalX, count)
            mix(normals, 3, 1, batch.normalY, count)
            mix(normals, 3, 2, batch.normalZ, count)
        }
        mesh.tangents?.takeIf { fields and Attributes.TANGENT != 0 }?.let { tangents ->
            // The signs are still those of the normals
            mix(tangents, 4, 0, batch.tangentX, count)
            mix(tangents, 4, 1, batch.tangentY, count)
            mix(tangents, 4, 2, batch.tangentZ, count)
            mix(tangents, 4, 3, batch.tangentW, count)
        }
    }

    /** Sets weights number [i] to the edge functions of [triangle] at a point, each divided by its vertex's w. */
    private fun weigh(triangles: TriangleBatch, triangle: Int, gridX: Int, gridY: Int, i: Int) {
        val corners = triangles.corners
        val grid = triangles.grid
        val a = corners[3 * triangle]
        val b = corners[3 * triangle + 1]
        val c = corners[3 * triangle + 2]
        val right = gridX + ScreenGrid.CENTER
        val down = gridY + ScreenGrid.CENTER

        // The edge functions, relative to the sample. With Edge.function, S2 takes 8 percent more processor time
        val ax = (grid[TriangleBatch.STRIDE * a] - right).toLong()
        val ay = (grid[TriangleBatch.STRIDE * a + 1] - down).toLong()
        val bx = (grid[TriangleBatch.STRIDE * b] - right).toLong()
        val by = (grid[TriangleBatch.STRIDE * b + 1] - down).toLong()
        val cx = (grid[TriangleBatch.STRIDE * c] - right).toLong()
        val cy = (grid[TriangleBatch.STRIDE * c + 1] - down).toLong()
        val e0 = bx * cy - by * cx
        val e1 = cx * ay - cy * ax
        val e2 = ax * by - ay * bx
        val sign = if (e0 + e1 + e2 < 0) -1L else 1L
        weight0[i] = (sign * e0).toDouble() * triangles.inverseW(a)
        weight1[i] = (sign * e1).toDouble() * triangles.inverseW(b)
        weight2[i] = (sign * e2).toDouble() * triangles.inverseW(c)
        vertex0[i] = a
        vertex1[i] = b
        vertex2[i] = c
    }

    /** Divides each fragment's weights by their sum. */
    private fun normalize(count: Int) {
        for (i in 0 until count) {
            val scale = 1.0 / maxOf(weight0[i] + weight1[i] + weight2[i], 0.0)
            weight0[i] *= scale
            weight1[i] *= scale
            weight2[i] *= scale
        }
    }

    /** Interpolates number [k] of the [stride] numbers that [data] has for each vertex, and multiplies by the signs. */
    private fun mix(data: FloatArray, stride: Int, k: Int, out: FloatArray, count: Int) {
        for (i in 0 until count) {
            val a = data[stride * vertex0[i] + k]
            val b = data[stride * vertex1[i] + k]
            val c = data[stride * vertex2[i] + k]
            out[i] = (signs[i] * (weight0[i] * a + weight1[i] * b + weight2[i] * c)).toFloat()
        }
    }
}
