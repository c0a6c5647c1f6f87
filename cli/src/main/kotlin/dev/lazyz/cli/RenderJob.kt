package dev.lazyz.cli

import dev.lazyz.Material
import dev.lazyz.Raster
import dev.lazyz.Scene
import dev.lazyz.Shading
import dev.lazyz.scenes.ImageSize

/** One run of `zcli render`: input, camera, raster, rows to all sinks at once, statistics. */
internal class RenderJob(private val request: RenderRequest, private val streams: Streams) {
    fun run() {
        // Find the user's mistakes before the work begins
        val input = Input(request.input, request.format)
        val renderer = Strategies.find(request.strategy)
        val outputs = Outputs(request, input, streams)

        streams.progress("reading ${input.name} ...")
        val loaded = input.load(streams)
        warn(loaded.warnings)

        val start = System.nanoTime()
        val scene = asRequested(loaded.scene)
        val raster = raster(scene, loaded.size)
        MemoryNeed.check(renderer, raster)
        streams.progress("setting up ${raster.width}x${raster.height} ...")
        val frame = scene.frame(raster)
        streams.progress("rendering ${frame.primitives.size} primitives ...")
        val tally = Tally(raster.width, request.stats != null)
        val counters = outputs.write(raster, tally) { sink -> renderer.render(frame, sink) }
        val nanoseconds = System.nanoTime() - start

        if (tally.visible == 0L) streams.warning("nothing is visible: the picture is all background")
        outputs.describe(raster)
        val form = request.stats ?: return
        tell(form, Statistics(input.name, renderer.id, raster, counters, tally, loaded.warnings.size, nanoseconds))
    }

    private fun asRequested(loaded: Scene): Scene {
        val upright = if (request.up == Up.Z) UpAxis.fromZ(loaded) else loaded
        val seen = request.pointOfView.applyTo(upright)
        val shading = request.shading ?: return seen
        return seen.withMaterials { shaded(it, shading) }
    }

    /** Shading by name replaces a material's own shader too, or it would change nothing. */
    private fun shaded(material: Material, shading: Shading): Material = Material(
        material.baseColor,
        material.texture,
        shading,
        material.specular,
        material.shininess,
        material.emission,
        material.alphaMode,
        material.alphaCutoff,
        material.sides,
        null,
        material.name,
    )

    private fun raster(scene: Scene, own: ImageSize?): Raster {
        val size = request.size ?: own ?: DEFAULT_SIZE
        return Raster(size.width, size.height, request.background ?: scene.background, request.depthConvention)
    }

    private fun warn(warnings: List<String>) {
        warnings.take(MAX_WARNINGS).forEach { streams.warning(it) }
        val rest = warnings.size - MAX_WARNINGS
        if (rest > 0) streams.warning("and $rest more")
    }

    /** Statistics go where a script can read them, and never into the picture. */
    private fun tell(form: StatsForm, statistics: Statistics) {
        val text = if (form == StatsForm.JSON) statistics.toJson() + "\n" else StatisticsTable.of(statistics)
        if (request.output == Outputs.STANDARD_OUTPUT) streams.messages.print(text) else streams.print(text)
    }

    private companion object {
        val DEFAULT_SIZE = ImageSize(640, 480)
        const val MAX_WARNINGS = 20
    }
}
