package dev.lazyz.scenes.fuzz

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.Renderers
import java.nio.file.Files
import java.nio.file.Path

/**
 * Loads an input as a stream of the format called [id], or as the file that the built-in [Companions.OBJ] refers to,
 * and draws a small picture with the renderer that is taken where nobody chooses.
 *
 * @param id a format's, or [FuzzTarget.MTL]
 * @param folder where the input finds the files it refers to
 */
internal class LoadAndDraw(private val id: String, private val folder: Path) : SceneCase {
    private val format = SceneFormat.entries.firstOrNull { it.id == id }
    private val limits = LoadLimits(decodedBytes = MOST_DECODED)
    private var loaded: LoadedScene? = null

    override fun load(bytes: ByteArray): SceneCase.Loaded {
        loaded = null
        return try {
            val scene = read(bytes)
            loaded = scene
            SceneCase.Loaded(true, scene.warnings)
        } catch (e: SceneFormatException) {
            SceneCase.Loaded(false, listOf(e.message.orEmpty()))
        }
    }

    private fun read(bytes: ByteArray): LoadedScene {
        if (format != null) return Scenes.load(bytes.inputStream(), format, "input", folder, limits)
        Files.write(folder.resolve(Companions.LIBRARY), bytes)
        return Scenes.load(Companions.OBJ.byteInputStream(), SceneFormat.OBJ, "input", folder, limits)
    }

    override fun draw() {
        val scene = loaded ?: return
        Renderers.builtIn.first().render(scene.scene.frame(scene.raster(SIDE, SIDE)))
    }

    private companion object {
        /** Less than the default, which lets a small file take 128 MiB: what is drawn is to be drawn soon. */
        const val MOST_DECODED = 8L shl 20
        const val SIDE = 16
    }
}
