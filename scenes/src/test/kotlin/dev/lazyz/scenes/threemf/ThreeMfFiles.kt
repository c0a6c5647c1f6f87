package dev.lazyz.scenes.threemf

import java.io.ByteArrayOutputStream
import java.util.zip.CRC32
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream

/** Writes packages for tests. */
internal object ThreeMfFiles {
    const val RELATIONSHIPS = "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">" +
        "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" " +
        "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>"

    /** A triangle in the plane of x and y, whose first corner is the origin. */
    const val TRIANGLE = "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/>" +
        "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/></triangles></mesh>"

    fun model(resources: String, build: String): String =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\"millimeter\" " +
            "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\" " +
            "xmlns:m=\"http://m\" xmlns:p=\"http://p\">\n" +
            "<metadata name=\"Title\">a</metadata><resources>$resources</resources>\n<build>$build</build></model>"

    /** A package with the model in its usual place, and [others]. */
    fun of(model: String, vararg others: Pair<String, ByteArray>): ByteArray =
        zip("_rels/.rels" to RELATIONSHIPS.toByteArray(), "3D/3dmodel.model" to model.toByteArray(), *others)

    /** An archive of files that are not packed. */
    fun stored(vararg files: Pair<String, ByteArray>): ByteArray = zip(files.toList()) { content ->
        method = ZipEntry.STORED
        size = content.size.toLong()
        crc = CRC32().apply { update(content) }.value
    }

    fun zip(vararg files: Pair<String, ByteArray>): ByteArray = zip(files.toList()) { }

    private fun zip(files: List<Pair<String, ByteArray>>, prepare: ZipEntry.(ByteArray) -> Unit): ByteArray {
        val out = ByteArrayOutputStream()
        ZipOutputStream(out).use { zip ->
            for ((name, content) in files) {
                zip.putNextEntry(ZipEntry(name).apply { prepare(content) })
                zip.write(content)
            }
        }
        return out.toByteArray()
    }
}
