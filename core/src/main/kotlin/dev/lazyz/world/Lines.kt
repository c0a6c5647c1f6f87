package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import dev.lazyz.geometry.VertexTransforms
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Line segments of one width in pixels, however far away they are (contract rule 2.10).
 *
 * Segments share vertices; [segments] holds two vertex numbers a segment. Ends are square: a segment reaches half a width
 * beyond its vertices, so that those of a polyline leave no gaps. Depth and colour change along a segment, not across it.
 * Lines are shown in their own colour, without light, whatever the material's [Shading]; textures are ignored, for a
 * line has no area that could be mapped.
 *
 * Positions that are NaN or infinite are legal: a segment with such a vertex covers nothing. The lines keep the arrays
 * without copying them; leave them alone. Thread safe.
 *
 * @property positions x, y, z for each vertex, world space, relative to [origin]
 * @property segments two vertex numbers for each segment; the order of segments is the order of submission
 * @property width pixels across a segment, above 0 and at most [Points.MAX_SIZE]; what is less than a pixel counts as one
 * @property material how it looks
 * @property colors red, green, blue, alpha for each vertex, linear light; null means white
 * @param origin what is added to all positions, see [Mesh.origin]; must be finite
 * @throws IllegalArgumentException if an array has the wrong length, or a vertex number or the width is out of range
 */
public class Lines @JvmOverloads constructor(
    public val positions: FloatArray,
    public val segments: IntArray,
    public val width: Double = 1.0,
    public val material: Material = Material(),
    public val colors: FloatArray? = null,
    origin: Vector3dc = Vectors.ZERO,
) : Surface {
    /** What is added to all positions, world space. */
    public val origin: Vector3dc = if (origin === Vectors.ZERO) origin else Vector3d(origin)

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

    override val bounds: Box? by lazy { Box.around(positions)?.moved(this.origin) }

    override fun primitives(setUp: SetUp): Sequence<Primitive> = setUp.lines(this)

    override fun withMaterials(change: (Material) -> Material): Lines =
        Lines(positions, segments, width, change(material), colors, origin)

    /** Returns these lines in another [width]. */
    public fun withWidth(width: Double): Lines = Lines(positions, segments, width, material, colors, origin)

    /** Returns these lines at the same place with positions relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Lines = if (origin == this.origin) {
        this
    } else {
        val moved = VertexTransforms.relativeTo(origin, positions, this.origin)
        Lines(moved, segments, width, material, colors, origin)
    }

    /** Returns these lines moved by an affine [transform], in the same width. */
    public fun transformed(transform: Matrix4dc): Lines {
        val moved = VertexTransforms.origin(bounds, transform)
        val positions = VertexTransforms.positions(positions, origin, transform, moved)
        return Lines(positions, segments, width, material, colors, moved)
    }

    override fun toString(): String = "Lines($segmentCount segments of $width pixels, $material)"
}
