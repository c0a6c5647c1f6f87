package dev.lazyz.scenes.loading

import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.NamedCamera
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.SceneMemoryException
import dev.lazyz.scenes.printable
import dev.lazyz.world.Scene
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.InputStreamReader
import java.io.OutputStreamWriter
import java.nio.charset.Charset
import java.nio.file.Path

/**
 * The bytes of a scene, with the data that a reader needs to report errors and to find the files that the scene
 * refers to.
 *
 * @param bytes the whole file
 * @property name the file's name as the caller gave it
 * @property folder the folder for relative references, or null for a stream, which has no folder
 * @property loading the call of `Scenes.load` that reads this source
 * @param root the folder that references must not lead out of
 */
internal class Source(
    bytes: ByteArray,
    val name: String,
    val folder: Path?,
    val loading: Loading = Loading(),
    root: Path? = folder,
) {
    private var content: ByteArray? = bytes

    val bytes: ByteArray get() = checkNotNull(content) { "the bytes were released" }

    /** Finds files that the scene refers to. */
    val references = FileReferences(folder, root, loading.limits.references, loading.files) { loading.look(name) }

    init {
        loading.read(bytes.size)
    }

    private val allWarnings = Warnings()

    /** Warnings about what was ignored so far; reported by [LoadedScene.warnings]. */
    val warnings: List<String> get() = allWarnings.toList()

    /** Cameras of the model so far; reported by [LoadedScene.cameras]. */
    val cameras = ArrayList<NamedCamera>()

    /** The unit of lengths, if it is known; reported by [LoadedScene.unit]. */
    var unit: LengthUnit? = null

    /** The files that it refers to, found so far; reported by [LoadedScene.files]. */
    val files: List<Path> get() = loading.files.toList()

    /** Converts text with a byte order mark into UTF-8 without one. */
    fun decodeText() {
        if (!TextEncoding.hasMark(bytes)) return
        loading.decode(this, 2L * bytes.size)
        content = TextEncoding.utf8(this)
    }

    /** Fails if the text has a byte order mark, for readers that do not have all of the text. */
    fun requireNoMark() {
        if (TextEncoding.hasMark(bytes)) {
            fail(null, "begins with a byte order mark", "save it as plain ASCII to stream it")
        }
    }

    /** Fails if there are no bytes. Parsers need not look. */
    fun requireContent() {
        if (bytes.isEmpty()) fail(null, "is empty", "check that it was written completely")
    }

    /** Counts [steps] of work, see [Loading.step]. */
    fun step(steps: Int = 1): Unit = loading.step(this, steps)

    /** Releases the bytes after they have been read, to free memory for the decoded data. */
    fun release() {
        content = null
    }

    /** Adds a warning, unless it is there already. */
    fun warn(sentence: String): Unit = warn(sentence, "", "")

    /**
     * Adds the warning [before] [subject] [after]. Those that differ only in their [subject] become one.
     */
    fun warn(before: String, subject: String, after: String) {
        allWarnings.add(printable("$name: $before"), printable(subject), printable(after))
    }

    /** Adds the warnings about a file that it refers to. */
    fun warnAll(loaded: LoadedScene) {
        loaded.warnings.forEach { allWarnings.add(it, "", "") }
    }

    fun fail(location: String?, problem: String, remedy: String? = null, cause: Throwable? = null): Nothing =
        throw SceneFormatException(name, location, problem, remedy, cause)

    /** Fails because the memory is too small. */
    fun exhausted(problem: String, remedy: String, cause: Throwable? = null): Nothing =
        throw SceneMemoryException(name, problem, remedy, cause)

    companion object {
        /** Returns the bytes of a file that refers to no others. */
        fun ofFile(path: Path, limits: LoadLimits): Source {
            val loading = Loading(LoadOptions(limits))
            return Source(FileBytes.of(path, "$path", null, loading), "$path", null, loading)
        }
    }
}

/** A parser of one format. Throws only [SceneFormatException] for bad input. */
internal fun interface SceneParser {
    fun parse(source: Source): Scene
}

/**
 * Warnings about files: each is there once, and those that differ only in what they are about are one. So a file with a
 * thousand missing textures has one warning about them. Not thread safe.
 */
internal class Warnings {
    /** What each kind of warning is about, by the text before and after it. */
    private val subjects = LinkedHashMap<Pair<String, String>, MutableSet<String>>()

    /** Adds the warning [before] [subject] [after], unless it is there already: some files are read twice. */
    fun add(before: String, subject: String, after: String) {
        subjects.getOrPut(before to after) { LinkedHashSet() }.add(subject)
    }

    /** Returns a sentence for each kind, in the order of their first warnings. */
    fun toList(): List<String> = subjects.map { (text, all) ->
        val (before, after) = text
        val others = all.drop(1)
        val names = others.take(NAMED).joinToString() + if (others.size > NAMED) ", ..." else ""
        before + all.first() + after + if (others.isEmpty()) "" else " (the same for ${others.size} more: $names)"
    }

    private companion object {
        /** How many are named besides the first. */
        const val NAMED = 3
    }
}

/**
 * Text that begins with Unicode's byte order mark, U+FEFF: UTF-16 of either byte order, or UTF-8 (The Unicode
 * Standard, section 23.8). Text without a mark stays unchanged.
 */
internal object TextEncoding {
    private const val PIECE = 8192
    private val marks = mapOf(
        Charsets.UTF_8 to byteArrayOf(0xEF.toByte(), 0xBB.toByte(), 0xBF.toByte()),
        Charsets.UTF_16LE to byteArrayOf(0xFF.toByte(), 0xFE.toByte()),
        Charsets.UTF_16BE to byteArrayOf(0xFE.toByte(), 0xFF.toByte()),
    )

    /** Whether [bytes] begin with a byte order mark. */
    fun hasMark(bytes: ByteArray): Boolean = charset(bytes) != null

    /** Returns the bytes of [source] as UTF-8 without a mark; the same array if there is no mark. */
    fun utf8(source: Source): ByteArray {
        val bytes = source.bytes
        val charset = charset(bytes) ?: return bytes
        val mark = marks.getValue(charset).size
        if (charset == Charsets.UTF_8) return bytes.copyOfRange(mark, bytes.size)
        val out = ByteArrayOutputStream(bytes.size / 2)
        OutputStreamWriter(out, Charsets.UTF_8).use { writer ->
            val reader = InputStreamReader(ByteArrayInputStream(bytes, mark, bytes.size - mark), charset)
            val piece = CharArray(PIECE)
            while (true) {
                val count = reader.read(piece)
                if (count < 0) break
                writer.write(piece, 0, count)
                source.step(count)
            }
        }
        return out.toByteArray()
    }

    /**
     * Returns the text in the first [count] of [bytes] without a mark. Without a mark, decodes as ISO 8859-1, which
     * accepts any bytes.
     */
    fun start(bytes: ByteArray, count: Int): String {
        val length = minOf(bytes.size, count)
        val charset = charset(bytes) ?: return String(bytes, 0, length, Charsets.ISO_8859_1)
        val mark = marks.getValue(charset).size
        return String(bytes, mark, maxOf(length - mark, 0), charset)
    }

    private fun charset(bytes: ByteArray): Charset? =
        marks.entries.firstOrNull { (_, mark) -> startsWith(bytes, mark) }?.key

    private fun startsWith(bytes: ByteArray, mark: ByteArray) =
        bytes.size >= mark.size && mark.indices.all { bytes[it] == mark[it] }
}
