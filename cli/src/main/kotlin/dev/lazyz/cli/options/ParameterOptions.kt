package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.OptionDelegate
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.multiple
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.ParameterNames
import dev.lazyz.scenes.pictures.PictureParameter
import dev.lazyz.scenes.pictures.PictureSettings

/**
 * The options of a [group] of parameters of pictures, which `PictureParameters` lists.
 *
 * @param defaults what the help says of defaults that are others for this command
 */
internal open class ParameterOptions(
    group: ParameterGroup,
    private val defaults: Map<PictureParameter<*>, String> = emptyMap(),
) : OptionGroup(group.title) {
    private val options = group.parameters.map { it to registered(it) }

    /** Registers an option for [parameter]. Its value is a list of all words that were given, which mean something. */
    private fun registered(parameter: PictureParameter<*>): OptionDelegate<List<String>> {
        val help = parameter.text(default = defaults[parameter] ?: parameter.default)
        val raw = option("--${parameter.name}", help = help)
        val values = parameter.values
        val words = if (values.form == null) {
            raw.flag().convert { if (it) listOf("true") else emptyList() }
        } else {
            raw.convert(values.form.orEmpty(), Completions.of(values)) { word ->
                word.also { values.read(it) }
            }.multiple()
        }
        registerOption(words)
        return words
    }

    /** Returns [settings] with what these options choose. */
    fun addTo(settings: PictureSettings): PictureSettings = options.fold(settings) { before, (parameter, option) ->
        option.value.fold(before) { all, word -> all.withWord(parameter, word) }
    }

    companion object {
        /** No settings, whose messages name options. */
        val NONE: PictureSettings = PictureSettings().withNames(ParameterNames("--", " "))
    }
}

/** Options of the camera. */
internal class CameraOptions : ParameterOptions(ParameterGroup.CAMERA) {
    val isPrinted by option(
        "--print-camera",
        help = "Print to standard error the options that give exactly this camera",
    ).flag()
}
