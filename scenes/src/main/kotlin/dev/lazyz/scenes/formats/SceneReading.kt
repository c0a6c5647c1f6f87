package dev.lazyz.scenes.formats

import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.StreamedScene
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.FileBytes
import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.loading.TextEncoding
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.obj.ObjStreaming
import dev.lazyz.scenes.off.OffHeader
import dev.lazyz.scenes.off.OffParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.scenes.ply.PlyStreaming
import dev.lazyz.scenes.scenefile.SceneFileReader
import dev.lazyz.scenes.stl.StlBinary
import dev.lazyz.scenes.stl.StlParser
import dev.lazyz.scenes.stl.StlStreaming
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.scenes.threemf.ThreeMfParser
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.StreamedMesh
import java.io.InputStream
import java.nio.file.Path

/** Reads a file or a stream and passes it to the parser of its format. */
internal object SceneReading {
    /** Reads a file of the given format, or of the format detected from its content if [format] is null. */
    fun read(path: Path, format: SceneFormat?, options: LoadOptions): LoadedScene {
        val folder = path.toAbsolutePath().parent
        return read(path, format, Loading(options), folder)
    }

    /** Reads a file as part of a larger [loading]. Its references must not lead out of [root]. */
    fun read(path: Path, format: SceneFormat?, loading: Loading, root: Path?): LoadedScene {
        val name = path.toString()
        val source =
            Source(FileBytes.of(path, name, format, loading), name, path.toAbsolutePath().parent, loading, root)
        return parse(source, format)
    }

    fun read(input: InputStream, format: SceneFormat, name: String, folder: Path?, options: LoadOptions): LoadedScene {
        val loading = Loading(options)
        return parse(Source(FileBytes.of(input, name, format, loading), name, folder, loading), format)
    }

    fun read(bytes: ByteArray, format: SceneFormat, name: String, options: LoadOptions): LoadedScene {
        FileBytes.requireFits(bytes.size.toLong(), name, format, options.limits)
        return parse(Source(bytes, name, null, Loading(options)), format)
    }

    /** Parses [source] in the given format, or in the format detected from its content if [given] is null. */
    private fun parse(source: Source, given: SceneFormat?): LoadedScene {
        source.requireContent()
        val format = given ?: sniffed(source)
        val parser = when (format) {
            SceneFormat.OBJ -> ObjParser
            SceneFormat.STL -> StlParser
            SceneFormat.PLY -> PlyParser
            SceneFormat.OFF -> OffParser
            SceneFormat.THREE_MF -> ThreeMfParser
            SceneFormat.GLTF, SceneFormat.GLB -> GltfParser
            SceneFormat.SCENE -> return SceneFileReader(source) { file, known ->
                read(file, known, source.loading, source.folder)
            }.read()
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
        FileBytes.requireFits(source.bytes.size.toLong(), source.name, format, source.loading.limits)
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
