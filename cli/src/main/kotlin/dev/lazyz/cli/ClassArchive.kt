package dev.lazyz.cli

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** The archive of loaded classes with which the script `zcli` starts Java. */
internal object ClassArchive {
    /** System property with the path of the archive. The script sets it. */
    private const val PROPERTY = "zcli.archive"

    /** Deletes the archive after an unexplained failure, because it may be damaged. The script creates a new one. */
    fun discard() {
        val archive = System.getProperty(PROPERTY) ?: return
        try {
            Files.deleteIfExists(Path.of(archive))
        } catch (_: IOException) {
            // The archive is used again. The original failure has already been reported
        }
    }
}
