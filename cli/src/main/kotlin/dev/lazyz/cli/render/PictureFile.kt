package dev.lazyz.cli.render

import dev.lazyz.Region
import dev.lazyz.RowSink
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.scenes.pictures.Blank
import dev.lazyz.scenes.pictures.PictureDrawing
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.PpmSink
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles
import dev.lazyz.scenes.writers.deepzoom.DeepZoomSink
import java.io.IOException
import java.nio.file.Path
import kotlin.io.path.extension

/** Writes pictures to files; a file appears when it is complete. */
internal object PictureFile {
    private const val GIGAPIXEL = 1e9
    private const val DRAWING = "svg"
    private const val PYRAMID = ".${DeepZoomFiles.EXTENSION}"

    /** What the names of pictures may end in. */
    val ENDINGS: List<String> = listOf(".png", ".ppm", PYRAMID, ".$DRAWING")

    /** Whether [path] names a Deep Zoom pyramid: a file and a folder. */
    fun isPyramid(path: Path): Boolean = path.extension.equals(DeepZoomFiles.EXTENSION, ignoreCase = true)

    /** Whether [path] names a drawing, whose lines are vectors. */
    fun isDrawing(path: Path): Boolean = path.extension.equals(DRAWING, ignoreCase = true)

    /** Returns what is replaced if a picture is written to [path]: the file, and the folder of a pyramid's tiles. */
    fun places(path: Path): List<Path> =
        if (isPyramid(path)) listOf(path, DeepZoomFiles.tiles(path)) else listOf(path)

    /**
     * Returns warnings about the file [path], or a PNG file on standard output if that is null, for the pixels of
     * [region] with this [alpha]: where alpha is lost, and where another kind of file is better.
     */
    fun warnings(path: Path?, region: Region, alpha: AlphaChannel): List<String> {
        if (path != null && isPyramid(path)) return emptyList()
        val isPpm = path != null && ImageFiles.formatOf(path) == ImageFormat.PPM
        return listOfNotNull(
            "a .ppm file has no alpha: what is transparent is written as opaque; use .png".takeIf {
                isPpm && alpha == AlphaChannel.KEEP
            },
            (
                "the picture has %.1f gigapixels, and few programs open one file of that size; -o NAME$PYRAMID makes " +
                    "a pyramid of tiles, of which a viewer in a browser loads what it shows"
                ).format(null, region.size / GIGAPIXEL).takeIf { region.size > GIGAPIXEL },
        )
    }

    /** Returns the memory for writing the pixels of [region] to [path], or as PNG to standard output if it is null. */
    fun memory(path: Path?, region: Region): Long = when {
        path == null -> PngSink.memory(region.width, region.height)
        isPyramid(path) -> DeepZoomSink.memory(region.width, region.height)
        ImageFiles.formatOf(path) == ImageFormat.PPM -> PpmSink.memory(region.width)
        else -> PngSink.memory(region.width, region.height)
    }

    /**
     * Calls [render] with a sink that writes the pixels of [region] to [path].
     *
     * @throws IOException if the file cannot be written; the message says which, why, and what to do
     */
    fun <T> write(path: Path, region: Region, alpha: AlphaChannel, render: (RowSink) -> T): T {
        if (isPyramid(path)) return DeepZoomFiles.write(path, region.width, region.height, alpha, render)
        return ImageFiles.write(path, region.width, region.height, alpha = alpha, produce = render)
    }

    /**
     * Writes [drawing] to [path]; a strategy of [choice] renders what is below the lines.
     *
     * @return why there is nothing to see, or null
     */
    fun write(path: Path, drawing: PictureDrawing, choice: StrategyChoice): Blank? {
        val below = drawing.picture ?: return drawing.writeSvg(path)
        val strategy = choice.strategyFor(below.frame)
        Strategies.requireMemory(strategy, below.frame.region, aa = below.factor)
        return drawing.writeSvg(path, strategy)
    }

    /**
     * Completes the pyramid [path] of the pixels of [region], which depends on [facts]. Calls [render] with a sink and
     * the rows that are missing.
     */
    fun <T> resume(
        path: Path,
        region: Region,
        alpha: AlphaChannel,
        facts: Map<String, String>,
        render: (RowSink, Region) -> T,
    ): T = DeepZoomFiles.resume(path, region.width, region.height, alpha, facts) { sink, first ->
        render(sink, region.rows(region.rowStart + first, region.rowEnd))
    }
}
