package dev.lazyz.server.render

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes

/** Finds the format of an upload. */
internal object MediaTypes {
    private val types = mapOf(
        "model/obj" to SceneFormat.OBJ,
        "model/stl" to SceneFormat.STL,
        "application/sla" to SceneFormat.STL,
        "application/vnd.ms-pki.stl" to SceneFormat.STL,
        "model/3mf" to SceneFormat.THREE_MF,
        "application/vnd.ms-package.3dmanufacturing-3dmodel+xml" to SceneFormat.THREE_MF,
        "model/gltf-binary" to SceneFormat.GLB,
        "model/gltf+json" to SceneFormat.GLTF,
    )

    /** Types that say nothing about the format. The last is what curl sends by default. */
    private val unspecific = setOf(
        "", "application/octet-stream", "binary/octet-stream", "text/plain", "application/json", "application/zip",
        "application/x-zip-compressed", "application/x-www-form-urlencoded",
    )

    /**
     * Returns the format that a Content-Type names, or null if the content decides.
     *
     * @throws Problem if the type is not that of a model
     */
    fun format(contentType: String?): SceneFormat? {
        val type = contentType.orEmpty().substringBefore(';').trim().lowercase()
        val format = types[type]
        if (format != null || type in unspecific) return format
        if (type == "multipart/form-data") {
            throw unsupported("a form is not accepted; send the file itself, as curl does with --data-binary @FILE")
        }
        throw unsupported("'$type' is not the type of a model; use application/octet-stream, or the parameter format")
    }

    /**
     * Returns the format that the content looks like, which has [size] bytes and begins with [start]: for ZIP archives
     * 3MF, which is one.
     *
     * @throws Problem if it looks like no model
     */
    fun sniffed(start: ByteArray, size: Int): SceneFormat {
        val format = Scenes.formatOf(start, size.toLong())
        if (format != null && format != SceneFormat.SCENE) return format
        throw unsupported("the model is of no known format; name it with format=${names.joinToString("|")}")
    }

    private val names = (SceneFormat.entries - SceneFormat.SCENE).map { it.id }

    private fun unsupported(message: String) = Problem(Problem.UNSUPPORTED, message)
}
