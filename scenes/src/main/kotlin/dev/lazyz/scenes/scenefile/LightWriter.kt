package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.json.JsonWriter
import dev.lazyz.world.Falloff
import dev.lazyz.world.Light
import dev.lazyz.world.ToneMapping

/** Writes the lights and the tone mapping of a scene file. */
internal object LightWriter {
    fun write(out: JsonWriter, light: Light) = out.members {
        when (light) {
            is Light.Ambient -> key("ambient").members { key("color").color(light.color) }
            is Light.Directional -> key("directional").members {
                key("direction").vector(light.direction)
                key("color").color(light.color)
            }
            is Light.Point -> key("point").members {
                key("position").vector(light.position)
                key("color").color(light.color)
                falloff(this, light.falloff)
            }
            is Light.Spot -> key("spot").members {
                key("position").vector(light.position)
                key("direction").vector(light.direction)
                key("color").color(light.color)
                key("innerAngle").double(light.innerAngle)
                key("outerAngle").double(light.outerAngle)
                falloff(this, light.falloff)
            }
        }
    }

    private fun falloff(out: JsonWriter, falloff: Falloff) {
        if (falloff == Falloff.NONE) return
        out.key("falloff").text(SceneFileNames.INVERSE_SQUARE)
        if (falloff.range.isFinite()) out.key("range").double(falloff.range)
    }

    fun write(out: JsonWriter, toneMapping: ToneMapping) = out.members {
        key("curve").text(SceneFileNames.of(toneMapping.curve))
        key("exposure").double(toneMapping.exposure)
    }
}
