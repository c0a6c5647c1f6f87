package dev.lazyz.scenes.pictures

import dev.lazyz.Rgba
import dev.lazyz.drawing.EdgeDrawing
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import java.nio.file.Path

/**
 * A model before a camera sees it. Thread safe.
 *
 * @property key what it was made of
 * @property scene the model, cut, turned so that y points up, and painted
 */
internal class PreparedModel(val key: List<Any?>, val scene: Scene) {
    @Volatile
    private var edges: EdgeDrawing? = null

    /** Returns the edges of [surfaces]. What is known about those of the [scene] is kept. */
    fun edges(surfaces: List<Surface>, style: EdgeStyle): EdgeDrawing = when {
        surfaces !== scene.surfaces -> EdgeDrawing(surfaces, style)
        else -> (edges?.withStyle(style) ?: EdgeDrawing(surfaces, style)).also { edges = it }
    }

    companion object {
        /** What can be chosen about the model before a camera sees it, besides its axis. */
        private val CHOICES = PictureParameters.run {
            listOf(STYLE, CUT, CAP_COLOR, POINT_SIZE, LINE_WIDTH, COLOR, TEXTURE, SHADING, TEXTURE_FILTER)
        }

        /** Returns what [settings] choose about it, besides its axis. */
        fun choices(settings: PictureSettings): List<Any?> = CHOICES.map { settings[it] }
    }
}

/** Turns, sizes and paints a model as [settings] say, before a camera sees it. */
internal class ModelPreparation(private val settings: PictureSettings, private val observer: PictureObserver) {
    private val names = settings.names

    /** Returns [scene], whose axis [up] points up, in which then y does. */
    fun prepared(scene: Scene, up: UpAxis): Scene = shaded(painted(sized(turned(scene, up))))

    private fun turned(scene: Scene, up: UpAxis): Scene = try {
        scene.withUpAxis(up)
    } catch (e: UnsupportedOperationException) {
        throw NoPictureException("${names.of(PictureParameters.UP)}: ${e.message}", e)
    }

    private fun sized(scene: Scene): Scene {
        val point = settings[PictureParameters.POINT_SIZE]
        val line = settings[PictureParameters.LINE_WIDTH]
        if (point == null && line == null) return scene
        return scene.withSurfaces(
            scene.surfaces.map { surface ->
                when {
                    surface is Points && point != null -> surface.withSize(point)
                    surface is Lines && line != null -> surface.withWidth(line)
                    else -> surface
                }
            },
        )
    }

    /** Returns [scene] with the chosen colour and texture, which replace those of surfaces and vertices. */
    private fun painted(scene: Scene): Scene {
        val color = settings[PictureParameters.COLOR]
        val texture = settings[PictureParameters.TEXTURE]?.let { texture(it, scene) }
        if (color == null && texture == null) return scene

        // A custom shader would take precedence
        val isOpaque = (color == null || color.alpha >= 1f) && texture?.hasAlpha != true
        val alpha = if (isOpaque) AlphaMode.OPAQUE else AlphaMode.BLEND
        val surfaces = scene.surfaces.map { surface ->
            surface.withoutColors().withMaterials { material ->
                material.withBaseColor(color ?: Rgba.WHITE).withTexture(texture.takeIf { surface.hasUvs(0) })
                    .withShader(null).withAlphaMode(alpha)
            }
        }
        return scene.withSurfaces(surfaces)
    }

    private fun texture(file: Path, scene: Scene) = observer.texture(file).also {
        val name = names.of(PictureParameters.TEXTURE)
        val bare = scene.surfaces.count { !it.hasUvs(0) }
        val all = scene.surfaces.size
        if (bare > 0 && bare == all) refuse("$name: ${observer.name} has no texture coordinates")
        if (bare > 0) {
            observer.warning("$bare of $all surfaces have no texture coordinates, so $name has no effect on them")
        }
    }

    /** Returns [scene] with the chosen shading. What would take precedence over it is removed. */
    private fun shaded(scene: Scene): Scene {
        val shading = settings[PictureParameters.SHADING]
        val mip = settings[PictureParameters.TEXTURE_FILTER]
        if (shading == null && mip == null) return scene
        return scene.withMaterials { material ->
            val shaded = shading?.let { material.withShading(it).withShader(null).withMetallicRoughness(null) }
            (shaded ?: material).let { if (mip == null) it else it.withMipFilter(mip) }
        }
    }
}
