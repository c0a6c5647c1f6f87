package dev.lazyz.scenes.pictures

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.ShadingRate
import dev.lazyz.drawing.EdgeDrawing
import dev.lazyz.drawing.EdgeStyle
import dev.lazyz.drawing.EdgeStyle.EdgeSet
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.drawing.FeatureEdges
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.filter.SuperSampling.PixelFilter
import dev.lazyz.lighting.AmbientOcclusion
import dev.lazyz.lighting.EnvironmentBackground
import dev.lazyz.lighting.GroundShadow
import dev.lazyz.lighting.Matcap
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.sections.Section
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
import dev.lazyz.world.camera.Viewpoint
import dev.lazyz.world.light.Environment
import dev.lazyz.world.light.ToneMapping
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.Texture.MipFilter

/**
 * The steps from [loaded] to a picture with the [chosen] settings, see [PictureSettings], by threads of [options].
 *
 * @param stage what this picture has in common with others, or null
 */
internal class PictureSteps(
    chosen: PictureSettings,
    private val loaded: LoadedScene,
    private val options: RenderOptions,
    private val observer: PictureObserver,
    private val stage: Stage? = null,
) {
    /**
     * What pictures that are compared have in common.
     *
     * @property intensity the factor of light for models whose light nobody chose
     * @property planes the planes that cut
     */
    class Stage(val camera: Camera, val raster: Raster, val intensity: Float, val planes: List<Section.Plane>)

    private val settings = chosen.withFile(loaded.picture)
    private val names = settings.names
    private val style = settings[PictureParameters.STYLE]

    /** Whether there is more to see than surfaces of the model: edges, or a shadow on the ground. */
    val hasExtras: Boolean get() = settings.hasEdges || settings.hasGroundShadow

    /** Sets up the picture, at a step of a turntable if [turn] makes a camera for it. */
    fun frame(turn: ((FittedViewpoint) -> Viewpoint)?): PictureFrame {
        val shown = Shown(turn)
        val scene = finished(shown)
        val edges = edges(scene, shown) ?: return frame(scene, shown)
        return frame(scene.withSurfaces(scene.surfaces + edges), shown)
    }

    private fun finished(shown: Shown): Scene {
        val shadowed = shown.shadowed()
        observer.camera(shadowed.viewpoint as Camera, shown.up)
        return toned(shadowed)
    }

    /** Computes the lines of the picture. */
    fun drawing(): PictureDrawing {
        if (!settings.hasEdges) {
            val lines = "${names.of(PictureParameters.EDGES)}, ${names.of(PictureParameters.WIREFRAME)}"
            refuse("there are no lines to draw: add $lines or ${names.of(PictureParameters.STYLE, "technical")}")
        }
        val shown = Shown(null)
        val scene = finished(shown)
        val raster = shown.raster
        val camera = scene.viewpoint as Camera
        val pixelSize = PictureDrawing.pixelSize(settings, loaded.unit, camera, raster)
        val edges = checkNotNull(edges(scene, shown))
        val isOnPaper = style == PictureStyle.TECHNICAL &&
            settings[PictureParameters.BACKGROUND]?.isPlain != false && PictureDrawing.isOnPaper(scene, raster)
        return PictureDrawing(
            edges.style, edges.lines(raster, camera, options),
            if (isOnPaper) edges.caps(raster, camera) else emptyList(), region(raster), pixelSize,
            raster.background.alpha > 0f, if (isOnPaper) null else frame(scene, shown),
        )
    }

    /** Sets up a picture of the surfaces of the model alone. */
    fun bare(): PictureFrame = Shown(null).let { frame(it.lit, it) }

    /** Returns what pictures of parts of [loaded] have in common if its camera, light and cuts are theirs. */
    fun stage(): Stage = Shown(null).let { shown ->
        val shadowed = shown.shadowed()
        Stage(shadowed.viewpoint as Camera, shown.raster, shown.lit.lightIntensity, planes())
    }

    private fun frame(scene: Scene, shown: Shown): PictureFrame {
        val raster = shown.raster
        val region = region(raster)
        observer.setUp(ImageSize(raster.width, raster.height))
        val backdrop = settings[PictureParameters.BACKGROUND]
        val behind = if (backdrop === Backdrop.ENVIRONMENT) surroundings(scene, raster) else backdrop?.gradient
        val crop = lazy { isCropped(shown.viewed, raster) }
        return PictureFrame(sampled(scene, raster).within(region), behind, shown.up, crop, names)
    }

    private fun surroundings(scene: Scene, raster: Raster): EnvironmentBackground {
        if (scene.isOnScreen) refuse("a scene given on the screen has no ${names.of(PictureParameters.ENVIRONMENT)}")
        return EnvironmentBackground(scene, raster.width, raster.height, settings.factor)
    }

    /** The scene as its camera shows it, from the first step to light. */
    private inner class Shown(turn: ((FittedViewpoint) -> Viewpoint)?) {
        val up = settings[PictureParameters.UP] ?: loaded.usualUp
        val prepared: PreparedModel
        val raster: Raster
        val viewed: Scene
        val lit: Scene
        private val hasFreePlanes: Boolean

        init {
            settings.check()
            val camera = PictureCamera(settings)
            if (camera.isMissing(loaded)) {
                val scene = names.of(PictureParameters.CAMERA, "scene")
                observer.warning("$scene: ${observer.name} has no camera, and is shown as a whole")
            }

            prepared = observer.prepared(listOf(loaded.scene, stage, up) + PreparedModel.choices(settings)) {
                val cut = PictureCuts(settings, observer).of(style?.painted(loaded.scene) ?: loaded.scene, planes())
                ModelPreparation(settings, observer).prepared(cut, up)
            }
            val shaded = camera.applyTo(prepared.scene, loaded, up, turn)

            // The camera is fitted to the whole raster. The picture may be a part of it
            raster = stage?.raster ?: raster(shaded)
            viewed = shaded.withViewpoint(stage?.camera ?: camera(shaded, raster))
            hasFreePlanes = stage == null && camera.hasFreePlanes && shaded.viewpoint !is Camera

            // Lit spheres are the last materials; only what is opaque after that hides light and lines
            lit = opaque(lit(viewed))
        }

        fun shadowed() = shadowed(lit, hasFreePlanes)
    }

    private fun planes(): List<Section.Plane> =
        stage?.planes ?: settings[PictureParameters.CUT].orEmpty().map { it.plane(loaded.scene) }

    private fun raster(scene: Scene): Raster {
        val size = settings.orDefault(PictureParameters.SIZE) ?: loaded.size ?: PictureSettings.USUAL_SIZE
        val depth = settings[PictureParameters.DEPTH_CONVENTION]?.let { DepthRules(it) } ?: loaded.depth
        val color = settings[PictureParameters.BACKGROUND]?.color ?: scene.background
        return depth.raster(size.width, size.height, color)
    }

    private fun camera(scene: Scene, raster: Raster): Camera = try {
        scene.camera(raster.width, raster.height)
    } catch (e: IllegalArgumentException) {
        if (e is NoPictureException) throw e
        throw NoPictureException("there is no such camera: ${e.message}", e)
    }

    /** Returns [scene], which has a camera, in the chosen light, or with materials that show a lit sphere. */
    private fun lit(scene: Scene): Scene {
        val color = settings[PictureParameters.COLOR]
        val matcap = settings[PictureParameters.MATCAP]
        if (matcap != null) {
            val picture = observer.texture(matcap)
                .withSampling(Texture.Filter.BILINEAR, Texture.Wrap.CLAMP, Texture.Wrap.CLAMP, MipFilter.NONE)
            val shader = Matcap(picture, scene.viewpoint as Camera, scene.origin, color ?: Rgba.WHITE)
            return scene.withMaterials { it.withShader(shader) }
        }

        // A chosen colour is shown as it is, and so are surroundings
        val surroundings = settings.files[PictureParameters.ENVIRONMENT]
        val intensity = settings[PictureParameters.LIGHT_INTENSITY]?.toFloat()
            ?: stage?.intensity.takeIf { loaded.isModel }
            ?: scene.lightIntensity.takeIf { color != null || surroundings != null }
        val lit = loaded.lit(scene, settings[PictureParameters.LIGHT], intensity)
        if (surroundings == null) return lit
        val environment = Environment.of(
            observer.environment(surroundings, options),
            settings[PictureParameters.ENVIRONMENT_INTENSITY]?.toFloat() ?: 1f,
            settings[PictureParameters.ENVIRONMENT_ROTATION] ?: 0.0,
        )
        return lit.withMaterials { it.asMetallicRoughness() }.withEnvironment(environment)
    }

    private fun opaque(scene: Scene): Scene =
        if (settings.has(PictureParameters.OPAQUE)) scene.withMaterials(::opaque) else scene

    /** Other shaders ignore alpha if the material is opaque; a custom one sets what it likes. */
    private fun opaque(material: Material): Material {
        if (material.alphaMode != AlphaMode.BLEND) return material
        val shader = material.shader?.let { custom ->
            Shader { fragment ->
                custom.shade(fragment)
                fragment.setColor(fragment.red, fragment.green, fragment.blue)
            }
        }
        return material.withAlphaMode(AlphaMode.OPAQUE).withShader(shader)
    }

    /** @param hasFreePlanes whether the near and the far plane of the camera can be moved */
    private fun shadowed(scene: Scene, hasFreePlanes: Boolean): Scene {
        val hasGroundShadow = settings.hasGroundShadow
        if (!(settings.hasOcclusion || hasGroundShadow) || scene.bounds == null) return scene
        if (scene.isOnScreen) {
            val occlusion = names.of(PictureParameters.AMBIENT_OCCLUSION)
            val shadow = names.of(PictureParameters.GROUND_SHADOW)
            refuse("a scene given on the screen has no $occlusion and no $shadow")
        }
        AmbientOcclusion.obstacle(scene)?.let { refuse("${observer.name}: $it, or leave out its shadows") }
        val isOccluded = settings.hasOcclusion && settings[PictureParameters.MATCAP] == null
        observer.shadows(
            (if (isOccluded) AmbientOcclusion.DEFAULT_DIRECTIONS else 0) +
                (if (hasGroundShadow) GroundShadow.DIRECTIONS else 0),
        )
        val soft =
            if (isOccluded) AmbientOcclusion.of(scene, options = options) { observer.shadowed() }.on(scene) else scene
        if (!hasGroundShadow) return soft
        val shadowed = GroundShadow.of(scene, options = options) { observer.shadowed() }.on(soft)
        return if (hasFreePlanes) shadowed else shadowed.withViewpoint(scene.viewpoint)
    }

    /** Replaces what was chosen of the tone mapping that [scene] would have. */
    private fun toned(scene: Scene): Scene {
        val curve = settings[PictureParameters.TONE_MAP]
        val exposure = settings[PictureParameters.EXPOSURE]
        if (curve == null && exposure == null) return scene
        val own = scene.effectiveToneMapping
        return scene.withToneMapping(ToneMapping(curve ?: own.curve, exposure ?: own.exposure))
    }

    /** Returns the chosen edges of [scene], as [shown], or null if there are none. */
    private fun edges(scene: Scene, shown: Shown): EdgeDrawing? {
        if (!settings.hasEdges) return null
        val isWireframe = settings.has(PictureParameters.WIREFRAME)
        val edges = EdgeStyle(
            if (isWireframe) EdgeSet.ALL else EdgeSet.FEATURES,
            settings[PictureParameters.CREASE_ANGLE] ?: FeatureEdges.DEFAULT_CREASE_ANGLE,
            settings[PictureParameters.EDGE_WIDTH] ?: PictureStyle.lineWidth(shown.raster, style),
            settings[PictureParameters.EDGE_COLOR] ?: Rgba.BLACK,
            settings[PictureParameters.HIDDEN_LINES] ?: HiddenLines.NONE,
            settings[PictureParameters.HIDDEN_COLOR] ?: EdgeStyle.HIDDEN_GREY,
            settings[PictureParameters.HIDDEN_BEHIND] ?: Int.MAX_VALUE,
        )
        return shown.prepared.edges(scene.surfaces, edges)
    }

    private fun region(raster: Raster): Region {
        val region = settings[PictureParameters.REGION] ?: return raster.region
        if (raster.region.contains(region)) return region
        val word = "${region.columnStart},${region.rowStart},${region.width}x${region.height}"
        val whole = "the whole picture, which is ${raster.width}x${raster.height}"
        refuse("${names.of(PictureParameters.REGION, word)} reaches beyond $whole")
    }

    /** Sets up [scene] for the samples of the pixels of [raster]. What was not chosen gives way to obstacles. */
    private fun sampled(scene: Scene, raster: Raster): SampledFrame {
        val aa = PictureParameters.AA
        val filter = settings[PictureParameters.AA_FILTER] ?: PixelFilter.BOX

        // Occlusion makes shading expensive, so that a pixel is shaded once
        val rate = settings[PictureParameters.SHADING_RATE]
            ?: if (settings.hasOcclusion) ShadingRate.PIXEL else ShadingRate.AUTO
        val wish = SuperSampling(settings.factor, filter, rate)
        val obstacle = wish.obstacle(scene, raster)
        if (obstacle != null && settings[aa] != null) {
            refuse("${names.of(aa, wish.factor)}: $obstacle; use ${names.of(aa, 1)}")
        }
        return (if (obstacle == null) wish else SuperSampling(1, filter)).frame(scene, raster, options)
    }
}
