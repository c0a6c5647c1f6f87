package dev.lazyz.scenes.writers

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createFile
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class TemporaryFileTest {
    @TempDir
    lateinit var folder: Path

    /** It is deleted when the process exits, or by another one later. */
    @Test
    fun whatCannotBeDeletedIsNoFailure() {
        val temporary = TemporaryFile.within(folder)
        val level = temporary.folder.resolve("3").createDirectories()
        level.resolve("0_0.png").createFile()
        assumeTrue(level.toFile().setReadable(false) && !Files.isReadable(level), "all is permitted to this user")
        try {
            temporary.close()
        } finally {
            Files.walk(folder, 2).use { all -> all.forEach { it.toFile().setReadable(true) } }
        }
    }
}
