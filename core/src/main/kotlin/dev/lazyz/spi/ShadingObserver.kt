package dev.lazyz.spi

/**
 * Observes the shading calls of a rendering: which samples are shaded, how often, and in which order. See
 * `Frame.observed`.
 *
 * It is called before a colour is computed, by the threads of the renderer, several at the same time if the renderer
 * uses several; so it must be thread safe, or the renderer be configured with one thread.
 */
public fun interface ShadingObserver {
    /** The primitive with the submission index [primitive] is about to be shaded at column [x] and row [y]. */
    public fun shading(x: Int, y: Int, primitive: Int)
}
