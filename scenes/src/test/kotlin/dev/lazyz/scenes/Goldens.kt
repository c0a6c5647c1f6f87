package dev.lazyz.scenes

import dev.lazyz.Capability
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.filter.PixelBackground.VerticalGradient
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Scene

/** The built-in scenes, [GoldenScenes] and [GoldenDrawings], and the identities of their pictures as committed. */
internal object Goldens {
    private val features = GoldenScenes.all + GoldenDrawings.all

    /** By name, SHA-256 of the pixels. */
    val hashes: Map<String, String> =
        checkNotNull(javaClass.getResource("goldens.txt")).readText().lines()
            .filter { it.isNotBlank() && !it.startsWith("#") }
            .associate { it.substringBeforeLast(' ') to it.substringAfterLast(' ') }

    /** All pictures; a scene that is translucent is there as opaque too. */
    val pictures: List<GoldenPicture> =
        Scenes.builtins.flatMap { plain(it.id, it.scene(), 64, 64) + plain(it.id, it.scene(), 160, 120) } +
            features.flatMap { (id, scene) -> plain(id, scene(), 96, 72) } +
            GoldenSampling.all.flatMap { sampling -> sampling.scenes.map { sampled(it, sampling) } }

    private fun plain(id: String, scene: Scene, width: Int, height: Int): List<GoldenPicture> {
        val frame = SuperSampling.NONE.frame(scene, Raster(width, height, scene.background))
        val picture = GoldenPicture("$id ${width}x$height", frame)
        if (!frame.frame.hasTranslucency) return listOf(picture)
        return listOf(picture, GoldenPicture("${picture.name} opaque", frame.asOpaque()))
    }

    /** As few pixels as show the feature: there are several samples in each. */
    private fun sampled(id: String, how: GoldenSampling): GoldenPicture {
        val scene = features.getValue(id)()
        val background = if (how.gradient == null) scene.background else Rgba.TRANSPARENT
        val frame = how.sampling.frame(scene, Raster(32, 24, background))
        return GoldenPicture("$id 32x24 ${how.id}", frame, how.gradient)
    }
}

/** A picture that is to be the same by all [renderers] on all machines. */
internal class GoldenPicture(
    val name: String,
    private val frame: SampledFrame,
    private val gradient: VerticalGradient? = null,
) {
    /** The built-in renderers, but for those that cannot blend where that is needed. */
    val renderers: List<Renderer> =
        Renderers.builtIn.filter { !frame.frame.hasTranslucency || Capability.TRANSPARENCY in it.capabilities }

    /** The hash that the picture ought to have, or null if none is committed. */
    val expected: String? get() = Goldens.hashes[name]

    fun hash(renderer: Renderer): String = image(renderer).pixelHash()

    fun image(renderer: Renderer): Image {
        val pixels = frame.pixels
        val collector = Image.Collector(pixels)
        val sink = gradient?.behind(pixels, pixels.rowEnd, collector) ?: collector
        return collector.toImage(frame.render(renderer, sink))
    }
}
