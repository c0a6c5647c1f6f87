package dev.lazyz.scenes

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.strategies.Renderers

/** The built-in scenes and [GoldenScenes], and the identities of their pictures as they are committed. */
internal object Goldens {
    private val scenes = Scenes.builtins.associate { it.id to it::scene } + GoldenScenes.all

    /** By name, SHA-256 of the pixels. */
    val hashes: Map<String, String> =
        checkNotNull(javaClass.getResource("goldens.txt")).readText().lines()
            .filter { it.isNotBlank() && !it.startsWith("#") }
            .associate { it.substringBeforeLast(' ') to it.substringAfterLast(' ') }

    /** All pictures; a scene that is translucent is there as opaque too. */
    val pictures: List<GoldenPicture> = scenes.flatMap { (id, scene) ->
        val sizes = if (id in GoldenScenes.all) listOf(96 to 72) else listOf(64 to 64, 160 to 120)
        sizes.flatMap { (width, height) ->
            val frame = scene().frame(width, height)
            val picture = GoldenPicture("$id ${width}x$height", frame)
            if (frame.hasTranslucency) {
                listOf(picture, GoldenPicture("${picture.name} opaque", frame.asOpaque()))
            } else {
                listOf(picture)
            }
        }
    }
}

/** A picture that is to be the same by all [renderers] on all machines. */
internal class GoldenPicture(val name: String, private val frame: Frame) {
    /** The built-in renderers, but for those that cannot blend where that is needed. */
    val renderers: List<Renderer> =
        Renderers.builtIn.filter { !frame.hasTranslucency || Capability.TRANSPARENCY in it.capabilities }

    /** The hash that the picture ought to have, or null if none is committed. */
    val expected: String? get() = Goldens.hashes[name]

    fun hash(renderer: Renderer): String = renderer.render(frame).pixelHash()
}
