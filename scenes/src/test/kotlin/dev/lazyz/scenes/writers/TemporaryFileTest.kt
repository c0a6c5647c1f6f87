package dev.lazyz.scenes.writers

import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import kotlin.io.path.createDirectories
import kotlin.io.path.createDirectory
import kotlin.io.path.createFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.setLastModifiedTime
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class TemporaryFileTest {
    @TempDir
    lateinit var folder: Path

    /** The process can be killed while it writes to its folder, or while it deletes it. */
    @Test
    fun whatAKilledProcessLeavesIsDeleted() {
        val cases = listOf(listOf(), listOf(".d"), listOf(".deleted"), listOf(".d", ".deleted"))
        for ((number, endings) in cases.withIndex()) {
            val place = folder.resolve("$number").createDirectory()
            val left = place.resolve(".a.dzi.12ab.lazyz-tmp").createFile()
            left.setLastModifiedTime(FileTime.fromMillis(System.currentTimeMillis() - 3_600_000))
            for (ending in endings) {
                val level = left.resolveSibling("${left.fileName}$ending").resolve("3").createDirectories()
                level.resolve("0_0.png").createFile()
                Files.createSymbolicLink(level.resolve("link"), Path.of("nowhere"))
            }
            TemporaryFile.within(place).close()
            assertEquals(emptyList<Path>(), place.listDirectoryEntries(), "$endings")
        }
    }

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
