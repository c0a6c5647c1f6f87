package dev.lazyz.scenes.formats

import dev.lazyz.RenderOptions
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneMemoryException
import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.images.RadianceImage
import dev.lazyz.scenes.images.TextureFiles
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TextEncoding
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.off.OffHeader
import dev.lazyz.scenes.off.OffParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.scenes.scenefile.SceneFileReader
import dev.lazyz.scenes.stl.StlBinary
import dev.lazyz.scenes.stl.StlParser
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.threemf.ThreeMfParser
import dev.lazyz.world.EnvironmentMap
import dev.lazyz.world.material.Texture
import java.io.IOException
import java.io.InputStream
import java.nio.channels.ClosedByInterruptException
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
        val source = Source(bytes(path, name, format, loading), name, path.toAbsolutePath().parent, loading, root)
        return parse(source, format)
    }

    fun read(input: InputStream, format: SceneFormat, name: String, folder: Path?, options: LoadOptions): LoadedScene {
        val loading = Loading(options)
        val bytes = readable(name) { bytes(input, 0, name, format, loading) }
        return parse(Source(bytes, name, folder, loading), format)
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
        val loading = Loading(LoadOptions(limits))
        val source = Source(bytes(path, name, null, loading), name, null, loading)
        return TextureFiles.decode(source, source.bytes, path.fileName.toString())
            ?: TextureFiles.refusal(source.bytes)?.let { source.fail(null, "cannot be decoded: it is $it") }
            ?: source.fail(null, "is not an image that can be read", "save it as PNG or JPEG")
    }

    /** Reads a picture of surroundings, and passes warnings to [warn]. */
    fun environment(path: Path, limits: LoadLimits, options: RenderOptions, warn: (String) -> Unit): EnvironmentMap {
        val name = path.toString()
        val loading = Loading(LoadOptions(limits))
        val source = Source(bytes(path, name, null, loading), name, null, loading)
        requireContent(source)
        return RadianceImage.read(source, options).also { source.warnings.forEach(warn) }
    }

    /** Parses [source] in the given format, or in the format detected from its content if [given] is null. */
    private fun parse(source: Source, given: SceneFormat?): LoadedScene {
        requireContent(source)
        val format = given ?: sniffed(source)
        val parser = when (format) {
            SceneFormat.OBJ -> ObjParser
            SceneFormat.STL -> StlParser
            SceneFormat.PLY -> PlyParser
            SceneFormat.OFF -> OffParser
            SceneFormat.THREE_MF -> ThreeMfParser
            SceneFormat.GLTF, SceneFormat.GLB -> GltfParser
            SceneFormat.SCENE -> return SceneFileReader(source).read()
        }
        if (parser != GltfParser) warnOfChoices(source)
        try {
            val scene = parser.parse(source)
            return LoadedScene(
                scene, source.warnings,
                cameras = source.cameras.toList(), files = source.files, format = format, unit = source.unit,
            )
        } catch (e: OutOfMemoryError) {
            val most = source.loading.limits.usableMemory
            source.exhausted("needs more memory than the $most bytes that Java may use", "raise -Xmx, or split it", e)
        }
    }

    private fun bytes(path: Path, name: String, format: SceneFormat?, loading: Loading): ByteArray {
        requireFile(path, name)
        return readable(name) {
            val size = Files.size(path)
            if (size > mostBytes(format, loading.limits)) throw tooLarge(name, size, format, loading.limits)
            Files.newInputStream(path).use { bytes(it, size.toInt(), name, format, loading) }
        }
    }

    /** Returns what [read] returns. Whatever else stops it becomes an exception that names the file. */
    private inline fun readable(name: String, read: () -> ByteArray): ByteArray = try {
        read()
    } catch (e: SceneFormatException) {
        throw e
    } catch (e: IOException) {
        throw unreadable(name, e)
    }

    /** Fails unless [path] is a regular file. */
    fun requireFile(path: Path, name: String) {
        if (!Files.exists(path)) throw SceneReadException(name, "there is no such file", "check the name")
        if (Files.isDirectory(path)) throw SceneReadException(name, "is a folder", "name a file in it")
        if (!Files.isRegularFile(path)) {
            throw SceneReadException(name, "is a pipe or a device, not a file", "send its bytes as a stream")
        }
    }

    /** Fails if [source] has no bytes. Parsers need not look. */
    fun requireContent(source: Source) {
        if (source.bytes.isEmpty()) source.fail(null, "is empty", "check that it was written completely")
    }

    /** Returns the exception for a file that cannot be read. An interrupt closes channels. */
    fun unreadable(name: String, e: IOException): SceneReadException = when (e) {
        is ClosedByInterruptException -> SceneReadException(name, Loading.INTERRUPTED, cause = e)
        is AccessDeniedException ->
            SceneReadException(name, "cannot be read: permission denied", "ask for permission", e)
        else -> SceneReadException(name, "cannot be read: ${e.message ?: e}", cause = e)
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
        loading: Loading,
    ): ByteArray {
        val bytes = ByteArray(expected)
        val first = fill(bytes, input, name, loading)
        if (first < expected) return bytes.copyOf(first)

        // Further bytes, if there are any
        val most = mostBytes(format, loading.limits)
        val pieces = ArrayList<ByteArray>()
        var size = expected.toLong()
        do {
            val piece = ByteArray(PIECE)
            val count = fill(piece, input, name, loading)
            size += count
            if (size > most) throw tooLarge(name, size, format, loading.limits)
            if (count > 0) pieces.add(if (count < PIECE) piece.copyOf(count) else piece)
        } while (count == PIECE)
        if (pieces.isEmpty()) return bytes
        val all = bytes.copyOf(size.toInt())
        for ((i, piece) in pieces.withIndex()) piece.copyInto(all, expected + i * PIECE)
        return all
    }

    /** Reads bytes until [into] is full or [input] ends, and returns their number. */
    private fun fill(into: ByteArray, input: InputStream, name: String, loading: Loading): Int {
        var count = 0
        while (count < into.size) {
            loading.look(name)
            val read = input.read(into, count, minOf(PIECE, into.size - count))
            if (read < 0) break
            count += read
        }
        return count
    }

    /**
     * Maximum bytes of a file of [format]: it must fit into an array, and its decoded contents must fit into the
     * heap.
     */
    private fun mostBytes(format: SceneFormat?, limits: LoadLimits): Long =
        minOf(Int.MAX_VALUE - 16L, limits.usableMemory / SceneFormat.memoryPerByte(format))

    private fun tooLarge(name: String, size: Long, format: SceneFormat?, limits: LoadLimits): SceneMemoryException {
        val problem = "is too large: $size bytes, at most ${mostBytes(format, limits)} fit"
        return SceneMemoryException(name, problem, "raise -Xmx, or split it")
    }

    private fun warnOfChoices(source: Source) {
        val options = source.loading.options
        val choices = listOf(
            Triple(options.animationTime, "animation", "time"), Triple(options.variant, "variants", "variant"),
            Triple(options.sceneNumber, "further scenes", "scene"),
        )
        for ((choice, what, wanted) in choices) {
            if (choice == null) continue
            source.warn("files of this format have no $what, so the requested $wanted has no effect")
        }
    }

    private fun sniffed(source: Source): SceneFormat {
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

/** Detects a file's format from its first bytes, for files whose name does not determine it. */
internal object FormatSniffer {
    private const val HEAD = 4096

    private val objWords = setOf("v", "vt", "vn", "f", "o", "g", "s", "mtllib", "usemtl")

    /** Returns the format that a file of [size] bytes looks like, whose first are [bytes], or null. */
    fun format(bytes: ByteArray, size: Long = bytes.size.toLong()): SceneFormat? {
        val head = TextEncoding.start(bytes, HEAD)
        return when {
            head.startsWith("glTF") -> SceneFormat.GLB
            head.startsWith("ply\n") || head.startsWith("ply\r") -> SceneFormat.PLY
            head.startsWith("PK\u0003\u0004") -> SceneFormat.THREE_MF
            isOff(head) -> SceneFormat.OFF
            // A binary STL file has no signature
            StlBinary.isWhole(bytes, size) -> SceneFormat.STL
            head.trimStart().startsWith("solid") && "facet" in head -> SceneFormat.STL
            head.trimStart().startsWith('{') -> jsonFormat(head)
            isObj(head) -> SceneFormat.OBJ
            else -> null
        }
    }

    private fun jsonFormat(head: String): SceneFormat? = when {
        "\"lazyz\"" in head -> SceneFormat.SCENE
        "\"asset\"" in head || "\"accessors\"" in head || "\"buffers\"" in head -> SceneFormat.GLTF
        else -> null
    }

    private fun isOff(head: String): Boolean = OffHeader.isKeyword(head.trimStart().takeWhile { !it.isWhitespace() })

    /** The first line that is not empty and not a comment must be an OBJ statement. */
    private fun isObj(head: String): Boolean {
        val first = head.lineSequence().map { it.trim() }.firstOrNull { it.isNotEmpty() && !it.startsWith('#') }
        val words = first?.let(TextLines::words) ?: return false
        return words.size > 1 && words[0] in objWords
    }
}
