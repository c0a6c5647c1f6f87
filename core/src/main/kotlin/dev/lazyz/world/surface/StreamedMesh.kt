package dev.lazyz.world.surface

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.DistinctTriples
import dev.lazyz.geometry.PointBlocks
import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import java.util.function.UnaryOperator
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A mesh that is not in memory: its triangles are read from [source] part by part, once for each rendering. A frame of
 * a scene with such a mesh is streamed, see [Frame.isStreamed].
 *
 * The picture is the one of a [Mesh] with the same triangles, material, normals, colours and texture coordinates, bit
 * for bit. Functions that look at the triangles of a [Mesh], such as sections, line drawings and shadows, ignore this
 * surface. Thread safe if the source is.
 *
 * @property source the triangles
 * @property name see [Surface.name]
 * @property material the appearance; if it is translucent, only `TiledRenderer` renders it
 */
public class StreamedMesh private constructor(
    public val source: MeshSource,
    override val material: Material,
    private val up: UpAxis,
    private val isPlain: Boolean,
    override val name: String,
) : Surface {
    /** Creates a mesh in which y points up. */
    @JvmOverloads
    public constructor(source: MeshSource, material: Material = Material(), name: String = "") :
        this(source, material, UpAxis.Y, false, name)

    /** Number of triangles. */
    public val triangleCount: Int get() = source.triangleCount

    /** The origin of all positions, world space, see [Mesh.origin]. */
    override val origin: Vector3dc = up.toWorld(source.origin)

    /** Whether vertices have colours. */
    public val hasColors: Boolean get() = source.hasColors && !isPlain

    internal val isTranslucent: Boolean get() = material.alphaMode == AlphaMode.BLEND

    /** None: parts are set up while they are drawn. */
    override val setUpBytes: Long get() = 0

    private val parts by lazy { FarthestPart(source) }

    override val bounds: Box? by lazy { toWorld(parts.bounds) }

    /** Returns the box of part [number], see [MeshSource.bounds], in world space. */
    internal fun bounds(number: Int): Box? = toWorld(source.bounds(number))

    private fun toWorld(box: Box?): Box? {
        val moved = box?.moved(source.origin) ?: return null
        val least = up.toWorld(Vector3d(moved.minX, moved.minY, moved.minZ))
        val most = up.toWorld(Vector3d(moved.maxX, moved.maxY, moved.maxZ))
        return Box(
            minOf(least.x, most.x), minOf(least.y, most.y), minOf(least.z, most.z),
            maxOf(least.x, most.x), maxOf(least.y, most.y), maxOf(least.z, most.z),
        )
    }

    /** Returns the farthest vertex, see [Surface.farthest]. Cost: it reads the parts whose boxes reach far enough. */
    override fun farthest(direction: Vector3dc): Vector3d? =
        parts.farthest(up.toModel(direction))?.let { up.toWorld(it.add(source.origin)) }

    /** Reads parts of the [source], with the material and the orientation of this mesh. */
    internal fun read(parts: IntRange): Mesh {
        val part = with(source.read(parts.first, parts.count())) {
            val colors = if (isPlain) null else colors
            Mesh(positions, triangles, this@StreamedMesh.material, normals, uvs, colors, origin, uvs2, tangents)
        }
        return if (up == UpAxis.Y) part else part.withUpAxis(up)
    }

    /**
     * Returns the numbers of parts that are read at a time, some 100,000 triangles, or fewer if they are translucent:
     * these become objects.
     */
    internal fun groups(): List<IntRange> {
        val most = if (isTranslucent) TRANSLUCENT_GROUP else GROUP
        val groups = ArrayList<IntRange>()
        var first = 0
        var size = 0L
        for (number in 0 until source.partCount) {
            val count = source.triangleCount(number)
            if (number > first && size + count > most) {
                groups += first until number
                first = number
                size = 0
            }
            size += count
        }
        if (first < source.partCount) groups += first until source.partCount
        return groups
    }

    override fun primitives(setUp: SetUp): Sequence<Primitive> =
        groups().asSequence().flatMap { setUp.mesh(read(it)) }

    override fun withMaterials(change: UnaryOperator<Material>): StreamedMesh =
        StreamedMesh(source, change.apply(material), up, isPlain, name)

    override fun withName(name: String): StreamedMesh = StreamedMesh(source, material, up, isPlain, name)

    override fun withoutColors(): StreamedMesh = StreamedMesh(source, material, up, isPlain = true, name)

    /**
     * Returns this mesh rotated so that the axis [up] becomes y.
     *
     * @throws UnsupportedOperationException if it is rotated already
     */
    override fun withUpAxis(up: UpAxis): StreamedMesh = when {
        up == UpAxis.Y -> this
        this.up == UpAxis.Y -> StreamedMesh(source, material, up, isPlain, name)
        else -> throw UnsupportedOperationException("a streamed mesh can be rotated only once")
    }

    override fun toString(): String = "StreamedMesh($triangleCount triangles, $material)"

    /**
     * Triangles that are read part by part each time they are needed, for models that are larger than memory. Shown by
     * a [StreamedMesh].
     *
     * A part should have some 1,000 triangles that are close to each other. For a fitted camera, single parts are read;
     * for a rendering, as many at a time as have some 100,000 triangles. Implementations must return the same triangles
     * each time, and be thread safe. An exception ends the rendering and is rethrown unchanged.
     */
    public interface MeshSource {
        /** Number of triangles of all parts. */
        public val triangleCount: Int

        /** Whether parts have colours of vertices. */
        public val hasColors: Boolean

        /** Number of parts. */
        public val partCount: Int

        /** The origin of the positions of all parts, see [Mesh.origin]. */
        public val origin: Vector3dc

        /** Returns the number of triangles of part [number], without reading it. */
        public fun triangleCount(number: Int): Int

        /**
         * Returns the smallest box around the vertices that the triangles of part [number] use, relative to [origin],
         * or null if there are none. A fitted camera and each rendering call it for all parts, so it should not read
         * the part.
         */
        public fun bounds(number: Int): Box?

        /**
         * Reads [count] parts from number [first] on, and returns their triangles in order as one mesh. The triangles
         * of all parts are those of the whole mesh. The material of the result is not used, and its origin must be
         * [origin].
         */
        public fun read(first: Int, count: Int): Mesh
    }

    private companion object {
        /** Most triangles that are read at a time, unless one part has more. */
        const val GROUP = 1 shl 17
        const val TRANSLUCENT_GROUP = 1 shl 13
    }
}

