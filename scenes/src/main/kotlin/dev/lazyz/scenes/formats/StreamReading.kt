package dev.lazyz.scenes.formats

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.stl.StlStreaming
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.StreamedMesh
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** Opens a file to be read part by part. */
internal object StreamReading {
    /** Opens a file of the given format, or of the format detected from its content if [format] is null. */
    fun open(path: Path, format: SceneFormat?, limits: LoadLimits, spool: Path): StreamedScene {
        val name = path.toString()
        SceneReading.requireFile(path, name)
        try {
            val head = Files.newInputStream(path).use { it.readNBytes(StreamedInput.HEAD) }
            val source = Source(head, name, path.toAbsolutePath().parent, Loading(LoadOptions(limits)))
            if (head.isEmpty()) source.fail(null, "is empty", "check that it was written completely")
            val known = format ?: FormatSniffer.format(head)
            if (known != SceneFormat.STL) {
                source.fail(null, "cannot be streamed: only STL can", "load it whole")
            }
            val input = StreamedInput(path, source, spool)
            try {
                val mesh = StreamedMesh(StlStreaming.open(input))
                return StreamedScene(LoadedScene(Scene(listOf(mesh)), source.warnings.toList()), input)
            } catch (e: Throwable) {
                input.close()
                throw e
            }
        } catch (e: IOException) {
            throw SceneReading.unreadable(name, e)
        }
    }
}
