package dev.lazyz.world.surface

import dev.lazyz.Checkpoint
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Workers
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.CornerNormals
import dev.lazyz.geometry.CornersByPosition
import dev.lazyz.geometry.PointBlocks
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.geometry.VertexTransforms
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.NormalMap
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureMap.UvTransform
import java.util.function.UnaryOperator
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Triangles that share vertices and have one material.
 *
 * [positions], [normals], [uvs], [colors], [uvs2] and [tangents] are indexed by vertex. [triangles] has three vertex
 * numbers for each triangle, counter-clockwise seen from outside. Positions can be NaN or infinite: a triangle with
 * such a vertex covers nothing. The arrays are not copied; do not change them. Thread safe.
 *
 * @property positions x, y, z for each vertex, world space, relative to [origin]
 * @property triangles three vertex numbers for each triangle; the order of triangles is the submission order
 * @property material the appearance
 * @property normals x, y, z for each vertex, pointing outward, of any length; between the vertices of a triangle,
 *   longer ones have more weight. Null means the normal of each triangle
 * @property uvs u, v for each vertex, see [Texture]; null means none
 * @property colors red, green, blue, alpha for each vertex, linear light; null means white
 * @param origin added to all positions; must be finite. It keeps the details of a mesh that is far from the world's
 *   origin, for example in map coordinates, where 32-bit positions are too coarse
 * @property uvs2 a second set of [uvs], for shaders that read textures with different coordinates; null means none
 * @property tangents x, y, z, w for each vertex, as in glTF: the direction in which u increases, of any length, and the
 *   sign, 1 or -1, of the bitangent, cross(normal, tangent) times w. Null means none
 * @property name see [Surface.name]
 * @throws IllegalArgumentException if an array has the wrong length, a vertex number is out of range, or [origin] is
 *   not finite
 */
