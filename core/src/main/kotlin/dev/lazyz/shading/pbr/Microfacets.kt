package dev.lazyz.shading.pbr

import kotlin.math.sqrt

/**
 * The reflection of rough surfaces, with the distribution GGX: the functions D, V and F of glTF 2.0, appendix B.3, in
 * single precision.
 *
 * Sources: T. Trowbridge and K. Reitz, "Average Irregularity Representation of a Rough Surface for Ray Reflection",
 * 1975; E. Heitz, "Understanding the Masking-Shadowing Function in Microfacet-Based BRDFs", JCGT 3 (2014); C. Schlick,
 * "An Inexpensive BRDF Model for Physically-based Rendering", 1994.
 */
internal object Microfacets {
    /** Reflectance of dielectrics such as plastic and glass at normal incidence, appendix B.2.1. */
    const val DIELECTRIC: Float = 0.04f

    /** The smallest alpha: below it, the highlight of a point is too small and too bright for single precision. */
    private const val LEAST_ALPHA = 1f / 512f

    /** Returns alpha, the width of the distribution of microfacets, for a perceptual [roughness]. */
    fun alpha(roughness: Float): Float = maxOf(roughness * roughness, LEAST_ALPHA)

    /**
     * Returns pi times D, the distribution of Trowbridge and Reitz, also called GGX. [cosine] is N.H, and [sineSquare]
     * 1 - (N.H)^2, computed without cancellation; a2 is alpha squared.
     */
    fun distribution(cosine: Float, sineSquare: Float, a2: Float): Float {
        // (N.H)^2 (a2 - 1) + 1, rearranged
        val width = cosine * cosine * a2 + sineSquare
        return a2 / (width * width)
    }

    /** Returns V, Smith's masking and shadowing divided by 4 N.L N.V. */
    fun visibility(cosineL: Float, cosineV: Float, a2: Float): Float {
        val light = cosineL + sqrt(a2 + (1f - a2) * (cosineL * cosineL))
        val view = cosineV + sqrt(a2 + (1f - a2) * (cosineV * cosineV))
        return 1f / (light * view)
    }

    /** Returns pi times D * V for N.L above 0, or 0 where the halfway vector is behind the surface. */
    fun lobe(cosineH: Float, sineSquare: Float, cosineL: Float, cosineV: Float, a2: Float): Float =
        if (cosineH > 0f) distribution(cosineH, sineSquare, a2) * visibility(cosineL, cosineV, a2) else 0f

    /** Returns `(1 - cosine)^5`, the part of Schlick's Fresnel reflectance that rises to 1 at grazing angles. */
    fun grazing(cosine: Float): Float = fifth(if (cosine < 1f) 1f - cosine else 0f)

    /** Returns the fifth power of [x]. */
    fun fifth(x: Float): Float {
        val square = x * x
        return square * square * x
    }
}
