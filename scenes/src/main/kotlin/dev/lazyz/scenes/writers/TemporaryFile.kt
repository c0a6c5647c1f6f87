package dev.lazyz.scenes.writers

import java.io.IOException
import java.nio.channels.FileChannel
import java.nio.channels.OverlappingFileLockException
import java.nio.file.FileVisitResult
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.nio.file.SimpleFileVisitor
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.WRITE
import java.nio.file.attribute.BasicFileAttributes
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.ThreadLocalRandom

/**
 * A temporary file that exists only while it is written, and a temporary [folder] if a caller creates it. They are
 * deleted when the file is closed, unless they were renamed before, and when the process exits normally or on SIGINT,
 * SIGTERM and SIGHUP. If a process is killed, or cannot delete its temporary files, they are deleted by the next
 * process that writes to the same folder.
 *
 * The process that writes such a file holds a lock on it. A file without a lock is no longer in use. On Linux, a
 * process loses its locks on a file when it closes the file, however it was opened: do not open it again for a short
 * time.
 */
internal class TemporaryFile private constructor(val path: Path, val channel: FileChannel) : AutoCloseable {
    /** The place for a folder. It is not created. */
    val folder: Path = folderOf(path)

    override fun close() {
        channel.close()
        try {
            delete(path)
            open.remove(path)
        } catch (_: IOException) {
            // It is no failure of what was written. The file is deleted when the process exits, or by the next one
        }
    }

    companion object {
        private const val SUFFIX = ".lazyz-tmp"
        private const val FOLDER_SUFFIX = ".d"
        private const val DOOMED_SUFFIX = ".deleted"

        /** A new file has no lock for a moment, so files younger than this are not deleted. In milliseconds. */
        private const val MIN_AGE_MILLIS = 60_000L

        private val open: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        /** Folders that were already searched for files left by other processes. */
        private val cleanedFolders: MutableSet<Path> = ConcurrentHashMap.newKeySet()

        /** Whether the process is exiting, and all temporary files are or will be deleted. */
        @Volatile
        var isExiting: Boolean = false
            private set

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
                val channel = FileChannel.open(path, CREATE_NEW, READ, WRITE)
                try {
                    tryLock(channel)
                } catch (_: IOException) {
                    // The file system has no locks
                }
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
                FileChannel.open(path, WRITE).use { if (tryLock(it)) delete(path) }
            } catch (_: IOException) {
                // The file belongs to another user, or was just deleted
            }
        }

        /**
         * Locks the file of [channel] for this process, unless it is locked already. The lock is on a byte that no file
         * has: on Windows, only the channel that has locked bytes can read them.
         *
         * @return whether it was not locked
         * @throws IOException if the file system has no locks
         */
        fun tryLock(channel: FileChannel): Boolean = try {
            channel.tryLock(Long.MAX_VALUE - 1, 1, false) != null
        } catch (_: OverlappingFileLockException) {
            false
        }

        private fun deleteAll() {
            isExiting = true
            for (path in open) {
                try {
                    delete(path)
                } catch (_: IOException) {
                    // The process is exiting, so the error cannot be reported
                }
            }
        }

        /** Deletes the temporary file [path], and before that its folder. */
        private fun delete(path: Path) {
            val folder = folderOf(path)
            val doomed = path.resolveSibling("${path.fileName}$DOOMED_SUFFIX")

            // What remains if an earlier deletion was not completed
            if (Files.exists(doomed)) deleteTree(doomed)
            if (Files.exists(folder)) {
                // Other threads may still write into the folder: without its name they cannot create files there
                Files.move(folder, doomed)
                deleteTree(doomed)
            }
            Files.deleteIfExists(path)
        }

        /**
         * Deletes [folder] and all that is in it. Links are deleted, and not what they name. Another thread, or another
         * process, may delete it at the same time.
         */
        fun deleteTree(folder: Path) {
            Files.walkFileTree(folder, Deletion)
        }

        private fun folderOf(path: Path): Path = path.resolveSibling("${path.fileName}$FOLDER_SUFFIX")
    }

    /** Deletes what is in a folder, and then the folder. */
    private object Deletion : SimpleFileVisitor<Path>() {
        override fun visitFile(file: Path, attributes: BasicFileAttributes): FileVisitResult = deleted(file)

        override fun postVisitDirectory(folder: Path, failure: IOException?): FileVisitResult = deleted(folder)

        override fun visitFileFailed(file: Path, failure: IOException): FileVisitResult =
            if (failure is NoSuchFileException) FileVisitResult.CONTINUE else throw failure

        private fun deleted(path: Path): FileVisitResult {
            Files.deleteIfExists(path)
            return FileVisitResult.CONTINUE
        }
    }
}
