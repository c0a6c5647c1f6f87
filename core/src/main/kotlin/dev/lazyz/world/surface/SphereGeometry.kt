package dev.lazyz.world.surface

import org.joml.Matrix4dc
import org.joml.Vector3d

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
