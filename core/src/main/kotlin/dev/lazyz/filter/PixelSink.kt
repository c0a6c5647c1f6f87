package dev.lazyz.filter

/** Receives the samples of pixels whose primitives are shaded once a pixel, one row of pixels after the other. */
internal interface PixelSink {
    /** Takes the depths and primitives of row [y] of samples, which are valid during this call only. */
    fun samples(y: Int, depth: IntArray, primitive: IntArray)

    /** Takes the pixels from column [start] until [end], whose samples all have the colour [color], `0xAARRGGBB`. */
    fun even(start: Int, end: Int, color: Int)

    /** Takes the pixel in column [x], whose samples have these [colors], row by row. Valid during this call only. */
    fun mixed(x: Int, colors: IntArray)

    /** Ends row [y] of pixels: all of its samples and pixels were passed. */
    fun end(y: Int)
}
