package dev.lazyz.filter

/** How often a primitive is shaded with several samples a pixel. */
public enum class ShadingRate {
    /** At every visible sample. */
    SAMPLE,

    /**
     * Once for each primitive that is visible in a pixel, at its visible sample that is nearest to the pixel's centre.
     * The edges of primitives are as smooth as with [SAMPLE]; highlights are not. Textures with a `MipFilter` are read
     * with the footprint of a pixel, as with one sample a pixel. For expensive shaders.
     */
    PIXEL,
}
