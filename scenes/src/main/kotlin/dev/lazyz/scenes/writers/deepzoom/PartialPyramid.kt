package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.scenes.writers.TemporaryFile
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.channels.Channels
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.READ
import java.nio.file.StandardOpenOption.WRITE

/**
 * The folder of a pyramid that stays if its writing is interrupted, and belongs to one process at a time. A file in it
 * states what the picture depends on.
 *
 * @param facts what the picture depends on, by name
 * @throws IOException if the folder belongs to a picture with other facts, or another process writes it
 */
internal class PartialPyramid(private val files: PyramidFiles, facts: Map<String, String>) : AutoCloseable {
    private val stated = files.partial.resolve("resume.txt")
    private val channel: FileChannel

    /** The folder of the tiles. */
    val tiles: Path = files.partial.resolve("tiles")

    init {
        if (Files.exists(files.partial) && !Files.exists(stated) && Files.list(files.partial).use { it.count() } > 0) {
            throw files.refused("${files.partial} is not from an interrupted run; move it away")
        }
        Files.createDirectories(files.partial)
        channel = FileChannel.open(stated, CREATE, READ, WRITE)
        try {
            if (!TemporaryFile.tryLock(channel)) {
                throw files.refused("another process is writing ${files.partial}; wait until it has ended")
            }
            val text = facts.entries.joinToString("") { (name, value) -> "$name: ${value.replace('\n', ' ')}\n" }

            // Not with another channel: on Linux, all locks on a file are lost when one of its channels is closed
            val old = String(Channels.newInputStream(channel).readAllBytes())
            if (old.isEmpty()) channel.write(ByteBuffer.wrap(text.toByteArray())) else requireSame(old, text)
        } catch (e: IOException) {
            channel.close()
            throw e
        }
    }

    /** Deletes the folder, after the tiles were moved out of it. */
    fun delete() {
        Files.delete(stated)
        Files.delete(files.partial)
    }

    override fun close() = channel.close()

    private fun requireSame(old: String, new: String) {
        if (old == new) return
        val before = old.lines()
        val after = new.lines()
        val i = (before zip after).indexOfFirst { (a, b) -> a != b }.coerceAtLeast(0)
        throw files.refused(
            "${files.partial} is from a run with another picture (\"${before[i]}\", and now \"${after[i]}\"); " +
                "run the same command as then, or delete that folder to begin again",
        )
    }
}
