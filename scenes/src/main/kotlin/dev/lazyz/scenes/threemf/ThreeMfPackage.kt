package dev.lazyz.scenes.threemf

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.zip.ZipArchive
import java.io.IOException

/**
 * The parts of a package, and the path of the main model part (3MF Consortium, "3D Manufacturing Format", version
 * 1.3.0, 2).
 */
internal class ThreeMfPackage(private val source: Source) {
    private val archive = ZipArchive(source)

    /** Name of the main model part. */
    val modelPath: String =
        target()?.removePrefix("/") ?: archive.names.firstOrNull { it.endsWith(".model", ignoreCase = true) }
            ?: source.fail(null, "the archive holds no 3D model", "check what kind of file it is")

    /** Opens the XML part called [path], or returns null if there is none. */
    fun part(path: String): PackagePart? = archive.open(path)?.let { PackagePart(source, path.removePrefix("/"), it) }

    /** Returns the content of the part called [path], or null if there is none or it is damaged. */
    fun bytes(path: String): ByteArray? = try {
        archive.open(path)?.use { it.readAllBytes() }
    } catch (limit: SceneFormatException) {
        throw limit
    } catch (_: IOException) {
        null
    }

    /**
     * Returns the name of the model part according to the package's relationships, or null if they name none, or one
     * that does not exist.
     */
    private fun target(): String? {
        val part = part(RELATIONSHIPS) ?: return null
        var target: String? = null
        part.forEachChild {
            part.forEachChild {
                if (target == null && part.attribute("Type") == MODEL_TYPE) target = part.attribute("Target")
            }
        }
        part.close()
        return target?.takeIf { path -> archive.names.any { it.equals(path.removePrefix("/"), ignoreCase = true) } }
    }

    private companion object {
        const val RELATIONSHIPS = "_rels/.rels"
        const val MODEL_TYPE = "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
    }
}
