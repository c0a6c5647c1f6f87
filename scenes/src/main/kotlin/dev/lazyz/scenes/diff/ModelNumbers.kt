package dev.lazyz.scenes.diff

import dev.lazyz.geometry.Box
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.scenes.pictures.refuse
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Surface
import kotlin.math.sqrt
import org.joml.Vector3d

/**
 * A number of a model, in its own unit and axes.
 *
 * @property id its name in data
 */
public enum class Measure(public val id: String) {
    /** What meshes enclose, by Gauss's theorem. There is none unless each edge of a triangle has its counterpart. */
    VOLUME("volume"),

    /** The area of the triangles of all meshes. */
    AREA("area"),

    MIN_X("minX"),
    MIN_Y("minY"),
    MIN_Z("minZ"),
    MAX_X("maxX"),
    MAX_Y("maxY"),
    MAX_Z("maxZ"),

    /** Vertices of meshes, lines and polygons, and points, as the loader has made them: edges split vertices. */
    VERTICES("vertices"),

    /** Triangles of all meshes. */
    TRIANGLES("triangles"),

    /** Surfaces. */
    PARTS("parts"),

    /** Edges of triangles that have no counterpart. There are none in closed meshes. */
    OPEN_EDGES("openEdges"),

    /** What is connected by edges of triangles: bodies, and cavities in them. */
    SHELLS("shells"),

    /** Ways through closed meshes, such as drilled holes, by Euler's formula. Where shells touch, there can be none. */
    HOLES("holes"),
    ;

    /** Whether it is a whole number. */
    public val isCount: Boolean get() = this >= VERTICES

    /** Returns [value] as data. */
    internal fun data(value: Double?): Number? = if (isCount) value?.toLong() else value
}

/**
 * The numbers of some surfaces. They do not depend on the order of triangles. Immutable.
 *
 * Cost: one pass over all triangles, and sorting their edges. Memory, until it is created: 40 bytes for each triangle,
 * and a table of points.
 *
 * @throws dev.lazyz.scenes.pictures.NoPictureException if there are more than 715 million triangles
 * @throws InterruptedException if the thread is interrupted
 */
public class ModelNumbers
@Throws(InterruptedException::class)
constructor(surfaces: List<Surface>) {
    private val values: Map<Measure, Double>

    init {
        val meshes = surfaces.filterIsInstance<Mesh>()
        val bounds = surfaces.mapNotNull { it.bounds }.reduceOrNull(Box::union)
        val triangles = Triangles(meshes, bounds?.center ?: Vector3d())
        values = listOf(
            Measure.VOLUME to triangles.volume,
            Measure.AREA to triangles.area,
            Measure.MIN_X to bounds?.minX,
            Measure.MIN_Y to bounds?.minY,
            Measure.MIN_Z to bounds?.minZ,
            Measure.MAX_X to bounds?.maxX,
            Measure.MAX_Y to bounds?.maxY,
            Measure.MAX_Z to bounds?.maxZ,
            Measure.VERTICES to surfaces.sumOf(::vertices).toDouble(),
            Measure.TRIANGLES to meshes.sumOf { it.triangleCount.toLong() }.toDouble(),
            Measure.PARTS to surfaces.size.toDouble(),
            Measure.OPEN_EDGES to triangles.openEdges.toDouble(),
            Measure.SHELLS to triangles.shells.toDouble(),
            Measure.HOLES to triangles.holes?.toDouble(),
        ).mapNotNull { (measure, value) -> value?.let { measure to it + 0.0 } }.toMap()
    }

    /** Returns the number, or null if there is none: the volume of open meshes, or the bounds of nothing. */
    public operator fun get(measure: Measure): Double? = values[measure]

    /** Returns all numbers by [Measure.id]; null where there is none. */
    public fun toData(): Map<String, Number?> = Measure.entries.associate { it.id to it.data(this[it]) }

    private fun vertices(surface: Surface): Long = when (surface) {
        is Mesh -> surface.vertexCount.toLong()
        is Points -> surface.pointCount.toLong()
        is Lines -> surface.vertexCount.toLong()
        is Polygon -> surface.contours.sumOf { it.size.toLong() }
        else -> 0L
    }

    override fun equals(other: Any?): Boolean = other is ModelNumbers && values == other.values

    override fun hashCode(): Int = values.hashCode()

    override fun toString(): String = values.toString()
}

