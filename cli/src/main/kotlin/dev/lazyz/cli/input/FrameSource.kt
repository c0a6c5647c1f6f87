package dev.lazyz.cli.input

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.world.Material
import dev.lazyz.world.Scene
import dev.lazyz.world.Shading

/** Reads the input that [subject] names, and creates the frame that the options describe. */
internal class FrameSource(private val subject: Subject, private val streams: Streams) {
    val input = Input(subject.input, subject.format, subject.loading)

    /** Reads the input, and prints its warnings. */
    fun load(): LoadedScene {
        val loaded = read()
        val warnings = loaded.warnings
        warnings.take(MAX_WARNINGS).forEach { streams.warning(it) }
        val rest = warnings.size - MAX_WARNINGS
        if (rest > 0) streams.warning("and $rest more")
        return loaded
    }

    /** Reads the input without printing its warnings. */
    fun read(): LoadedScene {
        streams.progress("reading ${input.name} ...")
        return input.load(streams)
    }

    /**
     * Returns the picture of [loaded], seen from [view] or, if that is null, from the side that the options choose. It
     * is set up by the threads of [options].
     */
    fun frame(loaded: LoadedScene, options: RenderOptions, view: View? = null): Shot {
        // Apply the options of sections, axis, camera, shading and lines
        val cut = subject.lineWork.cut(loaded.scene) { streams.warning(it) }
        val upright = try {
            cut.withUpAxis(subject.up)
        } catch (e: UnsupportedOperationException) {
            throw Mistake("--up: ${e.message}")
        }
        val lineWork = subject.lineWork
        val pointOfView = (if (view == null) subject.pointOfView else subject.pointOfView.from(view))
            .withDefault(lineWork.projection)
        val seen = lineWork.colored(subject.sizes.applyTo(pointOfView.applyTo(upright)), subject.shading != null)
        val shaded = if (subject.shading == null) seen else seen.withMaterials { shaded(it, subject.shading) }
        val scene = lineWork.drawnOn(shaded, subject.translucency)

        // The camera is fitted to the whole raster. The picture may be a part of it
        val raster = raster(scene, loaded)
        val region = region(raster)
        streams.progress("setting up ${raster.width}x${raster.height} ...")
        val sampling = SuperSampling(subject.samples)
        val frame = samples(sampling, scene, raster, options).within(sampling.samples(region))
        return Shot(if (subject.translucency == Translucency.OPAQUE) frame.asOpaque() else frame, sampling)
    }

    private fun samples(sampling: SuperSampling, scene: Scene, raster: Raster, options: RenderOptions): Frame {
        // With one sample a pixel, an exception is not the user's mistake
        if (sampling.factor == 1) return scene.frame(raster, options)
        return try {
            sampling.frame(scene, raster, options)
        } catch (e: UnsupportedOperationException) {
            throw Mistake("--aa ${sampling.factor}: ${e.message}; use --aa 1")
        } catch (e: IllegalArgumentException) {
            throw Mistake("--aa ${sampling.factor}: ${e.message}")
        }
    }

    /** Replaces the shading of [material]. Removes its custom shader, too, which would take precedence. */
    private fun shaded(material: Material, shading: Shading): Material =
        material.withShading(shading).withShader(null)

    private fun raster(scene: Scene, loaded: LoadedScene): Raster {
        val size = subject.size ?: loaded.size ?: DEFAULT_SIZE
        val depth = subject.depthConvention?.let { DepthRules(it) } ?: loaded.depth
        return depth.raster(size.width, size.height, subject.background ?: scene.background)
    }

    private fun region(raster: Raster): Region {
        val region = subject.region ?: return raster.region
        if (raster.region.contains(region)) return region
        val text = "${region.columnStart},${region.rowStart},${region.width}x${region.height}"
        throw Mistake("--region $text reaches beyond the whole picture, which is ${raster.width}x${raster.height}")
    }

    private companion object {
        val DEFAULT_SIZE = ImageSize(640, 480)
        const val MAX_WARNINGS = 20
    }
}
