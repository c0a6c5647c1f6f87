package dev.lazyz.scenes.writers

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ThreadLocalRandom

/**
 * A file that lasts only while it is written. It is deleted when it is closed, unless it was moved away, and when the
 * process ends in order, as it does on SIGINT, SIGTERM and SIGHUP. What a process leaves behind that was killed, the next
 * one deletes that writes to the same folder.
 *
 * The process that writes such a file holds a lock on it; without a lock it belongs to nobody.
 */
internal class TemporaryFile private constructor(val path: Path, val channel: FileChannel) : AutoCloseable {
    override fun close() {
        channel.close()
        Files.deleteIfExists(path)
        open.remove(path)
    }

    companion object {
        private const val SUFFIX = ".lazyz-tmp"

        /** A new file has no lock for a moment: what is so young is left alone, milliseconds. */
        private const val YOUNG = 60_000L

        private val open: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        /** Folders that were looked through for what others left behind. */
        private val tidied: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        init {
            try {
                Runtime.getRuntime().addShutdownHook(Thread(::deleteAll, "lazyz-temporary-files"))
            } catch (_: IllegalStateException) {
                // The process ends already
            }
        }

        /** Creates an empty file beside [target]. */
        fun beside(target: Path): TemporaryFile {
            val folder = checkNotNull(target.parent) { "the target must be absolute" }
            if (tidied.add(folder)) tidy(folder)

            // Ask for no secure random number: its providers take as long to load as a small picture to render
            val word = java.lang.Long.toHexString(ThreadLocalRandom.current().nextLong())
            val path = folder.resolve(".${target.fileName}.$word$SUFFIX")
            open.add(path)
            try {
                val channel = FileChannel.open(path, CREATE_NEW, WRITE)
                lock(channel)
                return TemporaryFile(path, channel)
            } catch (e: IOException) {
                open.remove(path)
                throw e
            }
        }

        /** Deletes what processes that are no more have left in [folder]. */
        private fun tidy(folder: Path) {
            try {
                Files.newDirectoryStream(folder, ".*$SUFFIX").use { found -> found.forEach(::deleteIfLeft) }
            } catch (_: IOException) {
                // A folder that cannot be read stays as it is
            }
        }

        private fun deleteIfLeft(path: Path) {
            try {
                val age = System.currentTimeMillis() - Files.getLastModifiedTime(path).toMillis()
                if (age < YOUNG || path in open || !Files.isRegularFile(path)) return
                FileChannel.open(path, WRITE).use { if (lock(it)) Files.deleteIfExists(path) }
            } catch (_: IOException) {
                // Somebody else's, or just gone
            }
        }

        /** Whether [channel] has been locked; some file systems have no locks. */
        private fun lock(channel: FileChannel): Boolean = try {
            channel.tryLock() != null
        } catch (_: OverlappingFileLockException) {
            false
        } catch (_: IOException) {
            false
        }

        private fun deleteAll() {
            for (path in open) {
                try {
                    Files.deleteIfExists(path)
                } catch (_: IOException) {
                    // The process ends; there is nobody to tell
                }
            }
        }
    }
}
