package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.loading.Loading
import dev.lazyz.scenes.writers.Locks
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class StreamedInputTest {
    @TempDir
    lateinit var folder: Path

    /** A copy without a lock would be deleted by the next process that writes to the folder. */
    @Test
    fun aCopyIsReadAgainAndStaysLocked() {
        StreamedInput.ofStream("one two".byteInputStream(), "model", folder, Loading()).use { input ->
            for ((position, text) in listOf(0L to "one two", 4L to "two", 7L to "")) {
                input.bytes(position).use { bytes ->
                    val first = bytes.read()
                    val rest = bytes.readAllBytes().decodeToString()
                    assertEquals(text, if (first < 0) rest else "${first.toChar()}$rest")
                }
            }
            Locks.requireLocked(folder.listDirectoryEntries().single())
        }
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }
}
