package dev.lazyz.world.surface

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.PointBlocks
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.geometry.VertexTransforms
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import java.util.function.UnaryOperator
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A point cloud: squares with a constant size in pixels, at any distance (contract rule 2.9).
 *
 * [positions], [normals] and [colors] are indexed by point. Points without [normals] are shown in their own colour,
 * without light. Points with normals are lit; for them, [Shading.FLAT] and [Shading.GOURAUD] mean [Shading.PHONG].
 * Textures are ignored, because a point has no area to map. A mask keeps or removes a whole point, by the alpha of its
 * colour.
 *
 * Positions can be NaN or infinite: such a point covers nothing. The arrays are not copied; do not change them. Thread
 * safe. A frame uses 40 bytes a point in addition to the arrays.
 *
 * @property positions x, y, z for each point, world space, relative to [origin]; the order of points is the submission
 *   order
 * @property size side of the squares in pixels, above 0 and at most [MAX_SIZE]; sizes below 1 count as 1, so that every
 *   point covers a sample
 * @property material the appearance
 * @property normals x, y, z for each point, of any length; null means no light
 * @property colors red, green, blue, alpha for each point, linear light; null means white
 * @param origin added to all positions, see [Mesh.origin]; must be finite
 * @property name see [Surface.name]
 * @throws IllegalArgumentException if an array has the wrong length, the size is out of range, or [origin] is not
 *   finite
 */
public class Points @JvmOverloads constructor(
    public val positions: FloatArray,
    public val size: Double = 1.0,
    override val material: Material = Material(),
    public val normals: FloatArray? = null,
    public val colors: FloatArray? = null,
    origin: Vector3dc = Vectors.ZERO,
    override val name: String = "",
) : Surface {
    /** The origin of [positions], world space: it is added to each of them. */
    override val origin: Vector3dc = if (origin === Vectors.ZERO) origin else Vector3d(origin)

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

    override val pixelSize: Double get() = size

    override val setUpBytes: Long get() = HeapLayout.SHAPE * pointCount

    private val blocks by lazy { PointBlocks(positions) }

    override val bounds: Box? by lazy { blocks.bounds?.moved(this.origin) }

    override fun farthest(direction: Vector3dc): Vector3d? = blocks.farthest(direction)?.add(origin)

    override fun primitives(setUp: SetUp): Sequence<Primitive> = setUp.points(this)

    override fun withMaterials(change: UnaryOperator<Material>): Points =
        Points(positions, size, change.apply(material), normals, colors, origin, name)

    override fun withUpAxis(up: UpAxis): Points =
        Points(up.toWorld(positions), size, material, normals?.let(up::toWorld), colors, up.toWorld(origin), name)

    override fun hasUvs(set: Int): Boolean = false

    override fun withoutColors(): Points =
        if (colors == null) this else Points(positions, size, material, normals, null, origin, name)

    override fun withName(name: String): Points = Points(positions, size, material, normals, colors, origin, name)

    override fun magnified(factor: Int): Points = withSize(size * factor)

    /** Returns these points with another [size]; the arrays are shared. */
    public fun withSize(size: Double): Points = Points(positions, size, material, normals, colors, origin, name)

    /** Returns the same points with positions relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Points = if (origin == this.origin) {
        this
    } else {
        val moved = VertexTransforms.relativeTo(origin, positions, this.origin)
        Points(moved, size, material, normals, colors, origin, name)
    }

    /**
     * Returns these points transformed by an affine [transform]. Normals are transformed by the inverse transpose, and
     * get unit length; a translation leaves them as they are. The size is unchanged.
     */
    public fun transformed(transform: Matrix4dc): Points {
        val moved = VertexTransforms.origin(bounds, transform)
        val positions = VertexTransforms.positions(positions, origin, transform, moved)
        val normals = normals?.let { VertexTransforms.normals(it, transform) }
        return Points(positions, size, material, normals, colors, moved, name)
    }

    override fun toString(): String = "Points($pointCount points of $size pixels, $material)"

    public companion object {
        /** Maximum size of points and width of [Lines], pixels. */
        public const val MAX_SIZE: Int = ScreenGrid.GREATEST_SIZE
    }
}
