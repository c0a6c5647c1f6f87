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
 * A temporary file that exists only while it is written. It is deleted when it is closed, unless it was renamed
 * before, and when the process exits normally or on SIGINT, SIGTERM and SIGHUP. If a process is killed, its temporary
 * files are deleted by the next process that writes to the same folder.
 *
 * The process that writes such a file holds a lock on it. A file without a lock is no longer in use.
 */
internal class TemporaryFile private constructor(val path: Path, val channel: FileChannel) : AutoCloseable {
    override fun close() {
        channel.close()
        Files.deleteIfExists(path)
        open.remove(path)
    }

    companion object {
        private const val SUFFIX = ".lazyz-tmp"

        /** A new file has no lock for a moment, so files younger than this are not deleted. In milliseconds. */
        private const val MIN_AGE_MILLIS = 60_000L

        private val open: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        /** Folders that were already searched for files left by other processes. */
        private val cleanedFolders: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        init {
            try {
                Runtime.getRuntime().addShutdownHook(Thread(::deleteAll, "lazyz-temporary-files"))
            } catch (_: IllegalStateException) {
                // The process is already exiting
            }
        }

        /** Creates an empty file in the folder of [target]. */
        fun beside(target: Path): TemporaryFile =
            create(checkNotNull(target.parent) { "the target must be absolute" }, "${target.fileName}")

        /** Creates an empty file in [folder], for data that is not kept. */
        fun within(folder: Path): TemporaryFile = create(folder.toAbsolutePath(), "spool")

        private fun create(folder: Path, name: String): TemporaryFile {
            if (cleanedFolders.add(folder)) deleteAbandoned(folder)

            // No secure random number: loading its providers takes as long as rendering a small image
            val word = java.lang.Long.toHexString(ThreadLocalRandom.current().nextLong())
            val path = folder.resolve(".$name.$word$SUFFIX")
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

        /** Deletes the files that terminated processes left in [folder]. */
        private fun deleteAbandoned(folder: Path) {
            try {
                Files.newDirectoryStream(folder, ".*$SUFFIX").use { found -> found.forEach(::deleteIfAbandoned) }
            } catch (_: IOException) {
                // Ignore a folder that cannot be read
            }
        }

        private fun deleteIfAbandoned(path: Path) {
            try {
                val age = System.currentTimeMillis() - Files.getLastModifiedTime(path).toMillis()
                if (age < MIN_AGE_MILLIS || path in open || !Files.isRegularFile(path)) return
                FileChannel.open(path, WRITE).use { if (lock(it)) Files.deleteIfExists(path) }
            } catch (_: IOException) {
                // The file belongs to another user, or was just deleted
            }
        }

        /** Tries to lock [channel]; returns false also on file systems that have no locks. */
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
                    // The process is exiting, so the error cannot be reported
                }
            }
        }
    }
}