public class Mesh @JvmOverloads constructor(
    public val positions: FloatArray,
    public val triangles: IntArray,
    override val material: Material = Material(),
    public val normals: FloatArray? = null,
    public val uvs: FloatArray? = null,
    public val colors: FloatArray? = null,
    origin: Vector3dc = Vectors.ZERO,
    public val uvs2: FloatArray? = null,
    public val tangents: FloatArray? = null,
    override val name: String = "",
) : Surface {
    /** The origin of [positions], world space: it is added to each of them. */
    override val origin: Vector3dc = if (origin === Vectors.ZERO) origin else Vector3d(origin)

    /** Number of vertices. */
    public val vertexCount: Int = positions.size / 3

    /** Number of triangles. */
    public val triangleCount: Int = triangles.size / 3

    init {
        require(Vectors.isFinite(origin)) { "origin must be finite: $origin" }
        require(positions.size % 3 == 0) { "positions must be triples: ${positions.size} numbers" }
        require(triangles.size % 3 == 0) { "triangles must be triples: ${triangles.size} vertex numbers" }
        require(normals == null || normals.size == 3 * vertexCount) {
            "normals must be one triple a vertex: ${normals?.size} numbers for $vertexCount vertices"
        }
        require(uvs == null || uvs.size == 2 * vertexCount) {
            "uvs must be one pair a vertex: ${uvs?.size} numbers for $vertexCount vertices"
        }
        require(colors == null || colors.size == 4 * vertexCount) {
            "colors must be four numbers a vertex: ${colors?.size} numbers for $vertexCount vertices"
        }
        require(uvs2 == null || uvs2.size == 2 * vertexCount) {
            "uvs2 must be one pair a vertex: ${uvs2?.size} numbers for $vertexCount vertices"
        }
        require(tangents == null || tangents.size == 4 * vertexCount) {
            "tangents must be four numbers a vertex: ${tangents?.size} numbers for $vertexCount vertices"
        }
        for (vertex in triangles) {
            require(vertex in 0 until vertexCount) { "vertex number must be in 0..${vertexCount - 1}: $vertex" }
        }
    }

    override val setUpBytes: Long
        get() = HeapLayout.VERTEX * vertexCount +
            if (material.alphaMode == AlphaMode.OPAQUE) 0 else HeapLayout.TRIANGLE * triangleCount

    private val blocks by lazy { PointBlocks(positions, triangles) }

    /** A box around the vertices that triangles use, or null if there is none. */
    override val bounds: Box? by lazy { blocks.bounds?.moved(this.origin) }

    override fun farthest(direction: Vector3dc): Vector3d? = blocks.farthest(direction)?.add(origin)

    override fun primitives(setUp: SetUp): Sequence<Primitive> = setUp.mesh(this)

    override fun withMaterials(change: UnaryOperator<Material>): Mesh =
        Mesh(positions, triangles, change.apply(material), normals, uvs, colors, origin, uvs2, tangents, name)

    override fun withUpAxis(up: UpAxis): Mesh = Mesh(
        up.toWorld(positions), triangles, material, normals?.let { up.toWorld(it) }, uvs, colors, up.toWorld(origin),
        uvs2, tangents?.let { up.toWorld(it, 4) }, name,
    )

    override fun hasUvs(set: Int): Boolean = (if (set == 0) uvs else uvs2) != null

    override fun withoutColors(): Mesh = if (colors == null) {
        this
    } else {
        Mesh(positions, triangles, material, normals, uvs, null, origin, uvs2, tangents, name)
    }

    override fun withName(name: String): Mesh =
        Mesh(positions, triangles, material, normals, uvs, colors, origin, uvs2, tangents, name)

    /** Returns the same mesh with positions relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Mesh = if (origin == this.origin) {
        this
    } else {
        val moved = VertexTransforms.relativeTo(origin, positions, this.origin)
        Mesh(moved, triangles, material, normals, uvs, colors, origin, uvs2, tangents, name)
    }

    /**
     * Returns this mesh transformed by an affine [transform]. Normals are transformed by the inverse transpose,
     * tangents like directions, and both get unit length; a translation, the identity among them, leaves them as they
     * are. A reflection also reverses the vertex order of every triangle, so that outside stays outside, and the
     * handedness of tangents. If the result is far from the world's origin compared with its size, it gets an [origin]
     * at its centre, otherwise its origin is zero. Unless the origin changes, the identity gives the same picture, bit
     * for bit. Cost: linear in the size of the mesh.
     */
    public fun transformed(transform: Matrix4dc): Mesh {
        val corners = triangles.copyOf()
        if (VertexTransforms.isMirror(transform)) {
            for (i in corners.indices step 3) {
                corners[i + 1] = triangles[i + 2]
                corners[i + 2] = triangles[i + 1]
            }
        }
        val moved = VertexTransforms.origin(bounds, transform)
        val positions = VertexTransforms.positions(positions, origin, transform, moved)
        val normals = normals?.let { VertexTransforms.normals(it, transform) }
        val tangents = tangents?.let { VertexTransforms.tangents(it, transform) }
        return Mesh(positions, corners, material, normals, uvs, colors, moved, uvs2, tangents, name)
    }

    /**
     * Returns this mesh with other vertices and triangles: vertex i has all that vertex number `vertices[i]` of this
     * mesh has. Cost: linear in the size of the result.
     *
     * @param normals the normals of the new vertices; by default those of this mesh
     * @throws IllegalArgumentException if an array has the wrong length, or a vertex number of a triangle is out of
     *   range
     * @throws IndexOutOfBoundsException if this mesh has no vertex of one of these numbers
     */
    @JvmOverloads
    public fun withVertices(vertices: IntArray, triangles: IntArray, normals: FloatArray? = null): Mesh =
        mapped(triangles, normals) { numbers, width -> VertexTransforms.gathered(numbers, vertices, width) }

    /** Returns a mesh of [triangles] whose vertices have what [change] makes of the numbers of each kind. */
    internal fun mapped(
        triangles: IntArray,
        normals: FloatArray? = null,
        tangents: FloatArray? = null,
        change: (numbers: FloatArray, width: Int) -> FloatArray,
    ): Mesh = Mesh(
        change(positions, 3), triangles, material, normals ?: this.normals?.let { change(it, 3) },
        uvs?.let { change(it, 2) }, colors?.let { change(it, 4) }, origin, uvs2?.let { change(it, 2) },
        tangents ?: this.tangents?.let { change(it, 4) }, name,
    )

    /**
     * Returns this mesh with normals computed from its triangles. The normal at a vertex is the mean, weighted by area,
     * of the normals of the triangles around it that differ by less than [creaseAngle] degrees. Vertices at the same
     * position count as one vertex. A vertex on a crease is split, so that edges sharper than the angle stay sharp. If
     * more than 1024 corners of triangles are at one position, all of them are averaged. Cost: linear in the size of
     * the mesh.
     *
     * @param look called now and then on the calling thread; what it throws ends the work
     * @throws IllegalArgumentException if [creaseAngle] is not in 0..180
     */
    @JvmOverloads
    public fun withSmoothNormals(creaseAngle: Double = 45.0, look: Runnable? = null): Mesh =
        SmoothNormals(this, creaseAngle, look?.let { Checkpoint(it::run) } ?: Checkpoint.NONE).mesh()

    /**
     * Returns this mesh with tangents computed from its texture coordinates, for a normal map at these coordinates; see
     * [NormalMap]. A vertex at the seam of a mirrored texture is split. Vertices without an area in the texture get the
     * tangent (0, 0, 0), so a normal map does not change their normals. Cost: linear in the size of the mesh.
     *
     * @param uvSet which texture coordinates: 0 for [uvs], 1 for [uvs2]
     * @param transform the transform of the normal map
     * @throws IllegalArgumentException if the mesh has no such texture coordinates
     */
    @JvmOverloads
    public fun withTangents(uvSet: Int = 0, transform: UvTransform = UvTransform.IDENTITY): Mesh {
        require(uvSet in 0..1) { "uvSet must be 0 or 1: $uvSet" }
        val places = if (uvSet == 0) uvs else uvs2
        return VertexTangents(this, requireNotNull(places) { "the mesh has no texture coordinates" }, transform).mesh()
    }

    /**
     * Returns this mesh with the tangents that its material uses, see [Material.usesTangents], or the mesh itself if it
     * has tangents, or not the texture coordinates that they belong to.
     */
    public fun withNeededTangents(): Mesh {
        val map = material.tangentMap
        val places = if (map?.uvSet == 1) uvs2 else uvs
        if (tangents != null || places == null || !material.usesTangents) return this
        return withTangents(map?.uvSet ?: 0, map?.transform ?: UvTransform.IDENTITY)
    }

    override fun toString(): String = "Mesh($vertexCount vertices, $triangleCount triangles, $material)"
}