/** Adds up the triangles of [meshes]; those that are not finite are left out. Memory: 40 bytes a triangle. */
private class Triangles(private val meshes: List<Mesh>, private val center: Vector3d) {
    private val areas = DoubleArray(size(meshes.sumOf { it.triangleCount.toLong() }))
    private val volumes = DoubleArray(areas.size)
    private val points = DistinctTriples()

    /** From the front: edges from smaller to greater numbers of points; from the back: the others, reversed. */
    private val edges = LongArray(3 * areas.size)
    private var forward = 0
    private var backward = edges.size
    private var count = 0

    /** Triangles that are not at one point. */
    private var faces = 0

    init {
        for (mesh in meshes) add(mesh)
        for (all in listOf(areas, volumes)) all.sort()
        edges.sort(0, forward)
        edges.sort(backward, edges.size)
    }

    // From the smallest to the largest, so that the order of triangles does not matter
    val area: Double get() = areas.sum()

    val volume: Double? get() = if (count > 0 && openEdges == 0) volumes.sum() else null

    /** Directed edges less those that have a counterpart. */
    val openEdges: Int by lazy {
        var back = backward
        var pairs = 0
        for (edge in 0 until forward) {
            while (back < edges.size && edges[back] < edges[edge]) back++
            if (back == edges.size || edges[back] != edges[edge]) continue
            back++
            pairs++
        }
        forward + (edges.size - backward) - 2 * pairs
    }

    /** The roots of points: those of a shell have the same. -1 for a point that no edge has. */
    private val roots: IntArray by lazy {
        val roots = IntArray(points.size) { -1 }
        for (place in edges.indices) {
            if (place in forward until backward) continue
            val from = root((edges[place] ushr 32).toInt(), roots)
            val to = root(edges[place].toInt(), roots)
            roots[maxOf(from, to)] = minOf(from, to)
        }
        roots
    }

    private fun root(point: Int, roots: IntArray): Int {
        if (roots[point] < 0) roots[point] = point
        var at = point
        while (roots[at] != at) {
            roots[at] = roots[roots[at]]
            at = roots[at]
        }
        return at
    }

    val shells: Int get() = roots.indices.count { roots[it] == it }

    val holes: Int?
        get() {
            if (faces == 0 || openEdges > 0) return null
            val euler = roots.count { it >= 0 } - forward + faces
            return (shells - euler / 2).takeIf { euler % 2 == 0 && it >= 0 }
        }

    private fun add(mesh: Mesh) {
        val xyz = mesh.positions
        val numbers = numbers(mesh)
        val place = Vector3d(mesh.origin).sub(center)
        val (a, b, c) = List(3) { Vector3d() }
        val corners = IntArray(3)
        for (at in mesh.triangles.indices step 3) {
            if (at and LOOK == 0 && Thread.interrupted()) throw InterruptedException("interrupted while measuring")
            mesh.triangles.copyInto(corners, 0, at, at + 3)
            if (corners.any { numbers[it] < 0 }) continue
            val sides = forward - backward
            for (k in 0 until 3) edge(numbers[corners[k]], numbers[corners[(k + 1) % 3]])
            if (forward - backward > sides) faces++

            // From the position that comes first, so that it does not matter with which a file begins
            val first = (1 until 3).fold(0) { least, k -> if (isBefore(xyz, corners[k], corners[least])) k else least }
            for ((k, to) in listOf(a, b, c).withIndex()) {
                val i = 3 * corners[(first + k) % 3]
                to.set(xyz[i].toDouble(), xyz[i + 1].toDouble(), xyz[i + 2].toDouble()).add(place)
            }
            b.sub(a).cross(c.sub(a))
            areas[count] = sqrt(b.x * b.x + b.y * b.y + b.z * b.z) / 2
            volumes[count++] = (a.x * b.x + a.y * b.y + a.z * b.z) / 6
        }
    }

