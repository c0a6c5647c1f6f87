package dev.lazyz.scenes.meshes

import dev.lazyz.Rgba
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
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

/**
 * Triangles whose corners can have their own colour and texture coordinates instead of those of their vertex. Corners
 * of one vertex that have the same colour and coordinates become one vertex of the mesh. Not thread safe.
 *
 * @param vertices the vertices that corners refer to
 * @param colors the colours of corners
 * @param places the texture coordinates of corners
 */
internal class CornerMesh(
    private val vertices: VertexArrays,
    private val colors: ColorNumbers = ColorNumbers(),
    private val places: TexturePlaces = TexturePlaces(),
) {
    private val corners = DistinctTriples(vertices.count)
    private val triangles = Ints()
    private var hasColors = vertices.colors != null
    private var hasPlaces = vertices.uvs != null

    /** Number of triangles. */
    val triangleCount: Int get() = triangles.size / 3

    /**
     * Adds a corner of [vertex]; three corners make a triangle. [color] and [place] are numbers in the palette and in
     * the texture coordinates, or -1 to use those of the vertex.
     */
    fun add(vertex: Int, color: Int = -1, place: Int = -1) {
        if (color >= 0) hasColors = true
        if (place >= 0) hasPlaces = true
        triangles.add(corners.add(vertex, color, place))
    }

    /** Returns the mesh; fails if it exceeds a limit of [source]. Do not add corners afterwards. */
    fun mesh(source: Source, material: Material = Material()): Mesh {
        source.loading.decode(source, corners.size * CORNER_BYTES)
        return Mesh(
            gathered(vertices.positions, 3, 0f),
            triangles.toArray(),
            material,
            vertices.normals?.let { gathered(it, 3, 0f) },
            if (hasPlaces) places() else null,
            if (hasColors) colors() else null,
            vertices.origin,
        )
    }

    private fun places(): FloatArray = gathered(vertices.uvs, 2, 0f).also { uvs ->
        for (corner in 0 until corners.size) {
            val place = corners.get(corner, 2)
            if (place >= 0) places.copy(place, uvs, 2 * corner)
        }
    }

    private fun colors(): FloatArray = gathered(vertices.colors, 4, 1f).also { all ->
        for (corner in 0 until corners.size) {
            val color = corners.get(corner, 1)
            if (color >= 0) colors.copy(color, all, 4 * corner)
        }
    }

    /**
     * Returns the [width] numbers of each corner's vertex, or [missing] for all if the vertices have no such numbers.
     */
    private fun gathered(from: FloatArray?, width: Int, missing: Float): FloatArray {
        val result = FloatArray(width * corners.size)
        if (from == null) {
            result.fill(missing)
        } else {
            for (corner in 0 until corners.size) {
                val start = width * corners.get(corner, 0)
                from.copyInto(result, width * corner, start, start + width)
            }
        }
        return result
    }

    private companion object {
        /** Bytes of a vertex and of its entry in the hash table. */
        const val CORNER_BYTES = 80L
    }
}

/** Numbers the distinct colours of a file from 0: red, green, blue in linear light, and alpha. Not thread safe. */
internal class ColorNumbers {
    /** Bits of red, green and blue. */
    private val opaque = DistinctTriples()

    /** For each colour: number in [opaque], and bits of alpha. */
    private val colors = DistinctTriples()

    /** Whether a colour is translucent. */
    var isTranslucent = false
        private set

    /** Returns the number of this colour, a new number if the colour is new. */
    fun add(red: Float, green: Float, blue: Float, alpha: Float): Int {
        if (alpha < 1f) isTranslucent = true
        return colors.add(opaque.add(red.toBits(), green.toBits(), blue.toBits()), alpha.toBits(), 0)
    }

    /** Writes the four components of colour [number] to [to], starting at index [at]. */
    fun copy(number: Int, to: FloatArray, at: Int) {
        val color = colors.get(number, 0)
        for (channel in 0 until 3) to[at + channel] = Float.fromBits(opaque.get(color, channel))
        to[at + 3] = Float.fromBits(colors.get(number, 1))
    }
}
