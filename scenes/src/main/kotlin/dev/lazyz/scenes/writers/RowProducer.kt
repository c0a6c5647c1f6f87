package dev.lazyz.scenes.writers

import dev.lazyz.RowSink
import java.io.IOException

/** Produces the rows of an image, for example by rendering: `sink -> renderer.render(frame, sink)`. */
public fun interface RowProducer<R> {
    /**
     * Passes every row to [sink], from the top.
     *
     * @return any result, for example the counters of the rendering
     * @throws IOException if the sink throws it
     * @throws InterruptedException if the rendering is interrupted
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun sendTo(sink: RowSink): R
}
