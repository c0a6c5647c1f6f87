package dev.lazyz.cli.input

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture

/**
 * A colour and a texture that replace those of all surfaces, and the colours of vertices.
 *
 * @property color null means white
 * @property texture null means none
 */
internal class Paint(private val color: Rgba?, private val texture: Texture?) {
    /** Returns [scene] with this paint on all surfaces. */
    fun applyTo(scene: Scene): Scene =
        scene.withSurfaces(
            scene.surfaces.map { surface ->
                surface.withoutColors().withMaterials { painted(it, texture.takeIf { surface.hasUvs(0) }) }
            },
        )

    /** Removes a custom shader, too, which would take precedence. */
    private fun painted(material: Material, texture: Texture?): Material {
        val isOpaque = (color == null || color.alpha >= 1f) && texture?.hasAlpha != true
        return material.withBaseColor(color ?: Rgba.WHITE).withTexture(texture).withShader(null)
            .withAlphaMode(if (isOpaque) AlphaMode.OPAQUE else AlphaMode.BLEND)
    }
}
