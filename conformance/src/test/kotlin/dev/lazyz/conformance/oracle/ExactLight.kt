package dev.lazyz.conformance.oracle

import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Material
import dev.lazyz.world.Projection
import dev.lazyz.world.Shading
import org.joml.Vector3d
import org.joml.Vector3dc

/** Light as contract rule 6.5 defines it, in double precision: an oracle for the library's own light. */
internal class ExactLight(private val camera: Camera, private val lights: List<Light>) {
    private val isPerspective = camera.projection is Projection.Perspective

    /** Factor of a surface's own colour, and what is added to it; red, green, blue. */
    class Sum(val factor: DoubleArray, val summand: DoubleArray)

    /** Returns the vector from [point] to the viewer, of any length. */
    fun toViewer(point: Vector3dc): Vector3d =
        if (isPerspective) Vector3d(camera.eye).sub(point) else camera.toWorldDirection(0.0, 0.0, 1.0)

    /**
     * Returns the light at [point], or null where rounding decides: a normal of almost no length, a light at the point.
     *
     * @param isPhong whether the highlight is Phong's instead of Blinn's
     * @param graze the cosine above which a light shines: about 0
     */
    fun at(material: Material, point: Vector3dc, normal: Vector3dc, isPhong: Boolean, graze: Double): Sum? {
        val v = toViewer(point).normalize()
        val length = normal.length()
        if (length > 0.0 && length < LEAST) return null
        val n = if (length == 0.0) v else Vector3d(normal).div(length)
        val factor = DoubleArray(3)
        val summand = parts(material.emission)
        for (light in lights) {
            val color = parts(light.color)
            val l = when (light) {
                is Light.Ambient -> {
                    for (k in 0 until 3) factor[k] += color[k]
                    continue
                }
                is Light.Directional -> Vector3d(light.direction).negate()
                is Light.Point -> Vector3d(light.position).sub(point)
                is Light.Spot -> error("no generated scene has a $light")
            }
            if (l.length() < LEAST) return null
            l.normalize()
            val cosine = n.dot(l)
            if (!(cosine > graze)) continue
            for (k in 0 until 3) factor[k] += color[k] * cosine
            val specular = parts(material.specular)
            if (specular.all { it == 0.0 }) continue
            val h = Vector3d(l).add(v)
            if (h.length() < LEAST) return null
            val highlight = if (isPhong) 2 * cosine * n.dot(v) - l.dot(v) else n.dot(h) / h.length()
            if (!(highlight > 0.0)) continue
            val strength = Math.pow(highlight, material.shininess.toDouble())
            for (k in 0 until 3) summand[k] += color[k] * specular[k] * strength
        }
        return Sum(factor, summand)
    }

    companion object {
        private const val LEAST = 1e-4

        fun parts(color: Rgba): DoubleArray =
            doubleArrayOf(color.red.toDouble(), color.green.toDouble(), color.blue.toDouble())

        /** Whether light is evaluated at the vertices. */
        fun isAtVertices(shading: Shading): Boolean = shading == Shading.FLAT || shading == Shading.GOURAUD
    }
}
