package dev.lazyz.server.render

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.PictureSettings
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.world.Camera
import dev.lazyz.world.Scene

/**
 * What a client wants to see of a model.
 *
 * @property format the format of the model, or null if its content decides
 */
internal class PictureRequest(val format: SceneFormat?, val settings: PictureSettings) {
    val width: Int get() = settings.size.width
    val pixels: Long get() = width.toLong() * settings.size.height

    /** Samples a pixel in each direction, at most. */
    val factor: Int get() = settings.sampling?.factor ?: PictureSettings.USUAL_FACTOR

    /** The samples that this picture has at most. */
    val samples: Long get() = pixels * factor * factor

    companion object {
        private val USUAL_SIZE = ImageSize(640, 480)
        private val USUAL_SAMPLING = SuperSampling(PictureSettings.USUAL_FACTOR)

        /** Shows what is possible for every model of a size: some have further obstacles. */
        private val NOTHING = Scene(emptyList())

        /** Characters of the longest value that has a meaning, and more. */
        private const val LONGEST = 100

        /** The characters of decimal numbers: with them, no other form of a number is possible. */
        private const val DECIMAL = "0123456789.+-eE"

        /**
         * Reads the parameters of a query; of several values of one, the last counts.
         *
         * @param mostPixels maximum pixels of a picture
         * @throws Problem if a name or a value is unknown
         */
        fun of(query: Map<String, List<String>>, mostPixels: Long): PictureRequest {
            val ids = Parameter.entries.associateBy { it.id }
            for (name in query.keys) {
                if (name !in ids) fail("there is no parameter '$name'; there are ${ids.keys.joinToString()}")
            }
            val given = query.mapKeys { ids.getValue(it.key) }.mapValues { it.value.last() }
            for ((parameter, value) in given) {
                if (value.length > LONGEST) fail("${parameter.id}: a value has at most $LONGEST characters")
            }
            val view = named(given, Parameter.VIEW, views)
            val usual = Camera.fit()
            val size = given[Parameter.SIZE]?.let { size(it, mostPixels) } ?: USUAL_SIZE
            val viewpoint = Camera.fit(
                number(given, Parameter.AZIMUTH, -1e6..1e6) ?: view?.azimuth ?: usual.azimuth,
                number(given, Parameter.ELEVATION, -90.0..90.0) ?: view?.elevation ?: usual.elevation,
                number(given, Parameter.ZOOM, 0.001..1000.0) ?: usual.zoom,
                named(given, Parameter.PROJECTION, projections) ?: usual.kind,
                number(given, Parameter.MARGIN, 0.0..45.0) ?: usual.margin,
            )
            val sampling = named(given, Parameter.AA, factors)?.let { SuperSampling(it) }
            val obstacle = (sampling ?: USUAL_SAMPLING).obstacle(NOTHING, Raster(size.width, size.height))
            if (sampling != null && obstacle != null) fail("aa: $obstacle; use aa=1")
            val settings = PictureSettings(size.width, size.height)
                .withViewpoint(viewpoint)
                .withUp(named(given, Parameter.UP, axes))
                .withLight(named(given, Parameter.LIGHT, lights))
                .withBackground(given[Parameter.BACKGROUND]?.let(::color))
                .withSampling(if (obstacle == null) sampling else SuperSampling.NONE)
            val intensity = number(given, Parameter.LIGHT_INTENSITY, 0.0..1000.0)?.toFloat()
            val lit = if (intensity == null) settings else settings.withLightIntensity(intensity)
            return PictureRequest(named(given, Parameter.FORMAT, formats), lit)
        }

        private fun <T : Any> named(given: Map<Parameter, String>, parameter: Parameter, values: Map<String, T>): T? {
            val text = given[parameter] ?: return null
            return values[text.lowercase()]
                ?: fail("${parameter.id}: '$text' is not one of ${values.keys.joinToString()}")
        }

        private fun number(
            given: Map<Parameter, String>,
            parameter: Parameter,
            range: ClosedRange<Double>,
        ): Double? {
            val text = given[parameter] ?: return null
            val number = if (text.all { it in DECIMAL }) text.toDoubleOrNull() else null
            if (number == null) fail("${parameter.id}: '$text' is not a number")
            if (number !in range) fail("${parameter.id} must be in ${range.start}..${range.endInclusive}: $text")
            return number
        }

        private fun size(text: String, mostPixels: Long): ImageSize {
            val words = text.lowercase().split('x')
            if (words.size > 2 || !words.all { it.length in 1..9 && it.all { digit -> digit in '0'..'9' } }) {
                fail("size: '$text' is not WIDTHxHEIGHT, such as 640x480, or one number for a square")
            }
            val width = words.first().toInt()
            val height = words.last().toInt()
            val sides = 1..Raster.MAX_SIDE
            if (width !in sides || height !in sides) fail("size: width and height must be in $sides: $text")
            if (width.toLong() * height > mostPixels) fail("size: a picture has at most $mostPixels pixels: $text")
            return ImageSize(width, height)
        }

        private fun color(text: String): Rgba = try {
            Rgba.parse(if (text.startsWith('#') || text.lowercase() in Rgba.names) text else "#$text")
        } catch (_: IllegalArgumentException) {
            fail("background: '$text' is not a colour: neither a name of CSS nor hexadecimal rgb, rrggbb or rrggbbaa")
        }

        private fun fail(message: String): Nothing = throw Problem(Problem.BAD_REQUEST, message)
    }
}
