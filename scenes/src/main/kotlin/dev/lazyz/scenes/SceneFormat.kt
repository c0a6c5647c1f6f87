package dev.lazyz.scenes

import dev.lazyz.geometry.UpAxis
import java.io.IOException

/**
 * The file formats that a scene can be read from.
 *
 * @property id lower-case name, used on command lines
 * @property extensions file name extensions, lower case, without a dot
 */
public enum class SceneFormat(public val id: String, public val extensions: List<String>) {
    /** Wavefront OBJ, with its MTL material libraries. */
    OBJ("obj", listOf("obj")),

    /** Stereolithography, ASCII or binary; the content decides which. */
    STL("stl", listOf("stl")),

    /** Polygon File Format, ASCII or binary of either byte order. */
    PLY("ply", listOf("ply")),

    /** Object File Format of Geomview, ASCII. */
    OFF("off", listOf("off")),

    /** 3D Manufacturing Format. */
    THREE_MF("3mf", listOf("3mf")),

    /** glTF 2.0 as JSON with separate or embedded buffers. */
    GLTF("gltf", listOf("gltf")),

    /** glTF 2.0 in one binary file. */
    GLB("glb", listOf("glb")),

    /** Lazy Z's scene file format, JSON. */
    SCENE("scene", listOf("json")),
    ;

    /** The axis that points up in most files of this format: parts for machines lie on the plane of x and y. */
    public val usualUp: UpAxis get() = if (this == STL || this == THREE_MF) UpAxis.Z else UpAxis.Y

    public companion object {
        /**
         * Returns the bytes of memory for each byte of a file of [format] while it is read, including a reserve for the
         * garbage collector; if it is null, the minimum for any format. Measured on meshes that need much of it.
         */
        internal fun memoryPerByte(format: SceneFormat?): Int = when (format) {
            // A triangle is 50 bytes in the file, and takes 80 while its normals are computed
            STL -> 3

            // A triangle of a strip is 4 bytes in the file, and takes about 40 while it is read
            PLY -> 5
            OBJ, OFF -> 8

            // Compressed data is counted when it is decompressed
            GLTF, GLB, SCENE, THREE_MF -> 4
            null -> 2
        }

        /** Returns the format that a file name's extension belongs to, or null. */
        @JvmStatic
        public fun ofFileName(name: String): SceneFormat? {
            val extension = name.substringAfterLast('.', "").lowercase()
            return entries.firstOrNull { extension in it.extensions }
        }
    }
}

/**
 * Reports a file that cannot be read or understood. Every reader of this module throws only this exception for bad
 * input. If the bytes could not be read at all, it is a [SceneReadException].
 *
 * It is an [IOException], so in Java it is caught or declared where a file is read. Only while a scene that is read
 * part by part (`Scenes.stream`) is rendered, it comes as the cause of an [java.io.UncheckedIOException].
 *
 * The message is complete and addressed to the user of the file: where the problem is, what is wrong, what to do. It
 * is safe to print on a terminal: it has no control characters, and words from the file are cut after 400 characters.
 * The properties are not changed in this way.
 *
 * @property source the file's name as the caller gave it, or a name for a stream
 * @property location place within the file, such as `line 12`, `byte 84` or `meshes[2].material`; null if the problem
 *   concerns the whole file
 * @property problem what is wrong, without a full stop
 * @property remedy what to do about it, or null if the only remedy is another file
 */
public open class SceneFormatException @JvmOverloads constructor(
    public val source: String,
    public val location: String?,
    public val problem: String,
    public val remedy: String? = null,
    cause: Throwable? = null,
) : IOException(
    printable(
        buildString {
            append(source)
            if (location != null) append(", ").append(location)
            append(": ").append(problem)
            if (remedy != null) append("; ").append(remedy)
        },
    ),
    cause,
)

/**
 * Reports a file that does not fit into memory, although it may be right: into the heap, [LoadLimits.memory], or the
 * part of it that decoded data may take if [LoadLimits.decodedBytes] is not given.
 */
public class SceneMemoryException @JvmOverloads constructor(
    source: String,
    problem: String,
    remedy: String? = null,
    cause: Throwable? = null,
) : SceneFormatException(source, null, problem, remedy, cause)

/**
 * Reports a file or a stream that cannot be read, whatever is in it: the file is missing, a folder or a device, may not
 * be read, has become shorter, or the disk, the stream or a temporary file fails.
 *
 * A server can tell its own faults from those of its clients by this class. The message names the file: it is for the
 * log, if the client has not chosen the name.
 */
public class SceneReadException @JvmOverloads constructor(
    source: String,
    problem: String,
    remedy: String? = null,
    cause: Throwable? = null,
) : SceneFormatException(source, null, problem, remedy, cause)

/**
 * Returns [text] in a form that is safe to print on a terminal: control characters, and characters that change the
 * direction of writing, become `?`, and words are cut after [LONGEST_WORD] characters.
 */
internal fun printable(text: String): String {
    val shown = StringBuilder(text.length)
    var word = 0
    for (character in text) {
        word = if (character == ' ') 0 else word + 1
        when {
            word == LONGEST_WORD + 1 -> shown.append("...")
            word > LONGEST_WORD -> Unit
            isHarmless(character) -> shown.append(character)
            else -> shown.append('?')
        }
    }
    return shown.toString()
}

/** In characters. Longer than any file name that operating systems allow. */
private const val LONGEST_WORD = 400

private fun isHarmless(character: Char): Boolean = when (character.category) {
    CharCategory.CONTROL, CharCategory.FORMAT, CharCategory.LINE_SEPARATOR, CharCategory.PARAGRAPH_SEPARATOR,
    CharCategory.PRIVATE_USE,
    -> false
    else -> true
}
