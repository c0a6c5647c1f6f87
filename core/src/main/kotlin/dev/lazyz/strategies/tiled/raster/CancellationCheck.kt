package dev.lazyz.strategies.tiled.raster

/** Called frequently during a rendering. */
internal fun interface CancellationCheck {
    /** Throws an exception if the rendering must end. */
    fun pass()
}
