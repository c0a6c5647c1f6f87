package dev.lazyz.server.render

import dev.lazyz.Raster
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.Scene

/** What a client wants to see of a model. */
internal class PictureRequest private constructor(
    val settings: PictureSettings,

    /** The name of the model in an archive, or null for the only one. */
    val model: String?,
) {
    /** The format of the model, or null if its content decides. */
    val format: SceneFormat? get() = settings[PictureParameters.FORMAT]
    val width: Int get() = settings.size.width

    /** The pixels of the whole picture, also if only a part is rendered. */
    val pixels: Long get() = width.toLong() * settings.size.height

    /** Samples a pixel in each direction, at most. */
    val factor: Int get() = settings.factor

    /** The samples that this picture has at most. */
    val samples: Long get() = pixels * factor * factor

    companion object {
        /** Shows what is possible for every model of a size: some have further obstacles. */
        private val NOTHING = Scene(emptyList())

        /** The parameter beside those of pictures. */
        const val MODEL: String = "model"

        /** Characters of the longest value that has a meaning, and more. */
        private const val LONGEST = 100

        /**
         * Reads the parameters of a query; of several values of one, the last counts, except planes that cut.
         *
         * @param mostPixels maximum pixels of a picture
         * @throws Problem if a name or a value is unknown
         */
        fun of(query: Map<String, List<String>>, mostPixels: Long): PictureRequest {
            for ((name, values) in query) {
                if (values.any { it.length > LONGEST }) fail("$name: a value has at most $LONGEST characters")
            }
            val words = (query - MODEL).flatMap { (name, values) -> values.map { name to it } }
            val settings = try {
                PictureDoor.SERVICE.read(PictureSettings(), words).also { it.check() }
            } catch (e: IllegalArgumentException) {
                fail(e.message.orEmpty())
            }
            if (settings[PictureParameters.FORMAT] == SceneFormat.SCENE) fail("format: a scene is no model")
            val size = settings.size
            if (size.width.toLong() * size.height > mostPixels) {
                fail("size: a picture has at most $mostPixels pixels: $size")
            }
            val obstacle = SuperSampling(settings.factor).obstacle(NOTHING, Raster(size.width, size.height))
            if (obstacle != null && settings[PictureParameters.AA] != null) fail("aa: $obstacle; use aa=1")
            val own = if (obstacle == null) settings else settings.with(PictureParameters.AA, 1)
            return PictureRequest(own, query[MODEL]?.last())
        }

        private fun fail(message: String): Nothing = throw Problem(Problem.BAD_REQUEST, message)
    }
}
