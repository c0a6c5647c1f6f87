package dev.lazyz.scenes.builtin

import dev.lazyz.Rgba
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh

/** Collects quads with texture coordinates and colours, and builds one mesh from them. */
internal class MeshBuilder {
    private var positions = FloatArray(256)
    private var uvs = FloatArray(256)
    private var colors = FloatArray(256)
    private var triangles = IntArray(256)
    private var vertexCount = 0
    private var indexCount = 0

    /** Colour of the vertices that are added next. */
    var color: Rgba = Rgba.WHITE

    /**
     * Adds a rectangle from [corner], spanned by the vectors [a] to the right and [b] up as seen from outside. The
     * texture is repeated [across] times horizontally and [down] times vertically.
     */
    fun rectangle(corner: DoubleArray, a: DoubleArray, b: DoubleArray, across: Double = 1.0, down: Double = 1.0) {
        val first = vertexCount
        vertex(corner[0], corner[1], corner[2], 0.0, down)
        vertex(corner[0] + a[0], corner[1] + a[1], corner[2] + a[2], across, down)
        vertex(corner[0] + a[0] + b[0], corner[1] + a[1] + b[1], corner[2] + a[2] + b[2], across, 0.0)
        vertex(corner[0] + b[0], corner[1] + b[1], corner[2] + b[2], 0.0, 0.0)
        triangle(first, first + 1, first + 2)
        triangle(first, first + 2, first + 3)
    }

    /** Adds the four walls of an upright box. The texture repeats every [tile] units. */
    fun walls(x0: Double, z0: Double, x1: Double, z1: Double, y0: Double, y1: Double, tile: Double) {
        val up = doubleArrayOf(0.0, y1 - y0, 0.0)
        val u = (x1 - x0) / tile
        val w = (z1 - z0) / tile
        val v = (y1 - y0) / tile
        rectangle(doubleArrayOf(x0, y0, z1), doubleArrayOf(x1 - x0, 0.0, 0.0), up, u, v)
        rectangle(doubleArrayOf(x1, y0, z1), doubleArrayOf(0.0, 0.0, z0 - z1), up, w, v)
        rectangle(doubleArrayOf(x1, y0, z0), doubleArrayOf(x0 - x1, 0.0, 0.0), up, u, v)
        rectangle(doubleArrayOf(x0, y0, z0), doubleArrayOf(0.0, 0.0, z1 - z0), up, w, v)
    }

    /** Adds a horizontal rectangle that is seen from above. */
    fun floor(x0: Double, z0: Double, x1: Double, z1: Double, y: Double, repeats: Double = 1.0) {
        rectangle(
            doubleArrayOf(x0, y, z1),
            doubleArrayOf(x1 - x0, 0.0, 0.0),
            doubleArrayOf(0.0, 0.0, z0 - z1),
            repeats,
            repeats,
        )
    }

    fun build(material: Material): Mesh = Mesh(
        positions.copyOf(3 * vertexCount),
        triangles.copyOf(indexCount),
        material,
        normals = null,
        uvs = uvs.copyOf(2 * vertexCount),
        colors = colors.copyOf(4 * vertexCount),
    )

    private fun vertex(x: Double, y: Double, z: Double, u: Double, v: Double) {
        if (4 * vertexCount + 4 > colors.size) {
            colors = colors.copyOf(2 * colors.size)
            positions = positions.copyOf(2 * positions.size)
            uvs = uvs.copyOf(2 * uvs.size)
        }
        positions[3 * vertexCount] = x.toFloat()
        positions[3 * vertexCount + 1] = y.toFloat()
        positions[3 * vertexCount + 2] = z.toFloat()
        uvs[2 * vertexCount] = u.toFloat()
        uvs[2 * vertexCount + 1] = v.toFloat()
        colors[4 * vertexCount] = color.red
        colors[4 * vertexCount + 1] = color.green
        colors[4 * vertexCount + 2] = color.blue
        colors[4 * vertexCount + 3] = color.alpha
        vertexCount++
    }

    private fun triangle(a: Int, b: Int, c: Int) {
        if (indexCount + 3 > triangles.size) triangles = triangles.copyOf(2 * triangles.size)
        triangles[indexCount++] = a
        triangles[indexCount++] = b
        triangles[indexCount++] = c
    }

    override fun toString(): String = "MeshBuilder($vertexCount vertices)"
}