    /** Returns the numbers of the points at the vertices of [mesh], -1 where one is not finite. */
    private fun numbers(mesh: Mesh): IntArray {
        val xyz = mesh.positions
        val way = Vector3d(mesh.origin).sub(meshes[0].origin)

        fun near(place: Int, axis: Int) =
            if (way[axis] == 0.0) xyz[place + axis] else (xyz[place + axis] + way[axis]).toFloat()
        return IntArray(mesh.vertexCount) { vertex ->
            val i = 3 * vertex
            val isFinite = xyz[i].isFinite() && xyz[i + 1].isFinite() && xyz[i + 2].isFinite()
            if (isFinite) points.addPoint(near(i, 0), near(i, 1), near(i, 2)) else -1
        }
    }

    private fun isBefore(xyz: FloatArray, vertex: Int, other: Int): Boolean {
        val axis = (0 until 3).firstOrNull { xyz[3 * vertex + it] != xyz[3 * other + it] } ?: return false
        return xyz[3 * vertex + axis] < xyz[3 * other + axis]
    }

    private fun edge(from: Int, to: Int) {
        if (from < to) {
            edges[forward++] = from.toLong() shl 32 or to.toLong()
        } else if (from > to) {
            edges[--backward] = to.toLong() shl 32 or from.toLong()
        }
    }

    private companion object {
        /** Triangles whose edges an array can have. */
        const val MOST = (Int.MAX_VALUE - 8) / 3

        fun size(triangles: Long): Int {
            if (triangles > MOST) refuse("models are compared up to $MOST triangles, and one has $triangles")
            return triangles.toInt()
        }

        /** Triangles between two looks at the interrupt, as a mask of places. */
        const val LOOK = (1 shl 16) - 1
    }
}

/**
 * The numbers of a part of a model, or of all of it, before and after. Immutable.
 *
 * @property name its name, with a number if others have it, too; empty for all
 * @property before its numbers in the old model, or null if it was not there
 * @property after its numbers in the new model, or null if it is not there
 */
public class PartDifference private constructor(
    public val name: String,
    public val before: ModelNumbers?,
    public val after: ModelNumbers?,
) {
    internal constructor(name: String, before: List<Surface>, after: List<Surface>) :
        this(name, ModelNumbers(before), ModelNumbers(after))

    /** Whether all numbers are the same. */
    public val isEqual: Boolean get() = before == after

    /** What happened to the part, in one word: added, removed, same or changed. */
    public val change: String
        get() = when {
            before == null -> "added"
            after == null -> "removed"
            else -> if (isEqual) "same" else "changed"
        }

    /** Returns by how much a number is greater than before, or null if it is missing on one side. */
    public fun difference(measure: Measure): Double? {
        val was = before?.get(measure) ?: return null
        return after?.get(measure)?.let { it - was }
    }

    internal fun toData(): Map<String, List<Number?>> = Measure.entries.associate { measure ->
        measure.id to listOf(before?.get(measure), after?.get(measure), difference(measure)).map(measure::data)
    }

    override fun toString(): String = "PartDifference($name: $before, $after)"

    public companion object {
        /**
         * Returns the parts of a model that has no other version: there is no [before]. Throws like [ModelNumbers].
         *
         * @param all the numbers of all [surfaces] together
         */
        @JvmStatic
        @Throws(InterruptedException::class)
        public fun of(surfaces: List<Surface>, all: ModelNumbers): List<PartDifference> =
            pairs(emptyList(), surfaces, PartDifference("", null, all))

        /** Returns the parts of two models, of which [whole] has all numbers. */
        internal fun pairs(before: List<Surface>, after: List<Surface>, whole: PartDifference): List<PartDifference> {
            val was = numbered(before)
            val now = numbered(after)

            // One part is all
            fun numbers(part: Surface?, all: List<Surface>, sum: ModelNumbers?) =
                part?.let { if (all.size == 1) sum else ModelNumbers(listOf(it)) }
            return (was.keys + now.keys).map { (name, number) ->
                val shown = name.ifEmpty { "unnamed" } + if (number == 0) "" else " (${number + 1})"
                val key = name to number
                PartDifference(
                    shown, numbers(was[key], before, whole.before), numbers(now[key], after, whole.after),
                )
            }
        }

        /** Returns [surfaces] by name and number among those of the name. */
        private fun numbered(surfaces: List<Surface>): Map<Pair<String, Int>, Surface> {
            val seen = HashMap<String, Int>()
            return surfaces.associateBy { it.name to seen.merge(it.name, 1, Int::plus)!! - 1 }
        }
    }
}
