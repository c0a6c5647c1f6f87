package dev.lazyz.cli.input

import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Progress
import dev.lazyz.cli.output.Streams
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.lighting.LightRig
import dev.lazyz.lighting.Matcap
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.scenes.Scenes
import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.Shading
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureWrap
import java.nio.file.Path

/**
 * The options of light.
 *
 * @param rig null for the scene's own lights, or the default ones
 * @param intensity factor of all light; null means 1, or what the light meter says
 * @param matcap the file of a lit sphere, or null
 * @param shading the shading that the user chose, or null
 * @param others the names of other options given, which have no effect with [matcap]
 */
internal class LightChoice(
    private val rig: LightRig?,
    private val intensity: Float?,
    wantsOcclusion: Boolean,
    wantsGroundShadow: Boolean,
    val matcap: Path?,
    shading: Shading?,
    others: List<String>,
    style: PictureStyle?,
) {
    private val hasGroundShadow = wantsGroundShadow || style == PictureStyle.PRODUCT

    /** Whether surfaces occlude ambient light, which makes shading expensive. */
    val hasOcclusion: Boolean = wantsOcclusion || style == PictureStyle.PRODUCT

    /** An option that needs the whole model in memory, or null. */
    val wholeModel: String? = when {
        style == PictureStyle.PRODUCT -> "--style product"
        wantsOcclusion -> "--ambient-occlusion"
        wantsGroundShadow -> "--ground-shadow"
        else -> null
    }

    init {
        val lonely = listOfNotNull(
            rig?.let { "--light" }, intensity?.let { "--light-intensity" },
            "--ambient-occlusion".takeIf { wantsOcclusion },
        ) + others
        if (matcap != null && lonely.isNotEmpty()) {
            throw Mistake("--matcap replaces materials and light, so ${lonely[0]} has no effect")
        }
        if (hasOcclusion && (shading == Shading.FLAT || shading == Shading.GOURAUD)) {
            val word = shading.name.lowercase()
            throw Mistake("with ambient occlusion, light is computed at each pixel, so --shading $word has no effect")
        }
    }

    /**
     * Returns [scene], which has a camera, in the light of these options for [subject], or with materials that show a
     * lit sphere. The lights of the rig that the file of [loaded] names turn with the camera.
     */
    fun lit(scene: Scene, subject: Subject, loaded: LoadedScene): Scene {
        val color = subject.color
        if (matcap != null) return captured(scene, matcap, color, subject.loading.limits)

        // A chosen colour is shown as it is
        return loaded.lit(scene, rig, intensity ?: scene.lightIntensity.takeIf { color != null })
    }

    /**
     * Returns [scene], which has a camera, with the shadows of these options. Uses the threads of [options].
     *
     * @param name what the scene is called in messages
     * @param hasFreePlanes whether the near and the far plane of the camera can be moved
     */
    fun withShadows(
        scene: Scene,
        name: String,
        hasFreePlanes: Boolean,
        options: RenderOptions,
        streams: Streams,
    ): Scene {
        if (!(hasOcclusion || hasGroundShadow) || scene.bounds == null) return scene
        if (scene.isOnScreen) {
            throw Mistake("a scene given on the screen has no --ambient-occlusion and no --ground-shadow")
        }
        AmbientOcclusion.obstacle(scene)?.let { throw Mistake("$name: $it, or leave out its shadows") }
        streams.progress("computing shadows ...")
        val isOccluded = hasOcclusion && matcap == null
        val directions = (if (isOccluded) AmbientOcclusion.DEFAULT_DIRECTIONS else 0) +
            (if (hasGroundShadow) GroundShadow.DIRECTIONS else 0)
        val progress = Progress(streams, directions, "directions", "shadows")
        val soft =
            if (isOccluded) AmbientOcclusion.of(scene, options = options) { progress.advance() }.on(scene) else scene
        if (!hasGroundShadow) return soft
        val shadowed = GroundShadow.of(scene, options = options) { progress.advance() }.on(soft)
        return if (hasFreePlanes) shadowed else shadowed.withViewpoint(scene.viewpoint)
    }

    private fun captured(scene: Scene, file: Path, color: Rgba?, limits: LoadLimits): Scene {
        val picture = Scenes.texture(file, limits)
            .withSampling(TextureFilter.BILINEAR, TextureWrap.CLAMP, TextureWrap.CLAMP, MipFilter.NONE)
        val shader = Matcap(picture, scene.viewpoint as Camera, scene.origin, color ?: Rgba.WHITE)
        return scene.withMaterials { it.withShader(shader) }
    }
}
