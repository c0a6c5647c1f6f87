package dev.lazyz.scenes.outputs

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.Image.PixelHash
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.aov.Aov
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.aov.AovFiles
import dev.lazyz.scenes.pictures.Blank
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.pictures.VisibleRows
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.scenes.writers.animation.ApngSink
import dev.lazyz.world.camera.FittedViewpoint.View
import java.io.IOException
import java.io.OutputStream

/**
 * What one file shows of a model: a picture, data of its pixels, a turn, or several views. The service and Spark make
 * their answers with it. Immutable.
 *
 * ```
 * val output = PictureOutput.read(mapOf("turntable" to "36"), settings)
 * val writer = output.writer(stream, settings, loaded)
 * for (number in 0 until output.frames) writer.add(writer.frame(number), TiledRenderer())
 * ```
 *
 * @property aovs the data of pixels in place of a picture, a `.npz` file, or none
 * @property steps pictures of a turn around the model, an animated PNG, or null
 * @property framesPerSecond the speed of the turn
 * @property views the sides of the cells of a contact sheet, or none
 */
public class PictureOutput private constructor(
    public val aovs: Set<Aov>,
    public val steps: Int?,
    public val framesPerSecond: Int,
    public val views: List<View>,
) {
    /** The number of pictures that are rendered. */
    public val frames: Int get() = steps ?: maxOf(views.size, 1)

    /** The media type of the file. */
    public val mediaType: String
        get() = when {
            aovs.isNotEmpty() -> "application/zip"
            steps != null -> "image/apng"
            else -> "image/png"
        }

    /** Returns what writes this output of [loaded] to [file], which the last picture closes. */
    public fun writer(file: OutputStream, settings: PictureSettings, loaded: LoadedScene): Writer =
        Writer(this, file, settings, loaded)

    override fun toString(): String = "PictureOutput($frames frames, $mediaType)"

    /** Renders the pictures of an output, one after the other, and writes them. Not thread safe. */
    public class Writer internal constructor(
        /** What is written. */
        public val output: PictureOutput,
        private val file: OutputStream,
        private val settings: PictureSettings,
        private val loaded: LoadedScene,
    ) {
        private val turntable = output.steps?.let { settings.turntable(loaded, it) }
        private val sheet = ContactSheet.of(settings, output.views.map { it.name.lowercase() })
        private val pixels = PixelHash()
        private lateinit var rows: VisibleRows
        private var animation: ApngSink? = null
        private var added = 0

        /** The size of each picture, as soon as one is added. */
        public lateinit var size: ImageSize
            private set

        /** The work of all pictures. */
        public var counters: Counters = Counters.NONE
            private set

        /** Whether a part of the model is outside a picture. */
        public var isCropped: Boolean = false
            private set

        /** Why there is nothing to see in any picture, or null. */
        public val blank: Blank? get() = rows.blank

        /** The pixel hash of all pictures together (contract rule 7.2). */
        public val hash: String by lazy { pixels.digest() }

        /**
         * Sets up the picture with this number, of which [PictureOutput.frames] says how many there are. Throws like
         * [PictureSettings.frame].
         */
        @JvmOverloads
        @Throws(InterruptedException::class)
        public fun frame(
            number: Int,
            options: RenderOptions = RenderOptions(),
            observer: PictureObserver = PictureObserver(),
        ): PictureFrame {
            val seen = output.views.getOrNull(number)?.let(settings::seenFrom) ?: settings
            return turntable?.frame(number, options, observer) ?: seen.frame(loaded, options, observer)
        }

        /** Renders [frame], which is the next picture, and writes it. Throws like [PictureFrame.render]. */
        @Throws(InterruptedException::class, IOException::class)
        public fun add(frame: PictureFrame, renderer: Renderer) {
            val (width, height) = frame.pixels.run { width to height }
            if (added == 0) {
                rows = VisibleRows(width)
                size = ImageSize(width, height)
            }
            val isLast = ++added == output.frames
            isCropped = isCropped || frame.isCropped
            val counted = when {
                output.aovs.isNotEmpty() -> {
                    val aovs = frame.render(renderer, seen(width) { _, _, _, _ -> }, output.aovs)
                    AovFiles.writeArchive(file, aovs.images)
                    aovs.counters
                }

                turntable != null -> {
                    val shape = Animation(width, height, output.frames, output.framesPerSecond, frame.alpha)
                    val sink = animation ?: ApngSink(file, shape).also { animation = it }
                    frame.render(renderer, seen(width, sink)).also { if (isLast) sink.close() }
                }

                output.views.isNotEmpty() -> {
                    val cell = Image.Collector(frame.pixels)
                    val counters = frame.render(renderer, seen(width, cell))
                    sheet.put(added - 1, cell.toImage(counters).argb)
                    if (isLast) sheet.write(file)
                    counters
                }

                else -> PngSink(file, width, height, frame.alpha).use { frame.render(renderer, seen(width, it)) }
            }
            counters = counters.plus(counted)
        }

        private fun seen(width: Int, sink: RowSink) = RowSink { y, argb, depth, primitive ->
            pixels.add(argb, width)
            rows.row(y, argb, depth, primitive)
            sink.row(y, argb, depth, primitive)
        }
    }

    /**
     * The words that choose an output.
     *
     * @property id the name
     * @property form what its value looks like
     * @property help a sentence about what it does
     */
    public enum class Word(public val id: String, public val form: String, public val help: String) {
        AOV("aov", "AOV,AOV", "Data of pixels in place of the picture, a .npz file"),
        TURNTABLE("turntable", "N", "An animated PNG of a turn in N steps, 2..$MAX_STEPS"),
        VIEWS("views", "SIDE,SIDE", "One picture with a view from each of these sides"),
        SPEED(
            "frames-per-second", "N",
            "Speed of the turn, 1..${Animation.MAX_FRAMES_PER_SECOND}; default: ${Animation.DEFAULT_FRAMES_PER_SECOND}",
        ),
    }

    public companion object {
        /** All [Word]s by their [Word.id]. */
        @JvmField
        public val WORDS: Map<String, Word> = Word.entries.associateBy { it.id }

        /** What can be asked for: the other depends on the strategy, and takes a second rendering. */
        private val AOVS = NamedValues("AOV", (Aov.entries - Aov.SHADING_CALLS).associateBy { it.id })
        private val VIEWS = NamedValues("SIDE", NamedValues.words(View.entries))

        /** Most pictures of a turn. */
        public const val MAX_STEPS: Int = 3600

        /**
         * Returns the output that [words] describe, the names of which are in [WORDS], of pictures with [settings].
         *
         * @throws IllegalArgumentException if a value is unknown, or two words exclude each other, or the settings; the
         *   message is for the user
         */
        @JvmStatic
        public fun read(words: Map<String, String>, settings: PictureSettings): PictureOutput {
            val (aov, turntable, views, speed) = Word.entries.map { word -> words[word.id]?.let { word to it } }
            val output = PictureOutput(
                aov?.list(AOVS).orEmpty().toSet(), turntable?.number(2..MAX_STEPS),
                speed?.number(1..Animation.MAX_FRAMES_PER_SECOND) ?: Animation.DEFAULT_FRAMES_PER_SECOND,
                views?.list(VIEWS).orEmpty(),
            )
            val kinds = listOfNotNull(aov, turntable, views).map { it.first.id }
            require(kinds.size <= 1) { "${kinds[0]} cannot be combined with ${kinds[1]}" }
            val choice = if (views != null) settings.directed else settings.placed.takeIf { turntable != null }
            require(choice == null) { "${kinds[0]} cannot be combined with $choice" }
            require(turntable != null || speed == null) { "${Word.SPEED.id} needs ${Word.TURNTABLE.id}" }
            return output
        }

        /** Returns the values that the words mean, separated by commas, each once. */
        private fun <T : Any> Pair<Word, String>.list(values: NamedValues<T>): List<T> = try {
            second.split(',').map(values::read).distinct()
        } catch (e: IllegalArgumentException) {
            throw IllegalArgumentException("${first.id}: ${e.message}", e)
        }

        private fun Pair<Word, String>.number(range: IntRange): Int = requireNotNull(
            second.toIntOrNull()?.takeIf { it in range },
        ) { "${first.id}: '$second' is no whole number in $range" }
    }
}
