package dev.lazyz.server.render

import dev.lazyz.Raster
import dev.lazyz.aov.Aov
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.pictures.NamedValues
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.writers.animation.Animation
import dev.lazyz.world.Scene
import dev.lazyz.world.View

/**
 * What a client wants to see of a model.
 *
 * @property model the name of the model in an archive, or null for the only one
 * @property aovs the data of pixels that it wants in place of the picture, or none
 * @property steps pictures of a turn around the model, or null if it wants one picture
 * @property framesPerSecond the speed of the turn
 * @property views the sides of the cells of a contact sheet, or none
 */
internal class PictureRequest private constructor(
    val settings: PictureSettings,
    val model: String?,
    val aovs: Set<Aov>,
    val steps: Int?,
    val framesPerSecond: Int,
    val views: List<View>,
) {
    /** The number of pictures. */
    val frames: Int get() = steps ?: maxOf(views.size, 1)

    /** Returns the settings of the cell [number] of a contact sheet, made of [settings], or these if there is none. */
    fun settings(settings: PictureSettings, number: Int): PictureSettings =
        views.getOrNull(number)?.let(settings::seenFrom) ?: settings

    /** The format of the model, or null if its content decides. */
    val format: SceneFormat? get() = settings[PictureParameters.FORMAT]
    val width: Int get() = settings.size.width

    /** The pixels of all whole pictures, also if only parts are rendered. */
    val pixels: Long get() = width.toLong() * settings.size.height * frames

    /** Samples a pixel in each direction, at most. */
    val factor: Int get() = settings.factor

    companion object {
        /** Shows what is possible for every model of a size: some have further obstacles. */
        private val NOTHING = Scene(emptyList())

        /** Characters of the longest value that has a meaning, and more; of names in an archive, the most. */
        private const val LONGEST = 100
        private const val LONGEST_FILE = 250
        private val FILES = setOf("model", PictureParameters.TEXTURE.name, PictureParameters.MATCAP.name)

        /** Parameters beside those of pictures, each with its form and what it does. */
        val OWN: Map<String, Pair<String, String>> = mapOf(
            "model" to ("NAME" to "The model in an archive; default: the only one"),
            "aov" to ("AOV,AOV" to "Answer with data of pixels in place of the picture, a .npz file"),
            "turntable" to ("N" to "Answer with an animated PNG of a turn in N steps, 2..3600"),
            "views" to ("SIDE,SIDE" to "Answer with one picture with a view from each of these sides"),
            "frames-per-second" to (
                "N" to "Speed of the turn, 1..${Animation.MAX_FRAMES_PER_SECOND}; default: " +
                    "${Animation.DEFAULT_FRAMES_PER_SECOND}"
                ),
        )

        /** What can be asked for: the other depends on the strategy, and takes a second rendering. */
        private val AOVS = NamedValues("AOV", (Aov.entries - Aov.SHADING_CALLS).associateBy { it.id })
        private val VIEWS = NamedValues("SIDE", NamedValues.words(View.entries))

        /** As for `zcli`. */
        private val STEPS = 2..3600

        /**
         * Reads the parameters of a query; of several values of one, the last counts, except planes that cut.
         *
         * @param mostPixels maximum pixels of all pictures
         * @throws Problem if a name or a value is unknown
         */
        fun of(query: Map<String, List<String>>, mostPixels: Long): PictureRequest {
            for ((name, values) in query) {
                val most = if (name in FILES) LONGEST_FILE else LONGEST
                if (values.any { it.length > most }) fail("$name: a value has at most $most characters")
            }
            val words = (query - OWN.keys).flatMap { (name, values) -> values.map { name to it } }
            val settings = try {
                PictureDoor.SERVICE.read(PictureSettings(), words).also { it.check() }
            } catch (e: IllegalArgumentException) {
                fail(e.message.orEmpty())
            }
            if (settings[PictureParameters.FORMAT] == SceneFormat.SCENE) fail("format: a scene is no model")
            val size = settings.size
            val obstacle = SuperSampling(settings.factor).obstacle(NOTHING, Raster(size.width, size.height))
            if (obstacle != null && settings[PictureParameters.AA] != null) fail("aa: $obstacle; use aa=1")
            val own = if (obstacle == null) settings else settings.with(PictureParameters.AA, 1)
            val steps = number(query, "turntable", STEPS)
            val speed = number(query, "frames-per-second", 1..Animation.MAX_FRAMES_PER_SECOND)
            val request = PictureRequest(
                own, query["model"]?.last(), words(query, "aov", AOVS).toSet(), steps,
                speed ?: Animation.DEFAULT_FRAMES_PER_SECOND, words(query, "views", VIEWS),
            )
            val answers = listOf("aov", "turntable", "views").filter { it in query }
            if (answers.size > 1) fail("${answers[0]} cannot be combined with ${answers[1]}")
            if (request.views.isNotEmpty()) settings.directed?.let { fail("views cannot be combined with $it") }
            if (steps != null) settings.placed?.let { fail("turntable cannot be combined with $it") }
            if (steps == null && speed != null) fail("frames-per-second needs turntable")
            if (request.pixels > mostPixels) {
                fail("size: at most $mostPixels pixels in all: $size, ${request.frames} times")
            }
            return request
        }

        /** Returns the values that the words of a parameter mean, separated by commas, each once. */
        private fun <T : Any> words(query: Map<String, List<String>>, name: String, values: NamedValues<T>): List<T> =
            try {
                query[name]?.last()?.split(',')?.map(values::read).orEmpty().distinct()
            } catch (e: IllegalArgumentException) {
                fail("$name: ${e.message}")
            }

        private fun number(query: Map<String, List<String>>, name: String, range: IntRange): Int? {
            val word = query[name]?.last() ?: return null
            return word.toIntOrNull()?.takeIf { it in range } ?: fail("$name: '$word' is no whole number in $range")
        }

        private fun fail(message: String): Nothing = throw Problem(Problem.BAD_REQUEST, message)
    }
}
