package dev.lazyz.cli.render

import dev.lazyz.Image
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImages
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputFile
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.aov.AovFormat
import dev.lazyz.scenes.aov.AovPicture
import dev.lazyz.scenes.writers.writePng
import java.nio.file.Path

/** A file for [aovs]. */
internal class AovOutput(val aovs: List<Aov>, val path: Path) {
    override fun toString(): String = "${aovs.joinToString(",") { it.id }}=$path"
}

/**
 * The files of arbitrary output variables: [data], and [pictures] with legends.
 */
internal class AovOutputs(private val data: List<AovOutput>, private val pictures: List<AovOutput>) {
    /** All that is to be computed. */
    val aovs: Set<Aov> = (data + pictures).flatMap { it.aovs }.toSet()

    /** The files, each with its option. */
    val files: List<Pair<String, Path>> =
        data.map { "$DATA $it" to it.path } + pictures.map { "$PICTURE $it" to it.path }

    /** Memory for each pixel of a picture. */
    val bytesPerPixel: Long = aovs.sumOf { Int.SIZE_BYTES * it.channels.size } + (if (pictures.isEmpty()) 0L else 12L)

    init {
        for (output in data) {
            OutputFile.check(output.path, DATA, AovFormat.entries.map { ".${it.id}" })
            val format = checkNotNull(AovFormat.ofPath(output.path))
            if (output.aovs.size > 1 && format != AovFormat.NPZ) {
                throw Mistake("$DATA: a .${format.id} file has room for one AOV; use .npz for several: ${output.path}")
            }
            for (aov in output.aovs) format.obstacle(aov)?.let { throw Mistake("$DATA ${aov.id}=${output.path}: $it") }
        }
        for (output in pictures) {
            OutputFile.check(output.path, PICTURE, listOf(".png"))
            if (output.aovs.size > 1) throw Mistake("$PICTURE: a picture shows one AOV; repeat the option for more")
        }
    }

    /** Writes all files. Each appears only when it is complete. */
    fun write(images: AovImages) {
        for (output in data) {
            try {
                AovFiles.write(output.path, output.aovs.map { images[it] })
            } catch (unfit: IllegalArgumentException) {
                throw Mistake(unfit.message.orEmpty())
            }
        }
        for (output in pictures) picture(images[output.aovs.single()]).writePng(output.path)
    }

    private fun picture(image: AovImage): Image = try {
        AovPicture.of(image)
    } catch (tooLarge: ArithmeticException) {
        throw Mistake("$PICTURE: ${image.width}x${image.height} with a legend are too many pixels; use a --region")
    }

    private companion object {
        const val DATA = "--aov"
        const val PICTURE = "--aov-picture"
    }
}
