package dev.lazyz.scenes.writers

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.scenes.SceneFormatException
import java.io.IOException
import java.io.InterruptedIOException
import java.nio.file.AccessDeniedException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class AtomicFileTest {
    @TempDir
    lateinit var folder: Path

    private val row = IntArray(4)

    @Test
    fun aFailureMidwayKeepsTheOldFile() {
        for (name in listOf("old.png", "old.ppm", "old.pfm")) {
            val path = folder.resolve(name)
            Files.writeString(path, "old")
            assertThrows(IllegalStateException::class.java) { failingRender(path) }
            assertEquals("old", Files.readString(path))
        }
        assertEquals(3, files().size)
    }

    @Test
    fun theNameAppearsOnlyWhenTheFileIsComplete() {
        val path = folder.resolve("whole.ppm")
        val result = ImageFiles.write(path, 4, 2) { sink ->
            sink.row(0, row, row, row)
            assertFalse(Files.exists(path))
            sink.row(1, row, row, row)
            "done"
        }
        assertEquals("done", result)
        assertEquals(listOf(path), files())
    }

    @Test
    fun aLinkToAFileThatDoesNotExistYetIsFollowed() {
        val target = Files.createDirectory(folder.resolve("sub")).resolve("target.ppm")
        val link = Files.createSymbolicLink(folder.resolve("link.ppm"), Path.of("next.ppm"))
        val next = Files.createSymbolicLink(folder.resolve("next.ppm"), Path.of("sub/target.ppm"))
        ImageFiles.write(link, 1, 1) { it.row(0, row, row, row) }
        assertTrue(Files.isSymbolicLink(link) && Files.isSymbolicLink(next))
        assertTrue(Files.readString(target).startsWith("P6"))
        assertEquals(listOf(target), Files.list(target.parent).use { it.toList() })

        Files.createSymbolicLink(folder.resolve("a.ppm"), Path.of("b.ppm"))
        val loop = Files.createSymbolicLink(folder.resolve("b.ppm"), Path.of("a.ppm"))
        val failure = assertThrows(IOException::class.java) { failingRender(loop) }
        assertEquals("cannot write $loop: it is a link that leads to itself; remove it", failure.message)
    }

    @Test
    fun aDeviceIsWrittenDirectly() {
        val device = Path.of("/dev/null")
        assumeTrue(Files.exists(device))
        ImageFiles.write(device, 1, 1, ImageFormat.PNG) { it.row(0, row, row, row) }
        assertFalse(Files.isRegularFile(device))
    }

    @Test
    fun aFolderWithoutPermissionIsAnIoException() {
        val locked = Files.createDirectory(folder.resolve("locked"))
        assumeTrue(locked.toFile().setWritable(false) && !Files.isWritable(locked), "all is permitted to this user")
        try {
            val error = assertThrows(IOException::class.java) {
                ImageFiles.write(locked.resolve("a.png"), 1, 1) { it.row(0, row, row, row) }
            }
            assertTrue("permission denied" in error.message.orEmpty(), error.message)
        } finally {
            locked.toFile().setWritable(true)
        }
    }

    /** Whatever the system says, the temporary file is not named. */
    @Test
    fun usualCausesAreExplained() {
        val path = folder.resolve("a.png")
        val temporary = "$folder/.a.png.1234.lazyz-tmp"
        val gone = folder.resolve("gone/a.png")
        fun explained(cause: IOException, file: Path = path): String = assertThrows(IOException::class.java) {
            AtomicFile.explaining<Unit>(file) { throw cause }
        }.message.orEmpty().removePrefix("cannot write $file: ")
        val full = "the disk is full (No space left on device); free some space there"
        val readOnly = "the file system of $folder is read-only; choose another folder"
        val causes = listOf(
            IOException("No space left on device") to full,
            FileSystemException(temporary, null, "No space left on device") to full,
            FileSystemException(temporary, null, "Read-only file system") to readOnly,
            FileSystemException(temporary, null, "File name too long") to "the name is too long; choose a shorter one",
            AccessDeniedException(temporary) to "permission denied; choose a folder you may write to",
            NoSuchFileException(temporary) to "$folder takes no new files; choose another folder",
            FileSystemException(temporary) to "the system gives no reason (FileSystemException)",
            FileSystemException(temporary, null, "Input/output error") to "Input/output error",
            IOException() to "the system gives no reason (IOException)",
        )
        for ((cause, expected) in causes) assertEquals(expected, explained(cause))
        val model = SceneFormatException("a.obj", "line 1", "is wrong")
        val passed = assertThrows(SceneFormatException::class.java) {
            AtomicFile.explaining<Unit>(path) { throw model }
        }
        assertSame(model, passed, "the model that is drawn cannot be read")
        val missing = "there is no folder ${gone.parent}; create it or choose another"
        assertEquals(missing, explained(NoSuchFileException(temporary), gone))
        val long = folder.resolve("a".repeat(250) + ".png")
        val error = assertThrows(IOException::class.java) { failingRender(long) }
        assertEquals("cannot write $long: the name is too long; choose a shorter one", error.message)
    }

    private fun failingRender(path: Path) {
        ImageFiles.write(path, 4, 4) { sink ->
            sink.row(0, row, row, row)
            error("out of luck")
        }
    }

    private fun files(): List<Path> = Files.list(folder).use { it.toList() }

    @Test
    fun anInterruptWhileWritingIsOneOfTheRendering() {
        for (name in listOf("a.png", "a.ppm", "a.pfm")) {
            for (isBefore in listOf(true, false)) {
                if (isBefore) Thread.currentThread().interrupt()
                assertThrows(InterruptedException::class.java) {
                    ImageFiles.write(folder.resolve(name), 4, 2) { sink ->
                        sink.row(0, row, row, row)
                        Thread.currentThread().interrupt()
                        sink.row(1, row, row, row)
                    }
                }
                assertFalse(Thread.interrupted(), "the status is cleared")
                assertEquals(emptyList<Path>(), files())
            }
        }
    }

    @Test
    fun anInterruptWhileAPictureInMemoryIsWrittenKeepsTheStatus() {
        val path = folder.resolve("a.png")
        val image = Image(2, 2, row, row, row, Counters.NONE)
        Thread.currentThread().interrupt()
        val e = assertThrows(InterruptedIOException::class.java) { image.writePng(path) }
        assertTrue(Thread.interrupted(), "the status is set")
        assertEquals("cannot write $path: the thread was interrupted", e.message)
        assertEquals(emptyList<Path>(), files())
    }
}
