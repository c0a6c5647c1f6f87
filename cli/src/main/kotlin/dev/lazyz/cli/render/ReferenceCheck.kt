package dev.lazyz.cli.render

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.cli.diff.writeMarked
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputTemplate
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureDifference
import java.nio.file.Files
import java.nio.file.Path

/**
 * Compares a picture with the reference of [request], which is read at once.
 *
 * @throws Mistake if there is no reference; the message has the command that creates it
 */
internal class ReferenceCheck(private val request: ReferenceRequest) {
    private val reference = if (Files.exists(request.file)) {
        Picture.read(request.file)
    } else {
        throw Mistake("there is no reference ${request.file}; create it with\n${request.creation}")
    }

    /** Memory for a pixel of the picture that is compared, and of the picture of the differences. */
    val bytesPerPixel: Long = if (request.diff == null) BYTES else BYTES + DIFF_BYTES

    /** Compares [colors], after all rows have arrived, and writes the picture of the differences. */
    fun compare(colors: ColorRows): PictureDifference {
        val difference = PictureDifference.between(reference, colors.toPicture(), request.threshold)
        request.diff?.let { difference.writeMarked(it) }
        return difference
    }

    private companion object {
        const val BYTES = 4L
        const val DIFF_BYTES = 12L
    }
}

/** Keeps the colours of the pixels of [region]. */
internal class ColorRows(private val region: Region) : RowSink {
    /** The colours in rows from the top, `0xAARRGGBB`. */
    val argb = IntArray(Math.toIntExact(region.size))

    override fun row(y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) {
        argb.copyInto(this.argb, (y - region.rowStart) * region.width, 0, region.width)
    }

    /** Returns the colours, without copying them. */
    fun toPicture(): Picture = Picture.ofArgb(region.width, region.height, argb)
}

/**
 * With what `zcli render` compares the picture.
 *
 * @property file the reference, an image file
 * @property threshold the greatest difference of a channel that is accepted, 0..255
 * @property diff the file for a picture of the differences, or null
 * @param args the words of the command line
 */
internal class ReferenceRequest(
    val file: Path,
    val threshold: Double,
    val diff: Path?,
    private val args: List<String>,
) {
    /** The command that renders the same picture to [file]. */
    val creation: String
        get() {
            val kept = CommandLine.without(args, setOf("-o", "--output", "--ref", "--ref-threshold", "--diff"))
            return CommandLine.of(kept.take(1) + listOf("-o", OutputTemplate.of("$file")) + kept.drop(1))
        }
}
