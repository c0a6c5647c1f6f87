package dev.lazyz.testing

import java.io.IOException
import java.io.UncheckedIOException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING

/** Writes files so that nobody reads half of one. */
internal object WholeFile {
    /**
     * Writes [bytes] to [file], in place of what was there, and creates its folders.
     *
     * @throws UncheckedIOException if that is not possible
     */
    fun write(file: Path, bytes: ByteArray) {
        try {
            Files.createDirectories(file.parent)
            val temporary = Files.createTempFile(file.parent, ".${file.fileName}", ".tmp")
            try {
                // A temporary file is only for its owner; this one is for all, as usual
                Files.delete(temporary)
                Files.write(temporary, bytes)
                Files.move(temporary, file, REPLACE_EXISTING)
            } finally {
                Files.deleteIfExists(temporary)
            }
        } catch (failure: IOException) {
            throw UncheckedIOException("cannot write $file: ${failure.message}", failure)
        }
    }
}
