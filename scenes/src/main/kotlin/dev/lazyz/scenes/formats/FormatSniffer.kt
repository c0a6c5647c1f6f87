package dev.lazyz.scenes.formats

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.loading.TextEncoding
import dev.lazyz.scenes.off.OffHeader
import dev.lazyz.scenes.stl.StlBinary
import dev.lazyz.scenes.text.TextLines

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
