package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import dev.lazyz.geometry.VertexTransforms
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Triangles that share vertices, all of one material.
 *
 * All arrays are indexed by vertex; [triangles] holds three vertex numbers a triangle, counter-clockwise seen from
 * outside. Positions that are NaN or infinite are legal: a triangle with such a vertex covers nothing. The mesh keeps
 * the arrays without copying them; leave them alone. Thread safe.
 *
 * @property positions x, y, z for each vertex, world space, relative to [origin]
 * @property triangles three vertex numbers for each triangle; the order of triangles is the order of submission
 * @property material how it looks
 * @property normals x, y, z for each vertex, pointing outward, need not be of unit length; null means each triangle's own
 * @property uvs u, v for each vertex, see [Texture]; null means none
 * @property colors red, green, blue, alpha for each vertex, linear light; null means white
 * @param origin what is added to all positions: it keeps the details of a mesh that is far away from the world's origin,
 *   as in coordinates of maps, where 32-bit positions would be too coarse; must be finite
 * @throws IllegalArgumentException if an array has the wrong length or a vertex number is out of range
 */
public class Mesh @JvmOverloads constructor(
    public val positions: FloatArray,
    public val triangles: IntArray,
    public val material: Material = Material(),
    public val normals: FloatArray? = null,
    public val uvs: FloatArray? = null,
    public val colors: FloatArray? = null,
    origin: Vector3dc = Vectors.ZERO,
) : Surface {
    /** What is added to all positions, world space. */
    public val origin: Vector3dc = if (origin === Vectors.ZERO) origin else Vector3d(origin)

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
        for (vertex in triangles) {
            require(vertex in 0 until vertexCount) { "vertex number must be in 0..${vertexCount - 1}: $vertex" }
        }
    }

    override val bounds: Box? by lazy { Box.around(positions)?.moved(this.origin) }

    override fun primitives(setUp: SetUp): Sequence<Primitive> = setUp.mesh(this)

    override fun withMaterials(change: (Material) -> Material): Mesh =
        Mesh(positions, triangles, change(material), normals, uvs, colors, origin)

    /** Returns this mesh at the same place with positions relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Mesh = if (origin == this.origin) {
        this
    } else {
        val moved = VertexTransforms.relativeTo(origin, positions, this.origin)
        Mesh(moved, triangles, material, normals, uvs, colors, origin)
    }

    /**
     * Returns this mesh moved by an affine [transform]. Normals are moved by the inverse transpose; a transform that
     * mirrors also turns every triangle round, so that outside stays outside. A mesh that comes to lie far away from the
     * world's origin, for its size, gets an [origin] in its middle.
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
        return Mesh(positions, corners, material, normals, uvs, colors, moved)
    }

    /**
     * Returns this mesh with normals made of its triangles': at each vertex the mean, weighted by area, of the normals
     * of the triangles around it that differ by less than [creaseAngle] degrees. Vertices at one position count as one
     * vertex, and are split where a crease runs, so that edges sharper than the angle stay sharp; where more than 341
     * triangles meet, all are averaged. Cost: linear in the size of the mesh.
     *
     * @throws IllegalArgumentException unless [creaseAngle] is in 0..180
     */
    @JvmOverloads
    public fun withSmoothNormals(creaseAngle: Double = 45.0): Mesh = SmoothNormals(this, creaseAngle).mesh()

    override fun toString(): String = "Mesh($vertexCount vertices, $triangleCount triangles, $material)"
}
