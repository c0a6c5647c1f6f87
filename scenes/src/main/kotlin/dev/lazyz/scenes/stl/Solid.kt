package dev.lazyz.scenes.stl

import dev.lazyz.Material
import dev.lazyz.Mesh
import dev.lazyz.scenes.triangulation.Floats
import dev.lazyz.scenes.triangulation.Ints

/**
 * Triangles without shared vertices, which find each other: corners with equal coordinates become one vertex.
 *
 * Equal means equal numbers, with -0 equal to 0 and every NaN equal to every other; nothing is merged for being near.
 * Not thread safe.
 *
 * @property name what the file calls it
 */
internal class Solid(val name: String) {
    private val vertexOf = HashMap<Position, Int>()
    private val positions = Floats()
    private val triangles = Ints()

    /** Number of triangles so far. */
    val triangleCount: Int get() = triangles.size / 3

    /** Adds the next corner; three make a triangle. */
    fun add(x: Float, y: Float, z: Float) {
        triangles.add(
            vertexOf.getOrPut(Position(x + 0f, y + 0f, z + 0f)) {
                positions.add(x)
                positions.add(y)
                positions.add(z)
                positions.size / 3 - 1
            },
        )
    }

    /** Returns the solid so far as a mesh without normals. */
    fun mesh(): Mesh = Mesh(positions.toArray(), triangles.toArray(), Material(name = name))

    /** Floats compare by their bits here, as boxed numbers do; adding 0 has made -0 into 0. */
    private data class Position(val x: Float, val y: Float, val z: Float)
}
