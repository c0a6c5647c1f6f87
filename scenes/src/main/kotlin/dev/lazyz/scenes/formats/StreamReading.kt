package dev.lazyz.scenes.formats

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.scenes.loading.FileBytes
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.obj.ObjStreaming
import dev.lazyz.scenes.ply.PlyStreaming
import dev.lazyz.scenes.stl.StlStreaming
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.StreamedMesh
import java.io.InputStream
import java.nio.file.Path

/** Opens a file or a stream to be read part by part. */
internal object StreamReading {
    /** Opens a file of the given format, or of the format detected from its content if [format] is null. */
    fun open(path: Path, format: SceneFormat?, limits: LoadLimits, spool: Path): StreamedScene {
        val name = path.toString()
        FileBytes.requireFile(path, name)
        return opened(name, format, limits) { StreamedInput.ofFile(path, name, spool, limits.spoolBytes) }
    }

    /** Opens a stream of the given format. */
    fun open(input: InputStream, format: SceneFormat, name: String, limits: LoadLimits, spool: Path): StreamedScene =
        opened(name, format, limits) { loading -> StreamedInput.ofStream(input, name, spool, loading) }

    private fun opened(
        name: String,
        format: SceneFormat?,
        limits: LoadLimits,
        open: (Loading) -> StreamedInput,
    ): StreamedScene = FileBytes.readable(name) {
        val loading = Loading(LoadOptions(limits))
        val input = open(loading)
        try {
            val head = input.head()
            val source = Source(head, name, null, loading)
            source.requireContent()
            val known = format ?: FormatSniffer.format(head, input.file.size)
            val triangles = when (known) {
                SceneFormat.STL -> StlStreaming.open(source, input)
                SceneFormat.PLY -> PlyStreaming.open(source, input)
                SceneFormat.OBJ -> ObjStreaming.open(source, input)
                else -> source.fail(null, "cannot be read part by part: only STL, PLY and OBJ can", "read it whole")
            }
            val mesh = StreamedMesh(triangles)
            StreamedScene(LoadedScene(Scene(listOf(mesh)), source.warnings, format = known), input)
        } catch (e: Throwable) {
            input.close()
            throw e
        }
    }
}
