package dev.lazyz.shading.pbr

/**
 * A metallic-roughness material at one point, as [SIZE] numbers in an array, and scratch memory for its light: colour
 * of diffuse reflection from [DIFFUSE] on, reflectance at normal incidence from [REFLECTANCE] on, perceptual roughness
 * at [ROUGHNESS]; radiance from [RADIANCE] on and irradiance from [IRRADIANCE] on; reflectance at grazing incidence at
 * [GRAZING]. What follows is set for materials with lobes only: the colour of sheen from [SHEEN] on and its roughness,
 * the strength, roughness and normal of a clear coat from [COAT] on, the part of light that passes in each colour from
 * [TRANSMITTED] on, and that of all light, at [PASSED]; the strength, index and thickness of a thin film from [FILM]
 * on; the strength of anisotropy at [ANISOTROPY], and its direction and the one across it from [ALONG] and [ACROSS] on.
 */
internal object PhysicalSurface {
    const val DIFFUSE: Int = 0
    const val REFLECTANCE: Int = 3
    const val ROUGHNESS: Int = 6
    const val RADIANCE: Int = 7
    const val IRRADIANCE: Int = 10
    const val GRAZING: Int = 13
    const val SHEEN: Int = 14
    const val SHEEN_ROUGHNESS: Int = 17
    const val COAT: Int = 18
    const val COAT_ROUGHNESS: Int = 19
    const val COAT_NORMAL: Int = 20
    const val TRANSMITTED: Int = 23
    const val PASSED: Int = 26
    const val FILM: Int = 27
    const val ANISOTROPY: Int = 30
    const val ALONG: Int = 31
    const val ACROSS: Int = 34
    const val SIZE: Int = 37

    /** Sets the material in [surface]: glTF 2.0, appendix B.3.5. */
    fun set(surface: FloatArray, red: Float, green: Float, blue: Float, metallic: Float, roughness: Float) {
        set(surface, 0, red, metallic)
        set(surface, 1, green, metallic)
        set(surface, 2, blue, metallic)
        surface[ROUGHNESS] = roughness
        surface[GRAZING] = 1f
    }

    private fun set(surface: FloatArray, channel: Int, color: Float, metallic: Float) {
        surface[DIFFUSE + channel] = diffuse(color, metallic)
        surface[REFLECTANCE + channel] = reflectance(color, metallic)
    }

    /** Returns the colour of diffuse reflection, in one channel. */
    fun diffuse(color: Float, metallic: Float): Float = color * (1f - metallic)

    /** Returns the reflectance at normal incidence, in one channel. */
    fun reflectance(color: Float, metallic: Float): Float =
        Microfacets.DIELECTRIC * (1f - metallic) + color * metallic
}
