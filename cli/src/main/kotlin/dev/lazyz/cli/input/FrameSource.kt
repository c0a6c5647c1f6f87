package dev.lazyz.cli.input

import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.OutputPlaces
import dev.lazyz.cli.output.Streams
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.Scenes
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.world.Camera
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.ToneMapping
import dev.lazyz.world.View
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Texture
import java.nio.file.Path

/**
 * Reads the input that [subject] names, and creates the frame that the options describe.
 *
 * @param loading how to read it
 */
internal class FrameSource(
    private val subject: Subject,
    private val streams: Streams,
    loading: LoadOptions = subject.loading,
) {
    val input = Input(subject.input, subject.format, loading)

    /** The files that the options name. */
    val files: List<Path> get() = subject.files

    /** Reads the input, and prints its warnings. */
    fun load(): LoadedScene = read().also { warn(it.warnings) }

    /** Opens the input to be read part by part, with temporary files in [spool], and prints its warnings. */
    fun stream(spool: Path): StreamedScene {
        if (subject.loading.animationTime != null) {
            streams.warning("files that are read part by part have no animation, so the requested time has no effect")
        }
        streams.progress("looking through ${input.name} ...")
        return input.stream(streams, spool).also { warn(it.loaded.warnings) }
    }

    private fun warn(warnings: List<String>) {
        warnings.take(MAX_WARNINGS).forEach { streams.warning(it) }
        val rest = warnings.size - MAX_WARNINGS
        if (rest > 0) streams.warning("and $rest more")
    }

    /** Reads the input without printing its warnings. */
    fun read(): LoadedScene {
        streams.progress("reading ${input.name} ...")
        return input.load(streams)
    }

    /**
     * Checks that no output replaces a file that [loaded] was read from.
     *
     * @throws Mistake otherwise
     */
    fun requireKept(loaded: LoadedScene, outputs: OutputPlaces) {
        outputs.requireNone(loaded.files, "a file that ${input.name} refers to")
    }

    /**
     * Returns the picture of [loaded], seen from [view] or, if that is null, from the side that the options choose, and
     * then from the step [turn] of a turntable. It is set up by the threads of [options]. A printed camera begins with
     * [name], unless it is null.
     */
    fun frame(
        loaded: LoadedScene,
        options: RenderOptions,
        view: View? = null,
        turn: Turn? = null,
        name: String? = null,
    ): Shot {
        // Apply the options of sections, axis, camera, shading and lines
        val lineWork = subject.lineWork
        val up = subject.up ?: loaded.usualUp
        val side = if (view == null) subject.pointOfView else subject.pointOfView.from(view)
        val pointOfView = (if (turn == null) side else side.at(turn))
            .withDefaults(if (loaded.scene.isOnScreen) null else subject.style)
        if (pointOfView.lacksCamera(loaded)) {
            streams.warning("--camera scene: ${input.name} has no camera, and is shown as a whole")
        }
        val painted = subject.style?.painted(loaded.scene) ?: loaded.scene
        val cut = loaded.withScene(lineWork.cut(painted) { streams.warning(it) })
        val upright = try {
            pointOfView.applyTo(cut, up)
        } catch (e: UnsupportedOperationException) {
            throw Mistake("--up: ${e.message}")
        }
        val seen = subject.sizes.applyTo(upright)
        val colored = paint(seen)?.applyTo(seen) ?: seen
        val shaded = if (subject.changesMaterials) colored.withMaterials(::changed) else colored

        // The camera is fitted to the whole raster. The picture may be a part of it
        val raster = raster(shaded, loaded)
        val viewed = shaded.withViewpoint(camera(shaded, raster))
        val hasFreePlanes = pointOfView.hasFreePlanes && shaded.viewpoint !is Camera

        // Lit spheres are the last materials; only what is opaque after that hides light and lines
        val lit = subject.translucency.appliedTo(subject.light.lit(viewed, subject, loaded))
        val shadowed = subject.light.withShadows(lit, input.name, hasFreePlanes, options, streams)
        if (pointOfView.isPrinted) {
            val words = PointOfView.words(shadowed.viewpoint as Camera, up)
            streams.note((if (name == null) words else "$name: $words") + "\n")
        }
        val scene = lineWork.drawnOn(toned(shadowed), raster)
        val region = region(raster)
        streams.progress("setting up ${raster.width}x${raster.height} ...")
        val sampled = subject.antiAliasing.frame(scene, raster, options).within(region)
        return Shot(sampled, subject.background?.gradient, up)
    }

    /** Returns a picture of nothing, of the size that the options choose. */
    fun blank(options: RenderOptions): Shot {
        val size = subject.size ?: DEFAULT_SIZE
        val raster = Raster(size.width, size.height)
        return Shot(subject.antiAliasing.frame(Scene(emptyList()), raster, options).within(region(raster)))
    }

    /** Returns the colour and the texture that the user chose, or null. */
    private fun paint(scene: Scene): Paint? {
        val file = subject.texture ?: return subject.color?.let { Paint(it, null) }
        val texture = Scenes.texture(file, subject.loading.limits)
        val bare = scene.surfaces.count { !it.hasUvs(0) }
        if (bare > 0) {
            val all = scene.surfaces.size
            if (bare == all) throw Mistake("--texture: ${input.name} has no texture coordinates")
            streams.warning("$bare of $all surfaces have no texture coordinates, so --texture has no effect on them")
        }
        return Paint(subject.color, texture)
    }

    private fun camera(scene: Scene, raster: Raster): Camera = try {
        scene.camera(raster.width, raster.height)
    } catch (e: IllegalArgumentException) {
        throw Mistake("there is no such camera: ${e.message}")
    }

    /** Applies the options that change [material]. What would take precedence over other shading is removed. */
    private fun changed(material: Material): Material {
        val shaded = subject.shading?.let { material.withShading(it).withShader(null).withMetallicRoughness(null) }
        return (shaded ?: material).let { if (subject.mipFilter == null) it else it.withMipFilter(subject.mipFilter) }
    }

    /** Replaces what the user asked for of the tone mapping that [scene] would have. */
    private fun toned(scene: Scene): Scene {
        if (subject.toneCurve == null && subject.exposure == null) return scene
        val own = scene.effectiveToneMapping
        return scene.withToneMapping(ToneMapping(subject.toneCurve ?: own.curve, subject.exposure ?: own.exposure))
    }

    private fun raster(scene: Scene, loaded: LoadedScene): Raster {
        val size = subject.size ?: loaded.size ?: DEFAULT_SIZE
        val depth = subject.depthConvention?.let { DepthRules(it) } ?: loaded.depth
        return depth.raster(size.width, size.height, subject.background?.color ?: scene.background)
    }

    private fun region(raster: Raster): Region {
        val region = subject.region ?: return raster.region
        if (raster.region.contains(region)) return region
        val text = "${region.columnStart},${region.rowStart},${region.width}x${region.height}"
        throw Mistake("--region $text reaches beyond the whole picture, which is ${raster.width}x${raster.height}")
    }

    companion object {
        /** The size of a picture that neither the options nor the input choose. */
        val DEFAULT_SIZE = ImageSize(640, 480)
        private const val MAX_WARNINGS = 20
    }
}

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
