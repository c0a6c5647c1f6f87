package dev.lazyz.scenes.streaming

import dev.lazyz.scenes.SceneFormatException
import java.io.FilterOutputStream
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * The room that temporary files may take in [folder]: at most [most] bytes together, and never the last
 * [KEPT_BYTES] of the disk. Not thread safe.
 *
 * @property folder where temporary files are created
 * @param name name of the model in messages
 * @param most most bytes, or null
 */
internal class SpoolSpace(val folder: Path, private val name: String, private val most: Long?) {
    private var taken = 0L
    private var checked = 0L

    /**
     * Records that [bytes] are about to be written.
     *
     * @throws SceneFormatException if there is no room for them
     */
    fun take(bytes: Long) {
        taken += bytes
        if (most != null && taken > most) {
            throw SceneFormatException(
                name, null, "needs temporary files of more than $most bytes",
                "raise LoadLimits.spoolBytes (zcli: --max-spool), or use a binary STL file, which needs none",
            )
        }
        if (taken < checked) return
        val free = Files.getFileStore(folder).usableSpace
        if (free < KEPT_BYTES + STEP_BYTES) {
            throw SceneFormatException(
                name, null, "needs temporary files, and only $free bytes are free in $folder",
                "free some space, or choose another folder (zcli: --spool)",
            )
        }
        checked = taken + STEP_BYTES
    }

    /** Gives the room back, after the files were deleted. */
    fun release(bytes: Long) {
        taken -= bytes
    }

    /** Returns a stream that takes the room for what is written to [output]. */
    fun counting(output: OutputStream): OutputStream = object : FilterOutputStream(output) {
        override fun write(byte: Int) {
            take(1)
            out.write(byte)
        }

        override fun write(bytes: ByteArray, offset: Int, length: Int) {
            take(length.toLong())
            out.write(bytes, offset, length)
        }
    }

    companion object {
        /** Space of the disk that is left to others. */
        private const val KEPT_BYTES = 64L shl 20

        /** Bytes that are written before the free space is looked at again. */
        private const val STEP_BYTES = 16L shl 20
    }
}
