package dev.lazyz.scenes

import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.scenes.scenefile.SceneFileReader
import dev.lazyz.scenes.stl.StlParser
import java.io.IOException
import java.io.InputStream
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.Path

/** From a file or a stream to the parser of its format. */
internal object SceneReading {
    /** An array cannot be longer, nor can a file be read that leaves no memory for what is in it. */
    private val maxBytes: Long get() = minOf(Int.MAX_VALUE - 16L, Runtime.getRuntime().maxMemory() / 4)

    /** Reads a file of the given format, or of the one that its content looks like. */
    fun read(path: Path, format: SceneFormat?, limits: LoadLimits): LoadedScene {
        val folder = path.toAbsolutePath().parent
        return read(path, format, Loading(limits), folder)
    }

    /** Reads a file as a part of a larger reading, whose references must not lead out of [root]. */
    fun read(path: Path, format: SceneFormat?, loading: Loading, root: Path?): LoadedScene {
        val name = path.toString()
        val source = Source(bytes(path, name), name, path.toAbsolutePath().parent, loading, root)
        return parse(source, format ?: sniffed(source))
    }

    fun read(
        input: InputStream,
        format: SceneFormat,
        name: String,
        folder: Path?,
        limits: LoadLimits,
    ): LoadedScene {
        val limit = maxBytes.toInt()
        val bytes = try {
            input.readNBytes(limit)
        } catch (e: IOException) {
            throw SceneFormatException(name, null, "cannot be read: ${e.message ?: e}", cause = e)
        }
        if (bytes.size == limit) throw tooLarge(name, "$limit bytes or more")
        return parse(Source(bytes, name, folder, Loading(limits)), format)
    }

    private fun parse(source: Source, format: SceneFormat): LoadedScene {
        if (source.bytes.isEmpty()) source.fail(null, "is empty", "check that it was written completely")
        val parser = when (format) {
            SceneFormat.OBJ -> ObjParser
            SceneFormat.STL -> StlParser
            SceneFormat.PLY -> PlyParser
            SceneFormat.GLTF, SceneFormat.GLB -> GltfParser
            SceneFormat.SCENE -> return SceneFileReader(source).read()
        }
        return LoadedScene(parser.parse(source), source.warnings.toList())
    }

    private fun bytes(path: Path, name: String): ByteArray {
        if (!Files.exists(path)) throw SceneFormatException(name, null, "there is no such file", "check the name")
        if (Files.isDirectory(path)) throw SceneFormatException(name, null, "is a folder", "name a file in it")
        if (!Files.isRegularFile(path)) {
            throw SceneFormatException(name, null, "is a pipe or a device, not a file", "send its bytes as a stream")
        }
        try {
            val size = Files.size(path)
            if (size > maxBytes) throw tooLarge(name, "$size bytes")
            return Files.readAllBytes(path)
        } catch (e: AccessDeniedException) {
            throw SceneFormatException(name, null, "cannot be read: permission denied", "ask for permission", e)
        } catch (e: IOException) {
            throw SceneFormatException(name, null, "cannot be read: ${e.message ?: e}", cause = e)
        }
    }

    private fun tooLarge(name: String, size: String): SceneFormatException =
        SceneFormatException(name, null, "is too large: $size, at most $maxBytes fit", "raise -Xmx, or split it")

    private fun sniffed(source: Source): SceneFormat = FormatSniffer.format(source.bytes) ?: run {
        if (source.bytes.isEmpty()) source.fail(null, "is empty", "check that it was written completely")
        val known = SceneFormat.entries.flatMap { it.extensions }.joinToString { ".$it" }
        source.fail(null, "is of no known format", "known are $known")
    }
}
