package dev.lazyz.scenes.meshes

import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh

/** The polygons of a file, in order, with their colours and textures. Not thread safe. */
internal class Polygons {
    /** The vertex numbers of all corners. */
    private val corners = Ints()

    /** By polygon: number of its first corner; null while all polygons are triangles. */
    private var starts: Ints? = null

    /** By corner: number of its texture coordinates, or -1. */
    private val placeNumbers = Ints()

    /** By polygon: number of its texture, or -1. */
    private val textureNumbers = Ints()

    /** By polygon: number of its colour, or -1. */
    private val colorNumbers = Ints()

    /** The colours and texture coordinates that the polygons refer to. */
    val colors = ColorNumbers()
    val places = TexturePlaces()

    /** Number of polygons. */
    var count = 0
        private set

    /** Whether a polygon has a colour, or corners have texture coordinates. */
    val haveAttributes: Boolean get() = colorNumbers.size > 0 || placeNumbers.size > 0

    /** Whether corners have texture coordinates. */
    val havePlaces: Boolean get() = placeNumbers.size > 0

    /** Whether all polygons are triangles. */
    val areTriangles: Boolean get() = starts == null

    /** Number of corners. */
    val cornerCount: Int get() = corners.size

    /** Reserves space for [cornerCount] more corners. */
    fun expect(cornerCount: Int) = corners.ensure(corners.size + cornerCount)

    /** Begins a polygon of [cornerCount] corners. The caller must add the corners next. */
    fun begin(cornerCount: Int) {
        if (cornerCount != 3 && starts == null) {
            starts = Ints().also { for (triangle in 0 until count) it.add(3 * triangle) }
        }
        starts?.add(corners.size)
        count++
    }

    fun add(vertex: Int) {
        corners.add(vertex)
    }

    /** Adds a triangle of three vertices. */
    fun addTriangle(a: Int, b: Int, c: Int) {
        begin(3)
        corners.add(a, b, c)
    }

    /** Sets the colour of [polygon]. Call it in the order of the polygons. */
    fun color(polygon: Int, number: Int) {
        while (colorNumbers.size < polygon) colorNumbers.add(-1)
        colorNumbers.add(number)
    }

    /**
     * Sets the texture of the polygon that was added last. The caller must add the texture coordinates of its corners
     * next.
     */
    fun texture(number: Int) {
        while (textureNumbers.size < count - 1) textureNumbers.add(-1)
        textureNumbers.add(number)
        while (placeNumbers.size < start(count - 1)) placeNumbers.add(-1)
    }

    fun addPlace(number: Int) {
        placeNumbers.add(number)
    }

    /** Returns the number of a polygon's first corner. Its other corners follow. */
    fun start(polygon: Int): Int {
        val places = starts
        return if (places == null) 3 * polygon else places[polygon]
    }

    /** Returns the number of a polygon's last corner plus 1. */
    fun end(polygon: Int): Int = if (polygon + 1 < count) start(polygon + 1) else corners.size

    /** Returns the vertex number of a corner. */
    fun vertex(corner: Int): Int = corners[corner]

    /** Whether the vertex numbers of all corners are below [limit]. */
    fun areBelow(limit: Int): Boolean = corners.areBelow(limit)

    /** Returns the vertex numbers of all corners. Do not add corners afterwards. */
    fun vertices(): IntArray = corners.toArray()

    /** Returns the number of a corner's texture coordinates, or -1. */
    fun place(corner: Int): Int = if (corner < placeNumbers.size) placeNumbers[corner] else -1

    /** Returns the number of a polygon's texture, or -1. */
    fun textureOf(polygon: Int): Int = if (polygon < textureNumbers.size) textureNumbers[polygon] else -1

    /** Returns the number of a polygon's colour, or -1. */
    fun colorOf(polygon: Int): Int = if (polygon < colorNumbers.size) colorNumbers[polygon] else -1
}

/** Numbers the distinct texture coordinates of a file from 0. Not thread safe. */
internal class TexturePlaces {
    private val places = DistinctTriples()

    /** Returns the number of these coordinates, a new number if the coordinates are new. */
    fun add(u: Float, v: Float): Int = places.add(u.toBits(), v.toBits(), 0)

    /** Writes the two components of coordinates [number] to [to], starting at index [at]. */
    fun copy(number: Int, to: FloatArray, at: Int) {
        for (axis in 0 until 2) to[at + axis] = Float.fromBits(places.get(number, axis))
    }
}

/** Triangulates [polygons] and builds a mesh from the triangles. Not thread safe. */
internal class PolygonMesh(
    private val source: Source,
    private val vertices: VertexArrays,
    private val polygons: Polygons,
) {
    /** Whether all polygons are triangles with valid vertices, so that none is triangulated or skipped. */
    private val areTriangles = polygons.areTriangles && polygons.areBelow(vertices.count)

    /** By triangle and corner: the corner's number among the corners of all polygons; empty if [areTriangles]. */
    private val corners = Ints(if (areTriangles) 0 else polygons.cornerCount)

    /** By triangle: number of its polygon; empty if [areTriangles]. */
    private val polygonOf = Ints()

    init {
        if (!areTriangles) cut()
        source.loading.triangles(source, triangleCount.toLong())
    }

    /** Number of triangles. */
    val triangleCount: Int get() = if (areTriangles) polygons.count else corners.size / 3

    /** Returns the number of a triangle's texture, or -1. */
    fun textureOf(triangle: Int): Int = polygons.textureOf(polygon(triangle))

    /**
     * Returns all triangles in the order of their polygons. Vertex colours take precedence over polygon colours, as
     * in MeshLab.
     */
    fun mesh(material: Material): Mesh {
        if (!polygons.haveAttributes) {
            val triangles =
                if (areTriangles) polygons.vertices() else IntArray(corners.size) { polygons.vertex(corners[it]) }
            return Mesh(
                vertices.positions, triangles, material, vertices.normals, vertices.uvs, vertices.colors,
                vertices.origin,
            )
        }
        val mesh = CornerMesh(vertices, polygons.colors, polygons.places)
        for (i in 0 until 3 * triangleCount) {
            source.step()
            val corner = if (areTriangles) i else corners[i]
            val color = if (vertices.colors == null) polygons.colorOf(polygon(i / 3)) else -1
            mesh.add(polygons.vertex(corner), color, polygons.place(corner))
        }
        return mesh.mesh(source, material)
    }

    private fun polygon(triangle: Int): Int = if (areTriangles) triangle else polygonOf[triangle]

    private fun cut() {
        val cutting = PolygonCutting(source, vertices.count) { vertex, axis -> vertices.positions[3 * vertex + axis] }
        for (polygon in 0 until polygons.count) {
            cutting.cut(polygons, polygon, corners)
            while (3 * polygonOf.size < corners.size) polygonOf.add(polygon)
        }
        cutting.warn()
    }
}
