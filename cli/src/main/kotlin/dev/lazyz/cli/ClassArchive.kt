package dev.lazyz.cli

import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/** The archive of loaded classes that the script `zcli` starts Java with. */
internal object ClassArchive {
    /** Set by the script. */
    private const val PROPERTY = "zcli.archive"

    /** Removes the archive after a failure that nobody can explain: it may be damaged. The script makes another. */
    fun discard() {
        val archive = System.getProperty(PROPERTY) ?: return
        try {
            Files.deleteIfExists(Path.of(archive))
        } catch (_: IOException) {
            // Then it is used again; the failure has been reported
        }
    }
}
