package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.SceneReadException
import dev.lazyz.scenes.writers.Locks
import java.nio.file.Path
import kotlin.io.path.listDirectoryEntries
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Records in a temporary file that is mapped in pieces. */
class FloatSpoolTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun recordsOfAllPiecesAreFound() {
        for (width in 1..4) {
            for (count in listOf(0, 1, 15, 16, 17, 32, 40_000)) {
                FloatSpool(SpoolSpace(folder, "model", null), width, pieceBits = 4).use { spool ->
                    for (i in 0 until count * width) spool.add(i.toFloat())
                    assertEquals(count, spool.size)
                    spool.finish()
                    Locks.requireLocked(folder.listDirectoryEntries().single())
                    for (i in count * width - 1 downTo 0) assertEquals(i.toFloat(), spool.get(i / width, i % width))
                }
                assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
            }
        }
    }

    @Test
    fun aFullDiskIsNoFaultOfTheModel() {
        val full = SpoolSpace(folder, "model", null, kept = Long.MAX_VALUE / 2)
        val failure = assertThrows(SceneReadException::class.java) { full.take(1) }
        assertTrue("model: needs temporary files, and only " in failure.message.orEmpty(), failure.message)
    }
}
