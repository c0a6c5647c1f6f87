package dev.lazyz.spark.pictures

import dev.lazyz.Region
import java.io.DataInputStream
import java.io.DataOutputStream
import java.io.IOException
import java.io.Serializable
import java.nio.file.Files
import java.nio.file.NoSuchFileException
import java.nio.file.Path
import java.nio.file.StandardCopyOption.ATOMIC_MOVE
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.zip.CRC32
import java.util.zip.CheckedInputStream
import java.util.zip.CheckedOutputStream
import kotlin.io.path.listDirectoryEntries
import org.apache.spark.TaskContext

/**
 * The finished parts of a picture, a file for each, which stay when the driver ends early. Several attempts of a task,
 * and several drivers, can use the folder at the same time: files of the same part have the same bytes, and appear when
 * they are complete.
 *
 * @param folder the folder, under the same path for the driver and all executors
 */
internal class PartFiles(private val folder: String) : Serializable {
    private fun place(): Path = Path.of(folder)

    private fun file(region: Region, planes: Int): Path =
        with(region) { place().resolve("$columnStart-$rowStart-$columnEnd-$rowEnd-$planes$PART") }

    /**
     * Creates the folder, or checks that it belongs to a picture with these [facts]: its name and the value of each.
     *
     * @throws IOException if it belongs to another picture, or cannot be written
     */
    fun open(facts: Map<String, String>) {
        val text = facts.entries.joinToString("") { (name, value) -> "$name: ${value.replace('\n', ' ')}\n" }
        try {
            Files.createDirectories(place())
        } catch (e: IOException) {
            throw IOException("cannot create the folder $folder; name another folder", e)
        }
        val stated = place().resolve(FACTS)
        val old = try {
            Files.readString(stated)
        } catch (_: NoSuchFileException) {
            if (place().listDirectoryEntries().isNotEmpty()) {
                throw IOException("$folder has other files than the parts of a picture; name another folder")
            }
            moved(stated) { Files.writeString(it, text) }
            text
        }
        if (old == text) return
        val (before, after) = (old.lines() zip text.lines()).first { (a, b) -> a != b }
        throw IOException(
            "$folder has parts of another picture (\"$before\", and now \"$after\"); name another folder, or delete it",
        )
    }

    /** Returns the part of [region], or null if there is none, or if it is damaged. */
    fun read(region: Region, planes: Int): PixelBlock? = try {
        CheckedInputStream(Files.newInputStream(file(region, planes)).buffered(), CRC32()).use { input ->
            val data = DataInputStream(input)
            val block = PixelBlock.read(data, region, planes)
            val sum = input.checksum.value
            if (data.readLong() == sum) block else null
        }
    } catch (_: IOException) {
        // It is rendered again
        null
    }

    /** Stores [block]. */
    fun write(block: PixelBlock, planes: Int) = moved(file(block.region, planes)) { own ->
        CheckedOutputStream(Files.newOutputStream(own).buffered(), CRC32()).use { output ->
            val data = DataOutputStream(output)
            block.write(data)
            data.writeLong(output.checksum.value)
        }
    }

    /** Writes a file that appears when it is complete. */
    private fun moved(file: Path, write: (Path) -> Unit) {
        val attempt = TaskContext.get()?.taskAttemptId() ?: "driver-${ProcessHandle.current().pid()}"
        val own = file.resolveSibling("${file.fileName}.$attempt$TEMPORARY")
        try {
            write(own)
            Files.move(own, file, ATOMIC_MOVE, REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(own)
        }
    }

    /** Deletes the parts, and the folder if nothing else is in it. */
    fun delete() {
        for (file in place().listDirectoryEntries("*{$PART,$TEMPORARY,$FACTS}")) Files.deleteIfExists(file)
        if (place().listDirectoryEntries().isEmpty()) Files.deleteIfExists(place())
    }

    private companion object {
        const val FACTS = "picture.txt"
        const val PART = ".part"
        const val TEMPORARY = ".tmp"
    }
}
