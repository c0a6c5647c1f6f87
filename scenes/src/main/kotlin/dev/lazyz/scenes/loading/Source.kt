package dev.lazyz.scenes.loading

import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.Scenes
import dev.lazyz.scenes.printable
import dev.lazyz.scenes.text.TextEncoding
import dev.lazyz.world.Scene
import java.nio.file.Path

/**
 * Bytes to read a scene from, with what a reader needs to complain about them and to find what they refer to.
 *
 * @param bytes the whole file
 * @property name the file's name as the caller gave it
 * @property folder where relative references are looked up, or null for a stream that has no place
 * @property loading the call of [Scenes.load] that reads it
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
    val references = FileReferences(folder, root, loading.limits.references)

    init {
        loading.read(bytes.size)
    }

    /** What had to be passed over so far; reported by [LoadedScene.warnings]. */
    val warnings = ArrayList<String>()

    /** Turns text with a byte order mark into UTF-8 without one. */
    fun decodeText() {
        if (!TextEncoding.hasMark(bytes)) return
        loading.decode(this, 2L * bytes.size)
        content = TextEncoding.utf8(bytes)
    }

    /** Lets go of the bytes, which have been read, to leave memory for what becomes of them. */
    fun release() {
        content = null
    }

    fun warn(sentence: String) {
        warnings.add(printable("$name: $sentence"))
    }

    fun fail(location: String?, problem: String, remedy: String? = null, cause: Throwable? = null): Nothing =
        throw SceneFormatException(name, location, problem, remedy, cause)
}

/** Reads one format. Throws [SceneFormatException] for bad input, and nothing else. */
internal fun interface SceneParser {
    fun parse(source: Source): Scene
}
