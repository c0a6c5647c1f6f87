package dev.lazyz.scenes.images.containers

/** The blocks of a GIF file (CompuServe, "Graphics Interchange Format", version 89a). */
internal object GifBlocks {
    val SIGNATURE: ByteArray = "GIF8".toByteArray(Charsets.ISO_8859_1)

    private const val HEADER = 13
    private const val FLAGS = 10
    private const val EXTENSION = 0x21
    private const val CONTROL = 0xF9
    private const val IMAGE = 0x2C
    private const val IMAGE_HEADER = 10
    private const val TRAILER: Byte = 0x3B

    /** Returns the header and the first image, with the control block before it, which says what is transparent. */
    fun needed(bytes: ByteArray): ByteArray? {
        if (bytes.size < HEADER) return null
        val parts = Parts(bytes)
        var at = HEADER + paletteSize(bytes.code(FLAGS))
        parts.keep(0, at)
        var control = 0 until 0
        while (bytes.code(at) == EXTENSION) {
            val end = blocksEnd(bytes, at + 2)
            if (bytes.code(at + 1) == CONTROL) control = at until end
            at = end
        }
        if (bytes.code(at) != IMAGE) return null
        if (!control.isEmpty()) parts.keep(control.first, control.last + 1)

        // The image: its header, its palette, the size of its codes, and blocks of data
        val data = at + IMAGE_HEADER + paletteSize(bytes.code(at + IMAGE_HEADER - 1)) + 1
        if (data > bytes.size) return null
        parts.keep(at, blocksEnd(bytes, data))
        return parts.toByteArray() + TRAILER
    }

    /** Returns the bytes of the palette that [flags] announce. */
    private fun paletteSize(flags: Int): Int = if (flags and 0x80 == 0) 0 else 3 shl (flags and 7) + 1

    /** Returns where the blocks at [from] end: behind an empty one, or at the end of the file. */
    private fun blocksEnd(bytes: ByteArray, from: Int): Int {
        var at = from
        while (bytes.code(at) > 0) at += 1 + bytes.code(at)
        return minOf(at + 1, bytes.size)
    }
}
