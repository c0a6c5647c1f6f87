package dev.lazyz.cli.render

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.cli.output.Mistake
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import java.io.IOException
import java.nio.file.Path

/** Writes pictures to files; a file appears when it is complete. */
internal object PictureFile {
    /**
     * Calls [render] with a sink that writes the pixels of [region] to [path].
     *
     * @throws Mistake if the file cannot be written
     */
    fun <T> write(path: Path, region: Region, alpha: AlphaChannel, render: (RowSink) -> T): T =
        ImageFiles.write(path, region.width, region.height, alpha = alpha) { sink ->
            render(PathReportingSink(path, sink))
        }
}

/** Adds the path of the file to the message if writing fails. */
internal class PathReportingSink(private val path: Path, private val sink: RowSink) : RowSink {
    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        try {
            sink.row(y, argb, depth, primitive)
        } catch (failure: IOException) {
            throw Mistake("cannot write $path: ${failure.message}")
        }
    }
}
