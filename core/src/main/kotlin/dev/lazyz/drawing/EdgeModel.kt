package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.drawing.EdgeDrawing.LineKind
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Surface
import org.joml.Vector3dc

/**
 * The edges of all meshes and polygons of a scene, and the faces at each. Points are numbered by position, over all
 * surfaces together, so that a model whose parts have different materials has no seams. Faces are numbered, too: first
 * the triangles, then the polygons. Immutable and thread safe.
 *
 * Cost: linear in the number of triangles; about 80 bytes a triangle. Passes [checkpoint] for
 * each vertex, triangle and edge.
 */
internal class EdgeModel(surfaces: List<Surface>, creaseAngle: Double, checkpoint: Checkpoint) {
    private val meshes = surfaces.filterIsInstance<Mesh>()
    private val flats = surfaces.filterIsInstance<Polygon>()

    /** The origin of all positions, as that of the scene: the first that is not zero. */
    val origin: Vector3dc = meshes.firstOrNull { !Vectors.isZero(it.origin) }?.origin ?: Vectors.ZERO

    /** x, y, z for each point, relative to [origin]. */
    val points: FloatArray

    /** Three points for each triangle. */
    val corners: IntArray

    /** By face: whether it hides what is behind it, and which sides of it are drawn. */
    private val isHiding: BooleanArray
    private val isOneSided: BooleanArray

    /** The polygons: contours of point numbers. */
    val polygons: List<OutlinedFace>

    private val edges: DistinctTriples

    /** By edge: its first and its second face; [NO_FACE] or [MANY_FACES] in place of the second. */
    private var firstFace: IntArray
    private var secondFace: IntArray

    /** The faces of edges that have [MANY_FACES], without the first. */
    private val moreFaces = HashMap<Int, MutableList<Int>>()

    /** By edge: its [kind]. */
    private val kinds: ByteArray

    val triangleCount: Int get() = corners.size / 3
    val faceCount: Int get() = triangleCount + polygons.size
    val edgeCount: Int get() = edges.size
    val pointCount: Int get() = points.size / 3

    init {
        // Number the points, and collect the faces
        val distinct = DistinctTriples(meshes.sumOf { it.vertexCount })
        val faces = DistinctTriples(meshes.sumOf { it.triangleCount })
        val most = meshes.sumOf { it.triangleCount }
        val corners = IntArray(3 * most)
        val isHiding = BooleanArray(most + flats.size)
        val isOneSided = BooleanArray(most + flats.size)
        var count = 0
        for (mesh in meshes) {
            val p = mesh.relativeTo(origin).positions
            val pointOf = IntArray(mesh.vertexCount) {
                checkpoint.pass()
                add(distinct, p[3 * it], p[3 * it + 1], p[3 * it + 2])
            }
            for (i in mesh.triangles.indices step 3) {
                checkpoint.pass()
                val a = pointOf[mesh.triangles[i]]
                val b = pointOf[mesh.triangles[i + 1]]
                val c = pointOf[mesh.triangles[i + 2]]
                if (a < 0 || b < 0 || c < 0 || a == b || b == c || c == a) continue
                val least = minOf(a, b, c)
                val greatest = maxOf(a, b, c)
                val number = faces.size
                if (faces.add(least, a xor b xor c xor least xor greatest, greatest) < number) continue
                corners[3 * count] = a
                corners[3 * count + 1] = b
                corners[3 * count + 2] = c
                isHiding[count] = mesh.material.alphaMode != AlphaMode.BLEND || !mesh.material.isTranslucent
                isOneSided[count] = mesh.material.sides == Sides.FRONT
                count++
            }
        }
        this.corners = corners.copyOf(3 * count)
        this.isHiding = isHiding
        this.isOneSided = isOneSided
        polygons = ArrayList()
        for (polygon in flats) {
            val contours = polygon.contours.map { contour ->
                val numbers = contour.map {
                    add(
                        distinct,
                        (it.x - origin.x()).toFloat(),
                        (it.y - origin.y()).toFloat(),
                        (it.z - origin.z()).toFloat(),
                    )
                }
                numbers.toIntArray()
            }
            if (contours.any { -1 in it }) continue
            isHiding[count + polygons.size] = !polygon.material.isTranslucent
            isOneSided[count + polygons.size] = polygon.material.sides == Sides.FRONT
            polygons += OutlinedFace(contours, polygon.fillRule, polygon.isCap)
        }
        points = FloatArray(3 * distinct.size) { Float.fromBits(distinct.get(it / 3, it % 3)) }

        // Collect the edges of faces and polygons
        edges = DistinctTriples(3 * count / 2 + 16)
        firstFace = IntArray(3 * count / 2 + 16)
        secondFace = IntArray(3 * count / 2 + 16)
        for (face in 0 until count) {
            checkpoint.pass()
            for (k in 0 until 3) addEdge(corners[3 * face + k], corners[3 * face + (k + 1) % 3], face)
        }
        for ((i, polygon) in polygons.withIndex()) {
            for (contour in polygon.contours) {
                for (k in contour.indices) addEdge(contour[k], contour[(k + 1) % contour.size], count + i)
            }
        }
        val cosine = StrictMath.cos(creaseAngle * (StrictMath.PI / 180.0))
        kinds = ByteArray(edges.size) {
            checkpoint.pass()
            kind(it, cosine).ordinal.toByte()
        }
    }

