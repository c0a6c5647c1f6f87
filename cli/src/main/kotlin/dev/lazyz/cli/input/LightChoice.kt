package dev.lazyz.cli.input

import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.lighting.LightMeter
import dev.lazyz.lighting.LightRig
import dev.lazyz.lighting.Matcap
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.Scenes
import dev.lazyz.world.Camera
import dev.lazyz.world.MipFilter
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.TextureFilter
import dev.lazyz.world.TextureWrap
import java.nio.file.Path

/**
 * The options of light.
 *
 * @param rig null for the scene's own lights, or the default ones
 * @param intensity factor of all light; null means 1, or what the light meter says
 * @param matcap the file of a lit sphere, or null
 */
internal class LightChoice(
    private val rig: LightRig?,
    private val intensity: Float?,
    wantsOcclusion: Boolean,
    wantsGroundShadow: Boolean,
    private val matcap: Path?,
    style: PictureStyle?,
) {
    private val hasGroundShadow = wantsGroundShadow || style == PictureStyle.PRODUCT

    /** Whether surfaces occlude ambient light, which makes shading expensive. */
    val hasOcclusion: Boolean = wantsOcclusion || style == PictureStyle.PRODUCT

    init {
        val lonely = listOfNotNull(
            rig?.let { "--light" }, intensity?.let { "--light-intensity" },
            "--ambient-occlusion".takeIf { wantsOcclusion },
        ).firstOrNull()
        if (matcap != null && lonely != null) throw Mistake("--matcap replaces all light, so $lonely has no effect")
    }

    /**
     * Returns [scene], which has a camera, in the light of these options.
     *
     * @param color a colour for all surfaces that the user chose, or null
     * @param isMetered whether dark materials get more light
     * @param options the threads
     */
    fun applyTo(
        scene: Scene,
        color: Rgba?,
        isMetered: Boolean,
        limits: LoadLimits,
        options: RenderOptions,
        streams: Streams,
    ): Scene {
        val lit = if (matcap == null) lit(scene, color, isMetered) else captured(scene, matcap, color, limits)
        if (!(hasOcclusion || hasGroundShadow) || scene.bounds == null) return lit
        if ((scene.viewpoint as Camera).projection == Projection.Screen) {
            throw Mistake("a scene given on the screen has no --ambient-occlusion and no --ground-shadow")
        }
        streams.progress("computing shadows ...")
        return shadowed(if (hasOcclusion && matcap == null) occluded(lit, options) else lit, options)
    }

    private fun lit(scene: Scene, color: Rgba?, isMetered: Boolean): Scene {
        val rigged = rig?.on(scene, scene.viewpoint as Camera) ?: scene
        val hasUsualLight = if (rig == null) scene.lights.isEmpty() else rig != LightRig.FLAT
        val isAuto = intensity == null && isMetered && color == null && hasUsualLight
        return rigged.withLightIntensity(intensity ?: if (isAuto) LightMeter.intensity(scene) else 1f)
    }

    private fun captured(scene: Scene, file: Path, color: Rgba?, limits: LoadLimits): Scene {
        val picture = Scenes.texture(file, limits)
            .withSampling(TextureFilter.BILINEAR, TextureWrap.CLAMP, TextureWrap.CLAMP, MipFilter.NONE)
        val shader = Matcap(picture, scene.viewpoint as Camera, scene.origin, color ?: Rgba.WHITE)
        return scene.withMaterials { it.withShader(shader) }
    }

    private fun occluded(scene: Scene, options: RenderOptions): Scene =
        scene.withMaterials { it.asMetallicRoughness() }
            .withAmbientVisibility(AmbientOcclusion.of(scene, options = options))

    private fun shadowed(scene: Scene, options: RenderOptions): Scene {
        if (!hasGroundShadow) return scene
        val shadow = GroundShadow.of(scene, options = options)
        return scene.withSurfaces(scene.surfaces + shadow).withViewpoint(shadow.camera(scene.viewpoint as Camera))
    }
}
