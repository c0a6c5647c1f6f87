package dev.lazyz.strategies.tiled.raster

/** Called often during a rendering. */
internal fun interface Checkpoint {
    /** Returns, or throws if the rendering is to end. */
    fun pass()
}
