package dev.lazyz.cli.input

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SuperSampling

/** A [frame] of samples, and how they become pixels. */
internal class Shot(val frame: Frame, private val sampling: SuperSampling) {
    /** The pixels of the picture. */
    val region: Region = sampling.pixels(frame.region)

    /** Renders the frame with [strategy], and passes every row of pixels to [sink]. */
    fun render(strategy: Renderer, sink: RowSink): Counters = sampling.render(strategy, frame, sink)
}
