package dev.lazyz.scenes.writers

import dev.lazyz.scenes.SceneFormatException
import java.io.IOException
import java.io.InterruptedIOException
import java.nio.channels.ClosedByInterruptException
import java.nio.channels.FileChannel
import java.nio.file.AccessDeniedException
import java.nio.file.AtomicMoveNotSupportedException
import java.nio.file.FileSystemException
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.nio.file.StandardOpenOption.WRITE

/**
 * Writes files either completely or not at all.
 *
 * The content is written to a temporary file in the same folder, which is renamed only when it is complete. If
 * writing fails, the old file stays unchanged and the temporary file is deleted. Symbolic links are followed, also to
 * a file that does not exist yet: the link stays, and the temporary file is beside the file that it names. A target
 * that is not a regular file, such as `/dev/null` or a pipe, is written directly.
 */
internal object AtomicFile {
    /** As many links as Linux follows. */
    private const val MAX_LINKS = 40

    /**
     * Opens a temporary file, calls [produce] to fill it, and renames it to [path].
     *
     * @return what [produce] returns
     * @throws IOException if the file cannot be written; the message states which file, why, and what to do. If the
     *   thread is interrupted, it is an [InterruptedIOException], and the interrupt status stays set
     */
    fun <R> write(path: Path, produce: (FileChannel) -> R): R {
        val target = try {
            place(path)
        } catch (e: IOException) {
            throw explained(path, e)
        }
        if (Files.exists(target) && !Files.isRegularFile(target)) {
            return explaining(path) { FileChannel.open(target, WRITE).use(produce) }
        }
        return explaining(path) {
            TemporaryFile.beside(target).use { temporary ->
                val result = produce(temporary.channel)
                temporary.channel.close()
                move(temporary.path, target)
                result
            }
        }
    }

    /** Checks that the file can be created, and returns its path with symbolic links resolved. */
    fun place(path: Path): Path {
        val absolute = resolved(path)
        if (Files.isDirectory(absolute)) {
            throw IOException("cannot write $path: it is a folder; name a file in it")
        }
        val folder = absolute.parent
        if (absolute.fileName == null || folder == null) throw IOException("cannot write $path: it names no file")
        if (!Files.isDirectory(folder)) {
            throw IOException("cannot write $path: there is no folder $folder; create it or choose another")
        }
        return absolute
    }

    /** Returns the absolute path of what [path] names, which may not exist. Links are followed. */
    fun resolved(path: Path): Path {
        val absolute = linked(path)
        return if (Files.exists(absolute)) absolute.toRealPath() else absolute
    }

    /** Returns what [path] names, as an absolute path: if it is a link, the end of the chain. */
    private fun linked(path: Path): Path {
        var place = path.toAbsolutePath()
        repeat(MAX_LINKS) {
            if (!Files.isSymbolicLink(place)) return place
            place = place.resolveSibling(Files.readSymbolicLink(place))
        }
        throw IOException("cannot write $path: it is a link that leads to itself; remove it")
    }

    private fun move(from: Path, to: Path) {
        try {
            Files.move(from, to, ATOMIC_MOVE)
        } catch (_: AtomicMoveNotSupportedException) {
            Files.move(from, to, REPLACE_EXISTING)
        }
    }

    /** Calls [block], and explains an exception of it to those who want [path] to be written. */
    inline fun <R> explaining(path: Path, block: () -> R): R = try {
        block()
    } catch (e: IOException) {
        throw explained(path, e)
    }

    /**
     * Calls [block], which renders to a file. If the thread is interrupted while it writes, this is reported like an
     * interrupt while it renders: the status is cleared.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    inline fun <R> rendering(block: () -> R): R = try {
        block()
    } catch (e: WritingInterrupted) {
        Thread.interrupted()
        throw InterruptedException(e.message).apply { initCause(e.cause) }
    }

    private fun explained(path: Path, e: IOException): IOException {
        // An interrupt closes the channel that the thread writes to
        if (e is ClosedByInterruptException) return WritingInterrupted(path, e)
        if (e.message?.startsWith("cannot write") == true) return e

        // The model that is drawn into the file cannot be read
        if (e is SceneFormatException) return e
        return IOException("cannot write $path: ${reason(path, e)}", e)
    }

    /**
     * Returns why writing failed, and what to do. The files that exceptions name are temporary, so they are left out.
     * For most causes, the exception has only the words of the operating system.
     */
    private fun reason(path: Path, e: IOException): String {
        val folder = path.toAbsolutePath().parent
        val words = ((e as? FileSystemException)?.reason ?: e.message.takeIf { e !is FileSystemException }).orEmpty()
        fun says(vararg parts: String) = parts.any { words.contains(it, ignoreCase = true) }
        return when {
            e is AccessDeniedException -> "permission denied; choose a folder you may write to"
            e is NoSuchFileException && Files.isDirectory(folder) ->
                "$folder takes no new files; choose another folder"
            e is NoSuchFileException -> "there is no folder $folder; create it or choose another"
            says("no space", "not enough space", "quota") -> "the disk is full ($words); free some space there"
            says("read-only") -> "the file system of $folder is read-only; choose another folder"
            says("name too long") -> "the name is too long; choose a shorter one"
            else -> words.ifEmpty { "the system gives no reason (${e.javaClass.simpleName})" }
        }
    }
}

/** Reports that a thread was interrupted while it was writing to [path]. Its interrupt status is set. */
internal class WritingInterrupted(path: Path, cause: ClosedByInterruptException) :
    InterruptedIOException("cannot write $path: the thread was interrupted") {
    init {
        initCause(cause)
    }
}
