package dev.lazyz.shading.pbr

import org.joml.Vector3d

/** The formulas of glTF 2.0, appendix B, as printed there, in double precision: independent of the renderer. */
internal object Appendix {
    /** Returns the BRDF times the cosine, red, green and blue, for unit vectors. */
    fun reflected(
        base: List<Double>,
        metallic: Double,
        roughness: Double,
        n: Vector3d,
        l: Vector3d,
        v: Vector3d,
    ): List<Double> {
        val h = Vector3d(l).add(v).normalize()
        val alpha = roughness * roughness
        val fresnel = Math.pow(1.0 - Math.abs(v.dot(h)), 5.0)
        val d = distribution(n.dot(h), alpha)
        val visibility = visibility(n.dot(l), n.dot(v), alpha)
        return base.map { color ->
            val diffuse = color * (1.0 - metallic)
            val f0 = 0.04 * (1.0 - metallic) + color * metallic
            val f = f0 + (1.0 - f0) * fresnel
            ((1.0 - f) / Math.PI * diffuse + f * d * visibility) * Math.max(n.dot(l), 0.0)
        }
    }

    fun distribution(cosineH: Double, alpha: Double): Double {
        if (cosineH <= 0.0) return 0.0
        val a2 = alpha * alpha
        return a2 / (Math.PI * Math.pow(cosineH * cosineH * (a2 - 1.0) + 1.0, 2.0))
    }

    fun visibility(cosineL: Double, cosineV: Double, alpha: Double): Double {
        val a2 = alpha * alpha
        fun half(cosine: Double) = Math.abs(cosine) + Math.sqrt(a2 + (1.0 - a2) * cosine * cosine)
        return 1.0 / (half(cosineL) * half(cosineV))
    }
}