/**
 * Finds points of [source] by reading only those parts whose boxes extend far enough. The points of the parts that were
 * used last stay in memory, up to an eighth of the heap: directions that follow each other lead to the same parts.
 * Thread safe.
 */
internal class FarthestPart(private val source: MeshSource) {
    private val boxes: List<Box?> = List(source.partCount) { source.bounds(it) }

    /** The smallest box around all parts, relative to the origin of the source, or null if there are no vertices. */
    val bounds: Box? = boxes.filterNotNull().reduceOrNull(Box::union)

    private val recent = RecentPoints()

    /**
     * Returns the vertex that is farthest along [direction], relative to the origin of the source; of several the one
     * that [PointBlocks] defines. Null if there are no vertices.
     */
    fun farthest(direction: Vector3dc): Vector3d? {
        val x = direction.x()
        val y = direction.y()
        val z = direction.z()

        // Rounding keeps order, so no point of a part has a greater product than the farthest corner of its box
        val reaches = DoubleArray(boxes.size) { number ->
            val corner = boxes[number]?.farthest(direction)
            if (corner == null) Double.NEGATIVE_INFINITY else x * corner.x + y * corner.y + z * corner.z
        }
        val first = reaches.indices.maxByOrNull { reaches[it] } ?: return null
        if (boxes[first] == null) return null
        var best: Vector3d? = null
        var most = Double.NEGATIVE_INFINITY
        fun look(number: Int) {
            val points = points(number)
            for (at in points.indices step 3) {
                val product = x * points[at] + y * points[at + 1] + z * points[at + 2]
                if (product < most) continue
                val point = Vector3d(points[at].toDouble(), points[at + 1].toDouble(), points[at + 2].toDouble())
                if (product > most || PointBlocks.isBefore(point, checkNotNull(best))) best = point
                most = product
            }
        }

        // Begin with the most promising part, so that few others remain
        look(first)
        val others = reaches.indices.filter { it != first && boxes[it] != null && reaches[it] >= most }
        for (number in others.sortedByDescending { reaches[it] }) if (reaches[number] >= most) look(number)
        return best
    }

    /** Returns x, y, z of the different vertices of part [number] that its triangles use and that are finite. */
    private fun points(number: Int): FloatArray {
        synchronized(recent) { recent[number] }?.let { return it }
        val part = source.read(number, 1)
        val distinct = DistinctTriples(part.triangleCount)
        for (vertex in part.triangles) {
            val x = part.positions[3 * vertex]
            val y = part.positions[3 * vertex + 1]
            val z = part.positions[3 * vertex + 2]
            if (x.isFinite() && y.isFinite() && z.isFinite()) distinct.addPoint(x, y, z)
        }
        val points = FloatArray(3 * distinct.size) { Float.fromBits(distinct.get(it / 3, it % 3)) }
        synchronized(recent) { recent.add(number, points) }
        return points
    }

    /** The points of parts, by the number of the part; those that were not used for the longest time are dropped. */
    private class RecentPoints : LinkedHashMap<Int, FloatArray>(16, 0.75f, true) {
        private val most = Runtime.getRuntime().maxMemory() / 8
        private var bytes = 0L

        fun add(number: Int, points: FloatArray) {
            put(number, points)
            bytes += Float.SIZE_BYTES * points.size
        }

        override fun removeEldestEntry(eldest: Map.Entry<Int, FloatArray>): Boolean {
            val isFull = bytes > most
            if (isFull) bytes -= Float.SIZE_BYTES * eldest.value.size
            return isFull
        }
    }
}
