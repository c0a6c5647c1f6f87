package dev.lazyz.spark.models

import dev.lazyz.Rgba
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.PictureSettings
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.View
import java.io.Serializable

/**
 * What a picture of a model shows, written as words `name=value` with spaces or commas between them, for example
 * `size=256 view=iso aa=4`. The names and values are those of `zcli render`:
 *
 * | name | value | default |
 * |---|---|---|
 * | `size` | `WIDTHxHEIGHT`, or one number for a square, in pixels | 256 |
 * | `view` | a side, such as `front`, `top` or `iso` | see `azimuth` |
 * | `azimuth`, `elevation` | degrees | 30 and 20; a scene file is seen from its own camera |
 * | `zoom` | 0.001..1000 | 1 |
 * | `margin` | percent, 0..45 | 5 |
 * | `projection` | `perspective` or `orthographic` | `perspective` |
 * | `up` | the axis that points up: `x`, `-x`, `y`, `-y`, `z`, `-z` | that of the format |
 * | `aa` | 1, 2, 4 or 8: so many samples a pixel in each direction | 4, or 1 where necessary |
 * | `background` | a name of CSS, `transparent`, or hexadecimal digits | that of the model |
 * | `light` | `studio` or another arrangement of lights | that of the model |
 * | `light-intensity` | 0..1000 | 1, or more for dark materials |
 * | `format` | `obj`, `stl`, `ply`, `off`, `3mf`, `gltf`, `glb` or `scene` | by name, or by content |
 * | `output` | `png`, `pixels` or `depth`, or several joined by `+` | `png` |
 *
 * Immutable. Throws [IllegalArgumentException] if a word is not understood; the message says which.
 *
 * @property words the words as they were given
 */
public class PictureOptions(public val words: String) : Serializable {
    private val given: Map<String, String> = words.split(' ', ',').filter { it.isNotEmpty() }.associate { word ->
        val name = word.substringBefore('=')
        require('=' in word && name in NAMES) { "'$word' is not NAME=VALUE with a NAME of ${NAMES.joinToString()}" }
        name to word.substringAfter('=')
    }

    init {
        // Look at all words now, so that the driver reports mistakes and not each task
        format
        outputs
        settings()
    }

    internal val format: SceneFormat? get() = named("format", SceneFormat.entries) { it.id }
    private val outputs: Set<String>
        get() = (given["output"] ?: "png").split('+').onEach {
            require(it in OUTPUTS) { "output=$it is not one of ${OUTPUTS.joinToString()}" }
        }.toSet()

    internal fun has(output: String): Boolean = output in outputs

    internal fun settings(): PictureSettings {
        val size = size()
        val settings = PictureSettings(size.width, size.height)
            .withViewpoint(if (given.keys.none { it in VIEWS }) null else viewpoint())
            .withUp(named("up", UpAxis.entries) { it.id })
            .withLight(named("light", LightRig.entries, ::word))
            .withBackground(given["background"]?.let { color(it) })
            .withSampling(named("aa", listOf(1, 2, 4, 8)) { "$it" }?.let { SuperSampling(it) })
        val intensity = number("light-intensity", 0.0..1000.0) ?: return settings
        return settings.withLightIntensity(intensity.toFloat())
    }

    private fun size(): ImageSize {
        val sides = (given["size"] ?: USUAL_SIZE).lowercase().split('x').map { it.toIntOrNull() }
        require(sides.size in 1..2 && sides.all { it != null }) { "size=${given["size"]} is not WIDTHxHEIGHT" }
        return ImageSize(sides[0]!!, sides.last()!!)
    }

    private fun viewpoint(): FittedViewpoint {
        val view = named("view", View.entries, ::word)
        val usual = Camera.fit()
        return Camera.fit(
            number("azimuth", -1e6..1e6) ?: view?.azimuth ?: usual.azimuth,
            number("elevation", -90.0..90.0) ?: view?.elevation ?: usual.elevation,
            number("zoom", 0.001..1000.0) ?: usual.zoom,
            named("projection", Fit.entries, ::word) ?: usual.kind,
            number("margin", 0.0..45.0) ?: usual.margin,
        )
    }

    private fun <T : Any> named(name: String, values: List<T>, id: (T) -> String): T? {
        val text = given[name]?.lowercase() ?: return null
        return requireNotNull(values.firstOrNull { id(it) == text }) {
            "$name=$text is not one of ${values.joinToString { id(it) }}"
        }
    }

    private fun number(name: String, range: ClosedRange<Double>): Double? {
        val text = given[name] ?: return null
        val number = text.toDoubleOrNull()
        require(number != null && number in range) {
            "$name=$text must be a number in ${range.start}..${range.endInclusive}"
        }
        return number
    }

    override fun toString(): String = "PictureOptions($words)"

    public companion object {
        private const val serialVersionUID = 1L
        private const val USUAL_SIZE = "256"
        private val OUTPUTS = listOf("png", "pixels", "depth")

        /** The names of what a camera sees. Without one of them, a scene file is seen from its own camera. */
        private val VIEWS = listOf("view", "azimuth", "elevation", "zoom", "margin", "projection")
        private val NAMES = listOf("size") + VIEWS +
            listOf("up", "aa", "background", "light", "light-intensity", "format", "output")

        private fun color(text: String) =
            Rgba.parse(if (text.startsWith('#') || text.lowercase() in Rgba.names) text else "#$text")

        private fun word(constant: Enum<*>): String = constant.name.lowercase().replace('_', '-')
    }
}
