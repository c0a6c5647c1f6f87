package dev.lazyz.scenes.meshes

import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh

/**
 * A lumpy ball with the defects that real meshes have: T-junctions, slivers, triangles without area, faces that are
 * there twice or turned round, normals that point inward or nowhere, texture coordinates far outside of the texture,
 * and a vertex that no face uses. The same every time.
 */
internal object AwkwardMesh {
    private const val ROUND = 12
    private const val HIGH = 9

    /** Corners of a triangle as vertex numbers, three a triangle. */
    val triangles: IntArray

    /** Three numbers a vertex. */
    val positions: FloatArray

    /** Three numbers a vertex. */
    val normals: FloatArray

    /** The normals, without those that point nowhere, which loaders replace. */
    val directions: FloatArray by lazy {
        FloatArray(normals.size) { if (it / 3 % 10 == 0) positions[it] else normals[it] }
    }

    /** Two numbers a vertex. */
    val uvs: FloatArray

    init {
        val places = ArrayList<Float>()
        val coordinates = ArrayList<Float>()
        for (row in 0..HIGH) {
            for (column in 0..ROUND) {
                // The last column is the first one again, but for its texture coordinates
                val angle = column % ROUND * 2 * StrictMath.PI / ROUND
                val height = row * StrictMath.PI / HIGH
                val radius = 1 + 0.2 * StrictMath.sin(5 * angle) * StrictMath.sin(3 * height)
                val around = radius * StrictMath.sin(height)
                val x = around * StrictMath.cos(angle)
                val y = around * StrictMath.sin(angle)
                // No -0, which counts as the same place as 0
                places += listOf(x, y, radius * StrictMath.cos(height)).map { it.toFloat() + 0f }
                val far = if (row == 4) 1000f else 1f
                coordinates += listOf(far * (column / 4f - 1), row / 4f - 0.5f)
            }
        }
        val faces = ArrayList<List<Int>>()
        for (row in 0 until HIGH) {
            for (column in 0 until ROUND) {
                val a = row * (ROUND + 1) + column
                val d = a + ROUND + 1
                val isSplit = (row + column) % 5 == 0
                faces += listOf(a, d, a + 1)
                if (!isSplit) faces += listOf(a + 1, d, d + 1)
                if (!isSplit) continue
                // A vertex on an edge, of which the neighbour knows nothing; and one beside it, for a sliver
                val middle = places.size / 3
                for (k in 0 until 3) places += (places[3 * d + k] + places[3 * (d + 1) + k]) / 2
                for (k in 0 until 3) places += places[3 * middle + k] * 1.00001f
                repeat(4) { coordinates += -7.25f }
                faces += listOf(a + 1, d, middle)
                faces += listOf(a + 1, middle, d + 1)
                faces += listOf(d, middle + 1, d + 1)
            }
        }
        for (face in faces.filterIndexed { i, _ -> i % 11 == 0 }) faces += face
        for (face in faces.filterIndexed { i, _ -> i % 13 == 0 }) faces += face.reversed()
        faces += listOf(20, 20, 33)
        faces += listOf(47, 47, 47)
        places += listOf(50f, -50f, 50f)
        coordinates += listOf(0f, 0f)
        positions = places.toFloatArray()
        uvs = coordinates.toFloatArray()
        triangles = faces.flatten().toIntArray()
        normals = FloatArray(positions.size) { i ->
            val sign = if (i / 3 % 7 == 0) {
                -1f
            } else if (i / 3 % 10 == 0) {
                0f
            } else {
                3f
            }
            sign * positions[i]
        }
    }

    /** Returns it as a mesh with all attributes. */
    fun of(material: Material): Mesh = Mesh(positions, triangles, material, normals, uvs)

    /** Returns the numbers of [perVertex] of each triangle's corners, [size] a vertex. */
    fun corners(perVertex: FloatArray, size: Int): List<List<Float>> =
        triangles.map { perVertex.slice(size * it until size * (it + 1)) }

    /** Returns the nine numbers of each triangle's position. */
    fun facets(): List<FloatArray> = corners(positions, 3).chunked(3) { it.flatten().toFloatArray() }
}
