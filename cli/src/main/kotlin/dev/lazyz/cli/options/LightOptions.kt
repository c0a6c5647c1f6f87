package dev.lazyz.cli.options

import com.github.ajalt.clikt.parameters.groups.OptionGroup
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import dev.lazyz.cli.input.LightChoice
import dev.lazyz.lighting.LightRig
import dev.lazyz.world.ToneCurve
import dev.lazyz.world.ToneMapping

/** Options of light, exposure and tone mapping. */
internal class LightOptions : OptionGroup("Light") {
    private val rig by option(
        "--light",
        help = "Replace the lights of the scene: ${names(rigs.keys)}; default: the scene's, or studio",
    ).oneOf("LIGHT", rigs)

    private val intensity by option(
        "--light-intensity",
        help = "Multiply all light, 0..1000; default: the scene file's, or 1, or up to 3 for " +
            "models with dark materials and no lights",
    ).number("FACTOR", 0.0..1000.0, "")

    private val hasOcclusion by option(
        "--ambient-occlusion",
        help = "Darken hollows and contacts, which light from all sides does not reach; all materials are lit by " +
            "the studio",
    ).flag()

    private val hasGroundShadow by option(
        "--ground-shadow",
        help = "Let the model stand on level ground, with a soft shadow",
    ).flag()

    private val matcap by option(
        "--matcap",
        help = "Colour all surfaces like this picture of a lit sphere, which --color multiplies",
    ).path()

    val toneCurve by option(
        "--tone-map",
        help = "How bright light is compressed: ${names(toneCurves.keys)}; default: the scene file's, neutral for " +
            "scenes with metallic-roughness materials, or none",
    ).oneOf("CURVE", toneCurves)

    val exposure by option(
        "--exposure",
        help = "Brighten by this number of stops, -20..20: 1 doubles the light; default: the scene file's, or 0",
    ).number("EV", -ToneMapping.MAX_EXPOSURE..ToneMapping.MAX_EXPOSURE, " stops")

    /** Returns the light that the options describe, for a [picture] with others. */
    fun choice(picture: PictureOptions): LightChoice {
        val others = listOfNotNull(
            picture.shading?.let { "--shading" }, picture.texture?.let { "--texture" }, toneCurve?.let { "--tone-map" },
            exposure?.let { "--exposure" },
        )
        return LightChoice(
            rig, intensity?.toFloat(), hasOcclusion, hasGroundShadow, matcap, picture.shading, others, picture.style,
        )
    }
}

private val rigs = words(LightRig.entries)

private val toneCurves = words(ToneCurve.entries)
