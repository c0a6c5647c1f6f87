package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import dev.lazyz.geometry.VertexTransforms
import dev.lazyz.raster.ScreenGrid
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A cloud of points: squares of one size in pixels, however far away they are (contract rule 2.9).
 *
 * All arrays are indexed by point. Points without [normals] are shown in their own colour, without light; points with
 * normals are lit, and [Shading.FLAT] and [Shading.GOURAUD] mean [Shading.PHONG] here. Textures are ignored, for a point
 * has no area that could be mapped. A mask takes or leaves a point as a whole, by its colour's alpha.
 *
 * Positions that are NaN or infinite are legal: such a point covers nothing. The cloud keeps the arrays without copying
 * them; leave them alone. Thread safe. A frame holds 40 bytes a point besides the arrays.
 *
 * @property positions x, y, z for each point, world space, relative to [origin]; the order of points is the order of submission
 * @property size side of the squares, pixels, above 0 and at most [MAX_SIZE]; what is less than a pixel counts as one, so
 *   that no point falls between the samples
 * @property material how it looks
 * @property normals x, y, z for each point, need not be of unit length; null means no light
 * @property colors red, green, blue, alpha for each point, linear light; null means white
 * @param origin what is added to all positions, see [Mesh.origin]; must be finite
 * @throws IllegalArgumentException if an array has the wrong length or the size is out of range
 */
public class Points @JvmOverloads constructor(
    public val positions: FloatArray,
    public val size: Double = 1.0,
    public val material: Material = Material(),
    public val normals: FloatArray? = null,
    public val colors: FloatArray? = null,
    origin: Vector3dc = Vectors.ZERO,
) : Surface {
    /** What is added to all positions, world space. */
    public val origin: Vector3dc = if (origin === Vectors.ZERO) origin else Vector3d(origin)

    /** Number of points. */
    public val pointCount: Int = positions.size / 3

    init {
        require(Vectors.isFinite(origin)) { "origin must be finite: $origin" }
        require(positions.size % 3 == 0) { "positions must be triples: ${positions.size} numbers" }
        require(size > 0.0 && size <= MAX_SIZE) { "size must be above 0 and at most $MAX_SIZE pixels: $size" }
        require(normals == null || normals.size == 3 * pointCount) {
            "normals must be one triple a point: ${normals?.size} numbers for $pointCount points"
        }
        require(colors == null || colors.size == 4 * pointCount) {
            "colors must be four numbers a point: ${colors?.size} numbers for $pointCount points"
        }
    }

    override val bounds: Box? by lazy { Box.around(positions)?.moved(this.origin) }

    override fun primitives(setUp: SetUp): Sequence<Primitive> = setUp.points(this)

    override fun withMaterials(change: (Material) -> Material): Points =
        Points(positions, size, change(material), normals, colors, origin)

    /** Returns these points in another [size]. */
    public fun withSize(size: Double): Points = Points(positions, size, material, normals, colors, origin)

    /** Returns these points at the same place with positions relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Points = if (origin == this.origin) {
        this
    } else {
        val moved = VertexTransforms.relativeTo(origin, positions, this.origin)
        Points(moved, size, material, normals, colors, origin)
    }

    /** Returns these points moved by an affine [transform], in the same size. Normals are moved by the inverse transpose. */
    public fun transformed(transform: Matrix4dc): Points {
        val moved = VertexTransforms.origin(bounds, transform)
        val positions = VertexTransforms.positions(positions, origin, transform, moved)
        val normals = normals?.let { VertexTransforms.normals(it, transform) }
        return Points(positions, size, material, normals, colors, moved)
    }

    override fun toString(): String = "Points($pointCount points of $size pixels, $material)"

    public companion object {
        /** Greatest size of points and width of [Lines], pixels. */
        public const val MAX_SIZE: Int = ScreenGrid.GREATEST_SIZE
    }
}
