package dev.lazyz.cli.input

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.StreamedMesh
import dev.lazyz.world.surface.Surface
import dev.lazyz.world.surface.Vertex

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
                val shown = texture.takeUnless { lacksTexturePlaces(surface) }
                plain(surface).withMaterials { painted(it, shown) }
            },
        )

    /** Removes a custom shader, too, which would take precedence. */
    private fun painted(material: Material, texture: Texture?): Material {
        val isOpaque = (color == null || color.alpha >= 1f) && texture?.hasAlpha != true
        return material.withBaseColor(color ?: Rgba.WHITE).withTexture(texture).withShader(null)
            .withAlphaMode(if (isOpaque) AlphaMode.OPAQUE else AlphaMode.BLEND)
    }

    /** Returns [surface] without colours of vertices. */
    private fun plain(surface: Surface): Surface = when (surface) {
        is Mesh -> with(surface) {
            Mesh(positions, triangles, material, normals, uvs, null, origin, uvs2, tangents, name)
        }
        is StreamedMesh -> surface.withoutColors()
        is Points -> with(surface) { Points(positions, size, material, normals, null, origin, name) }
        is Lines -> with(surface) { Lines(positions, segments, width, material, null, origin, name) }
        is Polygon -> with(surface) {
            Polygon(
                contours.map { contour ->
                    contour.map { Vertex(it.x, it.y, it.z, it.u, it.v) }
                },
                material, fillRule, name,
            )
        }
        else -> surface
    }

    companion object {
        /** Whether [surface] has no places for the texels of a texture. */
        fun lacksTexturePlaces(surface: Surface): Boolean = when (surface) {
            is Mesh -> surface.uvs == null
            is Points, is Lines -> true
            else -> false
        }
    }
}
