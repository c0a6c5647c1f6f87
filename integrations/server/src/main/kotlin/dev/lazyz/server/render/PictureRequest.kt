package dev.lazyz.server.render

import dev.lazyz.Raster
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.outputs.PictureOutput
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.Scene

/**
 * What a client wants to see of a model.
 *
 * @property model the name of the model in an archive, or null for the only one
 * @property output what the answer is
 */
internal class PictureRequest private constructor(
    val settings: PictureSettings,
    val model: String?,
    val output: PictureOutput,
) {
    /** The format of the model, or null if its content decides. */
    val format: SceneFormat? get() = settings[PictureParameters.FORMAT]
    val width: Int get() = settings.size.width

    /** The pixels of all whole pictures, also if only parts are rendered. */
    val pixels: Long get() = width.toLong() * settings.size.height * output.frames

    /** Samples a pixel in each direction, at most. */
    val factor: Int get() = settings.factor

    companion object {
        /** Shows what is possible for every model of a size: some have further obstacles. */
        private val NOTHING = Scene(emptyList())

        /** Characters of the longest value that has a meaning, and more; of names in an archive, the most. */
        private const val LONGEST = 100
        private const val LONGEST_FILE = 250
        private val FILES = PictureSettings.FILES.map { it.name } + "model"

        /** Parameters beside those of pictures, each with its form and what it does. */
        val OWN: Map<String, Pair<String, String>> =
            mapOf("model" to ("NAME" to "The model in an archive; default: the only one")) +
                PictureOutput.WORDS.mapValues { it.value.form to it.value.help }

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
            val settings = read { PictureDoor.SERVICE.read(PictureSettings(), words).also { it.check() } }
            if (settings[PictureParameters.FORMAT] == SceneFormat.SCENE) fail("format: a scene is no model")
            val size = settings.size
            val obstacle = SuperSampling(settings.factor).obstacle(NOTHING, Raster(size.width, size.height))
            if (obstacle != null && settings[PictureParameters.AA] != null) fail("aa: $obstacle; use aa=1")
            val own = if (obstacle == null) settings else settings.with(PictureParameters.AA, 1)
            val chosen = (query - "model").filterKeys(OWN::containsKey).mapValues { it.value.last() }
            val output = read { PictureOutput.read(chosen, settings) }
            val request = PictureRequest(own, query["model"]?.last(), output)
            if (request.pixels > mostPixels) {
                fail("size: at most $mostPixels pixels in all: $size, ${output.frames} times")
            }
            return request
        }

        private fun <T> read(reader: () -> T): T = try {
            reader()
        } catch (e: IllegalArgumentException) {
            fail(e.message.orEmpty())
        }

        private fun fail(message: String): Nothing = throw Problem(Problem.BAD_REQUEST, message)
    }
}
