package dev.lazyz.world.surface

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.geometry.Vectors
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import java.util.function.UnaryOperator
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A sphere. Its outline and depth are computed exactly at every sample, without tessellation.
 *
 * Normals point outward. Texture coordinates: u goes once around the equator, eastward from -z; v goes from the north
 * pole (+y) to the south pole. [Shading.FLAT] and [Shading.GOURAUD] mean [Shading.PHONG], because a sphere has neither
 * faces nor vertices. The radius or centre can be NaN or infinite: such a sphere covers nothing. Immutable.
 *
 * @property radius world units, not negative
 * @property material the appearance
 * @property name see [Surface.name]
 * @throws IllegalArgumentException if [radius] is negative
 */
public class Sphere @JvmOverloads constructor(
    center: Vector3dc,
    public val radius: Double,
    override val material: Material = Material(),
    override val name: String = "",
) : Surface {
    /** The centre, world space. */
    public val center: Vector3dc = Vector3d(center)

    init {
        require(!(radius < 0.0)) { "radius must not be negative: $radius" }
    }

    /** Whether the coordinates are finite and small enough to be added without overflow. */
    private val hasBounds: Boolean
        get() = StrictMath.abs(center.x()) + StrictMath.abs(center.y()) + StrictMath.abs(center.z()) + radius <
            Box.LARGEST

    override val bounds: Box?
        get() = if (!hasBounds) {
            null
        } else {
            Box(
                center.x() - radius, center.y() - radius, center.z() - radius,
                center.x() + radius, center.y() + radius, center.z() + radius,
            )
        }

    override fun farthest(direction: Vector3dc): Vector3d? {
        if (!hasBounds) return null
        val square = Vectors.dot(direction, direction)
        val scale = if (square > 0.0) radius / StrictMath.sqrt(square) else 0.0
        return Vector3d(
            center.x() + scale * direction.x(), center.y() + scale * direction.y(), center.z() + scale * direction.z(),
        )
    }

    override fun primitives(setUp: SetUp): Sequence<Primitive> = sequenceOf(this).map { setUp.sphere(it) }

    override fun withMaterials(change: UnaryOperator<Material>): Sphere =
        Sphere(center, radius, change.apply(material), name)

    override fun withUpAxis(up: UpAxis): Sphere = Sphere(up.toWorld(center), radius, material, name)

    override fun withName(name: String): Sphere = Sphere(center, radius, material, name)

    /**
     * Returns this sphere transformed by [transform], which must scale all directions equally.
     *
     * @throws IllegalArgumentException if the transform does not scale all directions equally
     */
    public fun transformed(transform: Matrix4dc): Sphere = SphereGeometry.transformed(this, transform)

    /** Returns this sphere relative to [origin]. */
    internal fun relativeTo(origin: Vector3dc): Sphere =
        if (Vectors.isZero(origin)) this else Sphere(Vectors.minus(center, origin), radius, material, name)

    override fun toString(): String = "Sphere($center, $radius, $material)"
}

/** Transforms spheres. */
internal object SphereGeometry {
    fun transformed(sphere: Sphere, m: Matrix4dc): Sphere {
        val xx = m.m00() * m.m00() + m.m01() * m.m01() + m.m02() * m.m02()
        val yy = m.m10() * m.m10() + m.m11() * m.m11() + m.m12() * m.m12()
        val zz = m.m20() * m.m20() + m.m21() * m.m21() + m.m22() * m.m22()
        val xy = m.m00() * m.m10() + m.m01() * m.m11() + m.m02() * m.m12()
        val yz = m.m10() * m.m20() + m.m11() * m.m21() + m.m12() * m.m22()
        val zx = m.m20() * m.m00() + m.m21() * m.m01() + m.m22() * m.m02()
        val tolerance = 1e-6 * xx
        val error = maxOf(
            maxOf(StrictMath.abs(xx - yy), StrictMath.abs(xx - zz)),
            maxOf(StrictMath.abs(xy), StrictMath.abs(yz), StrictMath.abs(zx)),
        )
        require(error <= tolerance) { "a sphere must be scaled equally in all directions: $m" }
        val c = sphere.center
        val center = Vector3d(
            m.m00() * c.x() + m.m10() * c.y() + m.m20() * c.z() + m.m30(),
            m.m01() * c.x() + m.m11() * c.y() + m.m21() * c.z() + m.m31(),
            m.m02() * c.x() + m.m12() * c.y() + m.m22() * c.z() + m.m32(),
        )
        return Sphere(center, sphere.radius * StrictMath.sqrt(xx), sphere.material, sphere.name)
    }
}
