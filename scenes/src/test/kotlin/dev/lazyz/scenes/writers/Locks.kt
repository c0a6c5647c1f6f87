package dev.lazyz.scenes.writers

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertTrue

/** The locks on files. On some systems, a process loses them when it closes the file, however it was opened. */
internal object Locks {
    private val list = Path.of("/proc/locks")

    /** Checks that a process has a lock on [file], on systems that list locks. */
    fun requireLocked(file: Path) {
        if (!list.exists()) return
        val number = Files.getAttribute(file, "unix:ino")
        assertTrue(":$number " in list.readText(), "$file is not locked")
    }
}
