package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.Vectors
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * A sphere, rendered as what it is: its outline and its depth are computed at every sample, not tessellated.
 *
 * Normals point outward. Texture coordinates run once around: u along the equator eastward from -z, v from the north
 * pole (+y) to the south pole. [Shading.FLAT] and [Shading.GOURAUD] mean [Shading.PHONG] here, for a sphere has neither
 * faces nor vertices. A radius or centre that is NaN or infinite is legal: such a sphere covers nothing. Immutable.
 *
 * @property radius world units, not negative
 * @property material how it looks
 */
public class Sphere @JvmOverloads constructor(
    center: Vector3dc,
    public val radius: Double,
    public val material: Material = Material(),
) : Surface {
    /** The middle, world space. */
    public val center: Vector3dc = Vector3d(center)

    init {
        require(!(radius < 0.0)) { "radius must not be negative: $radius" }
    }

    /** Whether coordinates are numbers that can still be added up. */
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

    override fun primitives(setUp: SetUp): Sequence<Primitive> = sequenceOf(this).map { setUp.sphere(it) }

    override fun withMaterials(change: (Material) -> Material): Sphere = Sphere(center, radius, change(material))

    /**
     * Returns this sphere moved by [transform], which must keep it a sphere.
     *
     * @throws IllegalArgumentException if the transform does not scale all directions alike
     */
    public fun transformed(transform: Matrix4dc): Sphere = SphereGeometry.transformed(this, transform)

    /** Returns this sphere as it is seen from [origin]. */
    internal fun relativeTo(origin: Vector3dc): Sphere =
        if (Vectors.isZero(origin)) this else Sphere(Vectors.minus(center, origin), radius, material)

    override fun toString(): String = "Sphere($center, $radius, $material)"
}
