package dev.lazyz.scenes.meshes

import dev.lazyz.Rgba
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Points
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * The vertices of a file, as arrays for [dev.lazyz.world.surface.Mesh]; null for attributes that the file does not
 * have.
 *
 * @property positions x, y, z of each vertex
 * @property normals x, y, z of each vertex
 * @property uvs u, v of each vertex, v downward
 * @property colors red, green, blue, alpha of each vertex, in linear light
 * @property origin what positions are relative to
 */
internal class VertexArrays(
    val positions: FloatArray,
    val normals: FloatArray? = null,
    val uvs: FloatArray? = null,
    val colors: FloatArray? = null,
    val origin: Vector3dc = Vector3d(),
) {
    /** Number of vertices. */
    val count: Int get() = positions.size / 3

    /** Returns the vertices as points; nothing if there are none. */
    fun points(): List<Points> {
        if (count == 0) return emptyList()
        val normals = MissingNormals.ofPoints(normals)
        val material = PixelDefaults.material(normals != null, colors != null)
        return listOf(Points(positions, PixelDefaults.POINT_SIZE, material, normals, colors, origin))
    }

    /** Returns the first [count] vertices. */
    fun first(count: Int): VertexArrays {
        if (count == this.count) return this
        return VertexArrays(
            positions.copyOf(3 * count),
            normals?.copyOf(3 * count),
            uvs?.copyOf(2 * count),
            colors?.copyOf(4 * count),
            origin,
        )
    }
}

/** Appearance of points and lines of model files, which state neither their size nor, in most cases, their colour. */
internal object PixelDefaults {
    /** Size of points in pixels. Chosen by viewing clouds of 4 to 70,000 points at 512 x 512. */
    const val POINT_SIZE = 2.0

    /** Width of lines in pixels. */
    const val LINE_WIDTH = 1.0

    private val dark = Rgba.ofArgb(0xFF303840.toInt())

    /**
     * Returns the material for points or lines. Without light and without colours it is dark, because white would be
     * invisible on a white background; otherwise it is white, as for meshes.
     */
    fun material(isLit: Boolean, hasColors: Boolean, name: String = ""): Material =
        Material(if (isLit || hasColors) Rgba.WHITE else dark, name = name)
}
