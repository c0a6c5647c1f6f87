package dev.lazyz.scenes.writers.animation

import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.AtomicFile
import dev.lazyz.scenes.writers.RowProducer
import java.io.IOException
import java.nio.channels.Channels
import java.nio.file.Path

/** Writes animations to files. A file appears only when it is complete, as with `ImageFiles`. */
public object AnimationFiles {
    /**
     * Writes the frames that [produce] renders to a file at [path].
     *
     * Memory: see [ApngSink] and [GifSink].
     *
     * @param format the file format; by default determined by the file name extension
     * @param produce passes the rows of all frames to the sink that it is given: one frame after the other, each from
     *   the top
     * @return what [produce] returns
     * @throws IllegalArgumentException if [format] is omitted and the extension is unknown
     * @throws IOException if the file cannot be written, or a row is missing; the message says why
     * @throws InterruptedException if the thread is interrupted while it renders or writes
     */
    @JvmStatic
    @JvmOverloads
    @Throws(InterruptedException::class, IOException::class)
    public fun <R> write(
        path: Path,
        animation: Animation,
        format: AnimationFormat = formatOf(path),
        produce: RowProducer<R>,
    ): R = AtomicFile.rendering {
        AtomicFile.write(path) { channel ->
            val output = Channels.newOutputStream(channel)
            when (format) {
                AnimationFormat.APNG -> ApngSink(output, animation).use { produce.sendTo(it) }
                AnimationFormat.GIF -> GifSink(output, animation).use { produce.sendTo(it) }
            }
        }
    }

    /**
     * Returns the format for the file name extension of [path].
     *
     * @throws IllegalArgumentException if the extension is unknown
     */
    @JvmStatic
    public fun formatOf(path: Path): AnimationFormat = requireNotNull(AnimationFormat.ofFileName(path.toString())) {
        val known = AnimationFormat.entries.flatMap { it.extensions }.joinToString { ".$it" }
        "cannot tell the format of $path: it must end in one of $known"
    }
}

/**
 * The file formats that an animation can be written to.
 *
 * @property id lower-case name
 * @property extensions file name extensions, lower case, without a dot
 */
public enum class AnimationFormat(public val id: String, public val extensions: List<String>) {
    /** Animated PNG: all colours and alpha, lossless, see [ApngSink]. */
    APNG("apng", listOf("apng", "png")),

    /** GIF: 256 colours for all frames, pixels opaque or transparent, see [GifSink]. */
    GIF("gif", listOf("gif")),
    ;

    /** Returns why a file of this format cannot have frames of [width] x [height] pixels, or null if it can. */
    public fun obstacle(width: Int, height: Int): String? = when {
        this != GIF -> null
        maxOf(width, height) > MAX_GIF_SIDE -> "a GIF has at most $MAX_GIF_SIDE columns and rows: ${width}x$height"
        width.toLong() * height > MAX_GIF_PIXELS -> "a GIF frame has at most $MAX_GIF_PIXELS pixels: ${width}x$height"
        else -> null
    }

    public companion object {
        private const val MAX_GIF_SIDE = 0xFFFF

        /** A frame is in an array. */
        private const val MAX_GIF_PIXELS = Int.MAX_VALUE - 8L

        /** Returns the format that a file name's extension belongs to, or null. */
        @JvmStatic
        public fun ofFileName(name: String): AnimationFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}

/**
 * The shape of an animation, which is repeated without end. Immutable.
 *
 * @property width columns of each frame
 * @property height rows of each frame
 * @property frames number of frames, at least 1
 * @property framesPerSecond how many frames are shown in a second, 1..50
 * @property alpha whether pixels can be transparent
 * @throws IllegalArgumentException if a number is out of range
 */
public class Animation @JvmOverloads constructor(
    public val width: Int,
    public val height: Int,
    public val frames: Int,
    public val framesPerSecond: Int = DEFAULT_FRAMES_PER_SECOND,
    public val alpha: AlphaChannel = AlphaChannel.KEEP,
) {
    init {
        require(width > 0 && height > 0) { "a frame must have at least one pixel: $width x $height" }
        require(frames > 0) { "there must be at least one frame: $frames" }
        require(framesPerSecond in 1..MAX_FRAMES_PER_SECOND) {
            "framesPerSecond must be in 1..$MAX_FRAMES_PER_SECOND: $framesPerSecond"
        }
    }

    override fun toString(): String = "Animation($width x $height, $frames frames, $framesPerSecond per second, $alpha)"

    public companion object {
        /** The default of [framesPerSecond]. */
        public const val DEFAULT_FRAMES_PER_SECOND: Int = 12

        /** The greatest [framesPerSecond]: browsers show GIF frames for at least 0.02 seconds. */
        public const val MAX_FRAMES_PER_SECOND: Int = 50
    }
}