    /** Returns the number of a point, or -1 if a coordinate is NaN or infinite. */
    private fun add(distinct: DistinctTriples, x: Float, y: Float, z: Float): Int =
        if (x.isFinite() && y.isFinite() && z.isFinite()) {
            distinct.addPoint(x, y, z)
        } else {
            -1
        }

    private fun addEdge(a: Int, b: Int, face: Int) {
        if (a == b) return
        val known = edges.size
        val edge = edges.add(minOf(a, b), maxOf(a, b), 0)
        if (edge == firstFace.size) {
            firstFace = firstFace.copyOf(edge + edge / 2)
            secondFace = secondFace.copyOf(edge + edge / 2)
        }
        if (edge == known) {
            firstFace[edge] = face
            secondFace[edge] = NO_FACE
            if (isPolygon(face)) addMore(edge)
        } else if (secondFace[edge] == NO_FACE && !isPolygon(face)) {
            secondFace[edge] = face
        } else {
            addMore(edge).add(face)
        }
    }

    /** Makes [edge] one of [MANY_FACES], and returns the list of those after the first. */
    private fun addMore(edge: Int): MutableList<Int> {
        val faces = moreFaces.getOrPut(edge) { ArrayList(2) }
        if (secondFace[edge] >= 0) faces += secondFace[edge]
        secondFace[edge] = MANY_FACES
        return faces
    }

    private fun isPolygon(face: Int) = face >= triangleCount

    /** Returns the point at one [end] of [edge], 0 or 1. */
    fun end(edge: Int, end: Int): Int = edges.get(edge, end)

    /** What [edge] is in all views: [LineKind.FACET] if it can be an outline, or nothing. */
    fun kind(edge: Int): LineKind = LineKind.entries[kinds[edge].toInt()]

    /** Whether [edge] is drawn in all views. */
    fun isFeature(edge: Int): Boolean = kinds[edge] < LineKind.OUTLINE.ordinal

    /** The first face of [edge]. */
    fun firstFace(edge: Int): Int = firstFace[edge]

    /** The second face of [edge], or [NO_FACE] or [MANY_FACES]. */
    fun secondFace(edge: Int): Int = secondFace[edge]

    /** The faces of [edge] after the first, if it has [MANY_FACES]. */
    fun moreFaces(edge: Int): List<Int> = moreFaces.getValue(edge)

    /** Whether [face] hides what is behind it, from the side that it [shows] to the camera. */
    fun isHiding(face: Int, shows: Boolean): Boolean = isHiding[face] && isDrawn(face, shows)

    /** Whether [face] is drawn; [isFront] is whether its front is toward the camera. */
    fun isDrawn(face: Int, isFront: Boolean): Boolean = isFront || !isOneSided[face]

