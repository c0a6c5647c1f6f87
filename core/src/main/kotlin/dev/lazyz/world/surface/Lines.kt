package dev.lazyz.world.surface

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.PointBlocks
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.geometry.VertexTransforms
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import java.util.function.UnaryOperator
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Line segments with a constant width in pixels, at any distance (contract rule 2.10).
 *
 * Segments share vertices; [segments] has two vertex numbers for each segment. Ends are square: a segment extends half
 * a width beyond its vertices, so that polylines have no gaps. Depth and colour change along a segment, not across it.
 * Lines are shown in their own colour, without light, whatever the material's [Shading]. Textures are ignored, because
 * a line has no area to map.
 *
 * Positions can be NaN or infinite: a segment with such a vertex covers nothing. The arrays are not copied; do not
 * change them. Thread safe.
 *
 * @property positions x, y, z for each vertex, world space, relative to [origin]
 * @property segments two vertex numbers for each segment; the order of segments is the submission order
 * @property width width in pixels, above 0 and at most [Points.MAX_SIZE]; widths below 1 count as 1
 * @property material the appearance
 * @property colors red, green, blue, alpha for each vertex, linear light; null means white
 * @param origin added to all positions, see [Mesh.origin]; must be finite
 * @property name see [Surface.name]
 * @throws IllegalArgumentException if an array has the wrong length, a vertex number or the width is out of range, or
 *   [origin] is not finite
 */
public class Lines @JvmOverloads constructor(
    public val positions: FloatArray,
    public val segments: IntArray,
    public val width: Double = 1.0,
    override val material: Material = Material(),
    public val colors: FloatArray? = null,
    origin: Vector3dc = Vectors.ZERO,
    override val name: String = "",
) : Surface {
    /** The origin of [positions], world space: it is added to each of them. */
    override val origin: Vector3dc = if (origin === Vectors.ZERO) origin else Vector3d(origin)

    /** Number of vertices. */
    public val vertexCount: Int = positions.size / 3

    /** Number of segments. */
    public val segmentCount: Int = segments.size / 2

    init {
        require(Vectors.isFinite(origin)) { "origin must be finite: $origin" }
        require(positions.size % 3 == 0) { "positions must be triples: ${positions.size} numbers" }
        require(segments.size % 2 == 0) { "segments must be pairs: ${segments.size} vertex numbers" }
        require(width > 0.0 && width <= Points.MAX_SIZE) {
            "width must be above 0 and at most ${Points.MAX_SIZE} pixels: $width"
        }
        require(colors == null || colors.size == 4 * vertexCount) {
            "colors must be four numbers a vertex: ${colors?.size} numbers for $vertexCount vertices"
        }
        for (vertex in segments) {
            require(vertex in 0 until vertexCount) { "vertex number must be in 0..${vertexCount - 1}: $vertex" }
        }
    }

    override val pixelSize: Double get() = width

    override val setUpBytes: Long get() = HeapLayout.SHAPE * segmentCount

    private val blocks by lazy { PointBlocks(positions, segments) }

    /** A box around the vertices that segments use, or null if there is none. */
    override val bounds: Box? by lazy { blocks.bounds?.moved(this.origin) }

    override fun farthest(direction: Vector3dc): Vector3d? = blocks.farthest(direction)?.add(origin)

    override fun primitives(setUp: SetUp): Sequence<Primitive> = setUp.lines(this)

    override fun withMaterials(change: UnaryOperator<Material>): Lines =
        Lines(positions, segments, width, change.apply(material), colors, origin, name)

    override fun withUpAxis(up: UpAxis): Lines =
        Lines(up.toWorld(positions), segments, width, material, colors, up.toWorld(origin), name)

    override fun hasUvs(set: Int): Boolean = false

    override fun withoutColors(): Lines =
        if (colors == null) this else Lines(positions, segments, width, material, null, origin, name)

    override fun withName(name: String): Lines = Lines(positions, segments, width, material, colors, origin, name)

    override fun magnified(factor: Int): Lines = withWidth(width * factor)

    /** Returns these lines with another [width]; the arrays are shared. */
    public fun withWidth(width: Double): Lines = Lines(positions, segments, width, material, colors, origin, name)

    /** Returns the same lines with positions relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Lines = if (origin == this.origin) {
        this
    } else {
        val moved = VertexTransforms.relativeTo(origin, positions, this.origin)
        Lines(moved, segments, width, material, colors, origin, name)
    }

    /** Returns these lines transformed by an affine [transform]. The width is unchanged. */
    public fun transformed(transform: Matrix4dc): Lines {
        val moved = VertexTransforms.origin(bounds, transform)
        val positions = VertexTransforms.positions(positions, origin, transform, moved)
        return Lines(positions, segments, width, material, colors, moved, name)
    }

    override fun toString(): String = "Lines($segmentCount segments of $width pixels, $material)"
}
