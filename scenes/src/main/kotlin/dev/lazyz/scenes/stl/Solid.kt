package dev.lazyz.scenes.stl

import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.CornerMesh
import dev.lazyz.scenes.meshes.Palette
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.Material
import dev.lazyz.world.Mesh
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Triangles without shared vertices, which find each other: corners with equal coordinates become one vertex.
 *
 * Equal means equal numbers, with -0 equal to 0 and every NaN equal to every other; nothing is merged for being near.
 * Not thread safe.
 *
 * @property name what the file calls it
 * @param expectedTriangles how many to make room for
 * @param palette the colours of triangles, if they have any
 * @param origin what was subtracted from all positions
 */
internal class Solid(
    val name: String,
    expectedTriangles: Int = 0,
    private val palette: Palette? = null,
    private val origin: Vector3dc = Vector3d(),
) {
    /** Bits of x, y, z; in a closed mesh there are half as many vertices as triangles. */
    private val positions = DistinctTriples(expectedTriangles / 2)
    private val triangles = Ints(3 * expectedTriangles)

    /** By triangle: number of its colour, or -1. */
    private val colors = Ints()

    /** Number of triangles so far. */
    val triangleCount: Int get() = triangles.size / 3

    /** Number of vertices so far. */
    val vertexCount: Int get() = positions.size

    /** Adds the next corner; three make a triangle. */
    fun add(x: Float, y: Float, z: Float) {
        // Adding 0 makes -0 into 0, and toBits all NaN into one
        triangles.add(positions.add((x + 0f).toBits(), (y + 0f).toBits(), (z + 0f).toBits()))
    }

    /** Gives the triangle that was added last a colour of the palette. */
    fun color(number: Int) {
        colors.add(number)
    }

    /** Returns x, y, z of each vertex so far. */
    fun positions(): FloatArray {
        val coordinates = FloatArray(3 * positions.size)
        for (i in 0 until positions.size) {
            for (axis in 0 until 3) coordinates[3 * i + axis] = Float.fromBits(positions.get(i, axis))
        }
        return coordinates
    }

    /** Returns the solid, which [source] holds, as a mesh without normals; add no more corners then. */
    fun mesh(source: Source): Mesh {
        val coordinates = positions()
        val material = Material(name = name)
        if (palette == null) return Mesh(coordinates, triangles.toArray(), material, origin = origin)
        val mesh = CornerMesh(VertexArrays(coordinates), palette)
        for (corner in 0 until triangles.size) mesh.add(triangles[corner], colors[corner / 3])
        return mesh.mesh(source, material)
    }
}
