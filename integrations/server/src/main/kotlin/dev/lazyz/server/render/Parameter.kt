package dev.lazyz.server.render

import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.world.Fit
import dev.lazyz.world.View

/**
 * The parameters of a request. Each means the same as the option of `zcli render` with its name.
 *
 * @property form the form of the value
 * @property help what it does
 */
internal enum class Parameter(val form: String, val help: String) {
    FORMAT("FORMAT", "the format of the model: ${formats.keys.joinToString()}; default: by Content-Type or content"),
    UP("AXIS", "which axis of the model points up: ${axes.keys.joinToString()}; default: z for stl and 3mf, else y"),
    SIZE("WxH", "width and height in pixels, or one number for a square; default: 640x480"),
    AA("N", "anti-aliasing, N x N samples a pixel: ${factors.keys.joinToString()}; default: 4, or 1 where necessary"),
    BACKGROUND(
        "COLOR",
        "a name of CSS, such as skyblue, transparent, or hexadecimal rgb, rrggbb or rrggbbaa; default: white",
    ),
    VIEW("SIDE", "look from ${views.keys.joinToString()}"),
    AZIMUTH("DEGREES", "angle around the up axis: 0 front, 90 right; default: that of the view, or 30"),
    ELEVATION("DEGREES", "angle above the horizon, -90..90; default: that of the view, or 20"),
    PROJECTION("KIND", "${projections.keys.joinToString()}; default: perspective"),
    MARGIN("PERCENT", "free part of the picture on each side, 0..45; default: 5"),
    ZOOM("FACTOR", "1 shows the whole model, 2 shows half as much; 0.001..1000; default: 1"),
    LIGHT("LIGHT", "the lights: ${lights.keys.joinToString()}; default: those of the model, or studio"),
    LIGHT_INTENSITY("FACTOR", "multiplies all light, 0..1000; default: 1, or up to 3 for dark materials"),
    ;

    /** The name in a request. */
    val id: String = word(this)
}

/** The formats that a request can have: those of models, in one file. */
internal val formats: Map<String, SceneFormat> = (SceneFormat.entries - SceneFormat.SCENE).associateBy { it.id }

internal val axes: Map<String, UpAxis> = UpAxis.entries.associateBy { it.id }
internal val factors: Map<String, Int> = listOf(1, 2, 4, 8).associateBy { "$it" }
internal val views: Map<String, View> = View.entries.associateBy(::word)
internal val projections: Map<String, Fit> = Fit.entries.associateBy(::word)
internal val lights: Map<String, LightRig> = LightRig.entries.associateBy(::word)

private fun word(constant: Enum<*>): String = constant.name.lowercase().replace('_', '-')