/**
 * Computes normals of a mesh from its triangles, see [Mesh.withSmoothNormals].
 *
 * Face normals are added in the order of the triangles, and vertices are numbered in the order of their first corner,
 * so the result does not depend on how the work is divided between threads.
 *
 * @param checkpoint may end the work; passed on the calling thread
 */
internal class SmoothNormals(
    private val mesh: Mesh,
    private val creaseAngle: Double,
    private val checkpoint: Checkpoint = Checkpoint.NONE,
) {
    init {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
    }

    /** By corner: the copy of its vertex. First numbered within the chunk of positions, later within the new mesh. */
    private val triangles = IntArray(mesh.triangles.size)

    /** Returns the mesh with normals. A vertex has as many copies as its corners have different normals. */
    fun mesh(): Mesh = numbered(copies())

    /** The normals of the copies of vertices, by chunk of positions. */
    private class Copies(val positionOf: IntArray, val sizes: IntArray, val normals: List<FloatArray>)

    private fun copies(): Copies {
        val byPosition = CornersByPosition(mesh.positions, mesh.triangles, checkpoint)
        val firstCopy = IntArray(mesh.vertexCount) { -1 }
        val chunks = List((byPosition.count + CHUNK - 1) / CHUNK) {
            CornerNormals(mesh.positions, mesh.triangles, creaseAngle, firstCopy, triangles)
        }
        Workers.ALL.forEach(chunks.size, checkpoint) { chunk, own ->
            for (position in chunk * CHUNK until minOf((chunk + 1) * CHUNK, byPosition.count)) {
                val start = byPosition.starts[position]
                val end = byPosition.starts[position + 1]
                if (Checkpoint.isDue(position) || end - start > MANY) own.pass()
                chunks[chunk].add(byPosition.corners, start, end)
            }
        }
        return Copies(byPosition.positionOf, IntArray(chunks.size) { chunks[it].size }, chunks.map { it.normals })
    }

    /** Renumbers the copies in the order of their first corner, and builds the mesh. */
    private fun numbered(copies: Copies): Mesh {
        val numbers = Array(copies.sizes.size) { IntArray(copies.sizes[it]) { -1 } }
        val sources = IntArray(copies.sizes.sum())
        val normals = FloatArray(3 * sources.size)
        var count = 0
        for ((corner, vertex) in mesh.triangles.withIndex()) {
            if (Checkpoint.isDue(corner)) checkpoint.pass()
            val chunk = copies.positionOf[vertex] / CHUNK
            val copy = triangles[corner]
            var number = numbers[chunk][copy]
            if (number < 0) {
                number = count++
                numbers[chunk][copy] = number
                sources[number] = vertex
                copies.normals[chunk].copyInto(normals, 3 * number, 3 * copy, 3 * copy + 3)
            }
            triangles[corner] = number
        }
        return mesh.withVertices(sources, triangles, normals)
    }

    private companion object {
        /** Number of positions in one task of a thread. */
        const val CHUNK = 1 shl 16

        /** Number of corners at one position that take long, as each is compared with each. */
        const val MANY = 32
    }
}
