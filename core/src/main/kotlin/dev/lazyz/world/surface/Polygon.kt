package dev.lazyz.world.surface

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Rgba
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.FillRule
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import java.util.function.UnaryOperator
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A flat polygon with any number of contours: convex, concave, with holes, or self-intersecting.
 *
 * Each contour is closed. Depth and attributes are those of the plane through a reference triangle of the polygon's
 * vertices (contract rule 3.5), so all vertices should be in one plane; if they are not, that plane is drawn. The lists
 * are not copied; do not change them. Immutable and thread safe.
 *
 * @property contours lists of vertices, world space; the outer contour is counter-clockwise seen from the front
 * @property material the appearance
 * @property fillRule which samples are inside
 * @property name see [Surface.name]
 * @property isCap whether it is a cap that a section made; functions that return a changed polygon keep it
 */
public class Polygon internal constructor(
    public val contours: List<List<Vertex>>,
    override val material: Material,
    public val fillRule: FillRule,
    override val name: String,
    public val isCap: Boolean,
) : Surface {
    /** Creates a polygon that is no cap. */
    @JvmOverloads
    public constructor(
        contours: List<List<Vertex>>,
        material: Material = Material(),
        fillRule: FillRule = FillRule.EVEN_ODD,
        name: String = "",
    ) : this(contours, material, fillRule, name, isCap = false)

    override val setUpBytes: Long get() = HeapLayout.SHAPE + HeapLayout.CORNER * contours.sumOf { it.size }

    override val bounds: Box? by lazy {
        val all = contours.flatten()
        Box.around(all.size) { vertex, axis -> all[vertex].position(axis) }
    }

    override fun farthest(direction: Vector3dc): Vector3d? {
        var farthest: Vertex? = null
        var most = Double.NEGATIVE_INFINITY
        for (contour in contours) {
            for (vertex in contour) {
                val product = direction.x() * vertex.x + direction.y() * vertex.y + direction.z() * vertex.z
                if (product > most && vertex.isFinite) {
                    most = product
                    farthest = vertex
                }
            }
        }
        return farthest?.let { Vector3d(it.x, it.y, it.z) }
    }

    override fun primitives(setUp: SetUp): Sequence<Primitive> = sequenceOf(this).map { setUp.polygon(it) }

    override fun withMaterials(change: UnaryOperator<Material>): Polygon =
        Polygon(contours, change.apply(material), fillRule, name, isCap)

    override fun withUpAxis(up: UpAxis): Polygon = changed { it.withUpAxis(up) }

    override fun withoutColors(): Polygon {
        val hasNone = contours.all { contour -> contour.all { it.color == Rgba.WHITE } }
        return if (hasNone) this else changed { Vertex(it.x, it.y, it.z, it.u, it.v) }
    }

    override fun withName(name: String): Polygon = Polygon(contours, material, fillRule, name, isCap)

    /** Returns this polygon transformed by an affine [transform]. */
    public fun transformed(transform: Matrix4dc): Polygon = changed { it.transformed(transform) }

    /** Returns this polygon relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Polygon =
        if (Vectors.isZero(origin)) this else changed { it.relativeTo(origin) }

    private inline fun changed(change: (Vertex) -> Vertex): Polygon =
        Polygon(contours.map { contour -> contour.map(change) }, material, fillRule, name, isCap)

    override fun toString(): String = "Polygon(${contours.map { it.size }} vertices, $fillRule, $material)"

    /**
     * A vertex of a [Polygon]. Immutable.
     *
     * @property x position, world space
     * @property y see [x]
     * @property z see [x]
     * @property u texture coordinate to the right, see [Texture]
     * @property v texture coordinate downward, see [Texture]
     * @property color vertex colour; multiplies the colour of the material
     */
    public class Vertex @JvmOverloads constructor(
        public val x: Double,
        public val y: Double,
        public val z: Double,
        public val u: Float = 0f,
        public val v: Float = 0f,
        public val color: Rgba = Rgba.WHITE,
    ) {
        /** Whether the position counts for bounds. */
        internal val isFinite: Boolean get() = (0 until 3).all { StrictMath.abs(position(it)) < Box.LARGEST }

        internal fun position(axis: Int): Double = when (axis) {
            0 -> x
            1 -> y
            else -> z
        }

        internal fun transformed(m: Matrix4dc): Vertex = Vertex(
            m.m00() * x + m.m10() * y + m.m20() * z + m.m30(),
            m.m01() * x + m.m11() * y + m.m21() * z + m.m31(),
            m.m02() * x + m.m12() * y + m.m22() * z + m.m32(),
            u,
            v,
            color,
        )

        internal fun withUpAxis(up: UpAxis): Vertex {
            val turned = up.toWorld(Vector3d(x, y, z))
            return Vertex(turned.x, turned.y, turned.z, u, v, color)
        }

        internal fun relativeTo(origin: Vector3dc): Vertex =
            Vertex(x - origin.x(), y - origin.y(), z - origin.z(), u, v, color)

        override fun toString(): String = "Vertex($x, $y, $z)"
    }
}
