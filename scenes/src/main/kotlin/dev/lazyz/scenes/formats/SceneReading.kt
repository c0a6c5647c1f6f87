package dev.lazyz.scenes.formats

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneMemoryException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.LoadingMemory
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.off.OffParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.scenes.scenefile.SceneFileReader
import dev.lazyz.scenes.stl.StlParser
import dev.lazyz.scenes.threemf.ThreeMfParser
import dev.lazyz.world.material.Texture
import java.io.IOException
import java.io.InputStream
import java.nio.file.AccessDeniedException
import java.nio.file.Files
import java.nio.file.Path

/** Reads a file or a stream and passes it to the parser of its format. */
internal object SceneReading {
    /** Maximum number of bytes per read call. */
    private const val PIECE = 1 shl 20

    /** Reads a file of the given format, or of the format detected from its content if [format] is null. */
    fun read(path: Path, format: SceneFormat?, options: LoadOptions): LoadedScene {
        val folder = path.toAbsolutePath().parent
        return read(path, format, Loading(options), folder)
    }

    /** Reads a file as part of a larger [loading]. Its references must not lead out of [root]. */
    fun read(path: Path, format: SceneFormat?, loading: Loading, root: Path?): LoadedScene {
        val name = path.toString()
        val source =
            Source(bytes(path, name, format, loading.limits), name, path.toAbsolutePath().parent, loading, root)
        return parse(source, format ?: sniffed(source))
    }

    fun read(
        input: InputStream,
        format: SceneFormat,
        name: String,
        folder: Path?,
        options: LoadOptions,
    ): LoadedScene {
        val source = try {
            Source(bytes(input, 0, name, format, options.limits), name, folder, Loading(options))
        } catch (e: IOException) {
            throw unreadable(name, e)
        }
        return parse(source, format)
    }

    fun read(bytes: ByteArray, format: SceneFormat, name: String, options: LoadOptions): LoadedScene {
        if (bytes.size > mostBytes(format, options.limits)) {
            throw tooLarge(name, bytes.size.toLong(), format, options.limits)
        }
        return parse(Source(bytes, name, null, Loading(options)), format)
    }

    /** Reads an image file as a texture. */
    fun texture(path: Path, limits: LoadLimits): Texture {
        val name = path.toString()
        val source = Source(bytes(path, name, null, limits), name, null, Loading(LoadOptions(limits)))
        return TextureFiles.decode(source, source.bytes, path.fileName.toString())
            ?: source.fail(null, "is not an image that can be read", "save it as PNG or JPEG")
    }

    private fun parse(source: Source, format: SceneFormat): LoadedScene {
        if (source.bytes.isEmpty()) source.fail(null, "is empty", "check that it was written completely")
        val parser = when (format) {
            SceneFormat.OBJ -> ObjParser
            SceneFormat.STL -> StlParser
            SceneFormat.PLY -> PlyParser
            SceneFormat.OFF -> OffParser
            SceneFormat.THREE_MF -> ThreeMfParser
            SceneFormat.GLTF, SceneFormat.GLB -> GltfParser
            SceneFormat.SCENE -> return SceneFileReader(source).read()
        }
        if (parser != GltfParser && source.loading.options.animationTime != null) {
            source.warn("files of this format have no animation, so the requested time has no effect")
        }
        try {
            val scene = parser.parse(source)
            return LoadedScene(
                scene, source.warnings,
                cameras = source.cameras.toList(), files = source.files, format = format,
            )
        } catch (e: OutOfMemoryError) {
            val most = source.loading.limits.usableMemory
            source.exhausted("needs more memory than the $most bytes that Java may use", "raise -Xmx, or split it", e)
        }
    }

    private fun bytes(path: Path, name: String, format: SceneFormat?, limits: LoadLimits): ByteArray {
        requireFile(path, name)
        try {
            val size = Files.size(path)
            if (size > mostBytes(format, limits)) throw tooLarge(name, size, format, limits)
            return Files.newInputStream(path).use { bytes(it, size.toInt(), name, format, limits) }
        } catch (e: IOException) {
            throw unreadable(name, e)
        }
    }

    /** Fails unless [path] is a regular file. */
    fun requireFile(path: Path, name: String) {
        if (!Files.exists(path)) throw SceneReadException(name, "there is no such file", "check the name")
        if (Files.isDirectory(path)) throw SceneReadException(name, "is a folder", "name a file in it")
        if (!Files.isRegularFile(path)) {
            throw SceneReadException(name, "is a pipe or a device, not a file", "send its bytes as a stream")
        }
    }

    /** Returns the exception for a file that cannot be read. */
    fun unreadable(name: String, e: IOException): SceneReadException = if (e is AccessDeniedException) {
        SceneReadException(name, "cannot be read: permission denied", "ask for permission", e)
    } else {
        SceneReadException(name, "cannot be read: ${e.message ?: e}", cause = e)
    }

    /**
     * Reads all of [input]: first the [expected] bytes, directly into their array, then any further bytes of the
     * stream.
     */
    private fun bytes(
        input: InputStream,
        expected: Int,
        name: String,
        format: SceneFormat?,
        limits: LoadLimits,
    ): ByteArray {
        val bytes = ByteArray(expected)
        var count = 0
        while (count < expected) {
            val read = input.read(bytes, count, minOf(PIECE, expected - count))
            if (read < 0) return bytes.copyOf(count)
            count += read
        }
        val room = mostBytes(format, limits) - expected
        val rest = input.readNBytes(room.toInt() + 1)
        if (rest.size > room) throw tooLarge(name, expected + rest.size.toLong(), format, limits)
        return if (rest.isEmpty()) bytes else bytes + rest
    }

    /**
     * Maximum bytes of a file of [format]: it must fit into an array, and its decoded contents must fit into the
     * heap.
     */
    private fun mostBytes(format: SceneFormat?, limits: LoadLimits): Long =
        minOf(Int.MAX_VALUE - 16L, limits.usableMemory / LoadingMemory.perByte(format))

    private fun tooLarge(name: String, size: Long, format: SceneFormat?, limits: LoadLimits): SceneMemoryException {
        val problem = "is too large: $size bytes, at most ${mostBytes(format, limits)} fit"
        return SceneMemoryException(name, problem, "raise -Xmx, or split it")
    }

    private fun sniffed(source: Source): SceneFormat {
        if (source.bytes.isEmpty()) source.fail(null, "is empty", "check that it was written completely")
        val known = SceneFormat.entries.flatMap { it.extensions }.joinToString { ".$it" }
        val format =
            FormatSniffer.format(source.bytes) ?: source.fail(null, "is of no known format", "known are $known")
        val limits = source.loading.limits
        if (source.bytes.size > mostBytes(format, limits)) {
            throw tooLarge(source.name, source.bytes.size.toLong(), format, limits)
        }
        return format
    }
}