    /** Whether both faces of [edge] go along it in the same direction: then one of them is reversed. */
    fun isTwisted(edge: Int): Boolean = goesUp(firstFace[edge], edge) == goesUp(secondFace[edge], edge)

    private fun goesUp(face: Int, edge: Int): Boolean {
        val low = edges.get(edge, 0)
        val high = edges.get(edge, 1)
        return (0 until 3).any { corners[3 * face + it] == low && corners[3 * face + (it + 1) % 3] == high }
    }

    private fun kind(edge: Int, cosine: Double): LineKind = when (secondFace[edge]) {
        NO_FACE -> LineKind.BOUNDARY
        MANY_FACES -> {
            val flats = (moreFaces(edge) + firstFace[edge]).filter(::isPolygon).map { polygons[it - triangleCount] }
            when {
                flats.any { it.isCap } -> LineKind.SECTION
                flats.isNotEmpty() -> LineKind.BOUNDARY
                else -> LineKind.CREASE
            }
        }
        else -> if (isCrease(edge, cosine)) LineKind.CREASE else LineKind.FACET
    }

    private fun isCrease(edge: Int, cosine: Double): Boolean {
        val first = DoubleArray(3)
        val second = DoubleArray(3)
        normal(firstFace[edge], first)
        normal(secondFace[edge], second)
        val square = dot(first, first) * dot(second, second)
        if (!(square > 0.0)) return false
        val product = dot(first, second)
        return (if (isTwisted(edge)) -product else product) < cosine * StrictMath.sqrt(square)
    }

    private fun dot(a: DoubleArray, b: DoubleArray) = a[0] * b[0] + a[1] * b[1] + a[2] * b[2]

    /** A point of [face]; null if it has none. */
    fun corner(face: Int): Int? =
        if (isPolygon(face)) polygons[face - triangleCount].points.firstOrNull() else corners[3 * face]

    /**
     * Writes the normal of [face] to [out]; its length is twice the area. Writes 0 if the corners of a triangle are in
     * one line, up to the rounding of positions. The normal of a polygon is the sum of those of the triangles that its
     * sides make with the first vertex of their contour.
     */
    fun normal(face: Int, out: DoubleArray) {
        if (!isPolygon(face)) return normal(corners[3 * face], corners[3 * face + 1], corners[3 * face + 2], out)
        val sum = DoubleArray(3)
        for (contour in polygons[face - triangleCount].contours) {
            for (i in 2 until contour.size) {
                normal(contour[0], contour[i - 1], contour[i], out)
                for (k in 0 until 3) sum[k] += out[k]
            }
        }
        sum.copyInto(out)
    }

    private fun normal(first: Int, second: Int, third: Int, out: DoubleArray) {
        val a = 3 * first
        val b = 3 * second
        val c = 3 * third
        val ux = points[b].toDouble() - points[a]
        val uy = points[b + 1].toDouble() - points[a + 1]
        val uz = points[b + 2].toDouble() - points[a + 2]
        val vx = points[c].toDouble() - points[a]
        val vy = points[c + 1].toDouble() - points[a + 1]
        val vz = points[c + 2].toDouble() - points[a + 2]
        out[0] = uy * vz - uz * vy
        out[1] = uz * vx - ux * vz
        out[2] = ux * vy - uy * vx
        val longest = maxOf(ux * ux + uy * uy + uz * uz, vx * vx + vy * vy + vz * vz)
        if (dot(out, out) <= FLAT * FLAT * longest * longest) out.fill(0.0)
    }

    companion object {
        const val NO_FACE = -1
        const val MANY_FACES = -2

        /** A triangle whose height is this part of its length has its corners in one line. */
        const val FLAT = 1e-6
    }
}

/**
 * A flat face with contours: a polygon of the scene. Immutable.
 *
 * @property contours point numbers of each closed contour
 * @property isCap whether a section made it
 */
internal class OutlinedFace(val contours: List<IntArray>, val fillRule: FillRule, val isCap: Boolean) {
    /** All vertices, in the order of the contours. */
    val points: Set<Int> = contours.flatMapTo(LinkedHashSet()) { it.asIterable() }

    /** Whether [point] is a vertex. */
    fun has(point: Int): Boolean = point in points
}
