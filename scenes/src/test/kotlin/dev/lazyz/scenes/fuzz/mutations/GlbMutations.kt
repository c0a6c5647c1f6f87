package dev.lazyz.scenes.fuzz.mutations

import java.nio.BufferUnderflowException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.util.Random

/** Changes what is in the chunks of a binary glTF file, whose lengths are right again afterwards. */
internal object GlbMutations : Mutations {
    private const val MAGIC = 0x46546C67
    private const val JSON = 0x4E4F534A
    private const val ALIGNMENT = 4

    private class Chunk(val type: Int, val bytes: ByteArray)

    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray? {
        val chunks = chunks(input)?.toMutableList() ?: return null
        if (chunks.isEmpty()) return null
        val at = if (random.nextInt(4) == 0) random.nextInt(chunks.size) else 0
        val chunk = chunks[at]
        val donor = chunks(other)?.getOrNull(at)?.bytes ?: chunk.bytes
        when (random.nextInt(12)) {
            0 -> chunks.removeAt(at)
            1 -> chunks.add(random.nextInt(chunks.size + 1), chunk)
            2 -> chunks[at] = Chunk(random.nextInt(), chunk.bytes)
            else -> {
                val mutations = if (chunk.type == JSON) JsonMutations else ByteMutations
                chunks[at] = Chunk(chunk.type, mutations.mutate(chunk.bytes, donor, random) ?: return null)
            }
        }
        return packed(chunks)
    }

    private fun chunks(bytes: ByteArray): List<Chunk>? = try {
        val buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
        if (buffer.int != MAGIC) null else chunks(buffer.position(12))
    } catch (_: BufferUnderflowException) {
        null
    } catch (_: IllegalArgumentException) {
        null
    }

    private fun chunks(buffer: ByteBuffer): List<Chunk>? {
        val chunks = ArrayList<Chunk>()
        while (buffer.hasRemaining()) {
            val length = buffer.int
            val type = buffer.int
            if (length !in 0..buffer.remaining()) return null
            chunks.add(Chunk(type, ByteArray(length).also { buffer.get(it) }))
        }
        return chunks
    }

    private fun packed(chunks: List<Chunk>): ByteArray {
        val padded = chunks.map { Chunk(it.type, padded(it)) }
        val out = ByteBuffer.allocate(12 + padded.sumOf { 8 + it.bytes.size }).order(ByteOrder.LITTLE_ENDIAN)
        out.putInt(MAGIC).putInt(2).putInt(out.capacity())
        for (chunk in padded) out.putInt(chunk.bytes.size).putInt(chunk.type).put(chunk.bytes)
        return out.array()
    }

    private fun padded(chunk: Chunk): ByteArray {
        val bytes = chunk.bytes
        val filler = if (chunk.type == JSON) ' '.code.toByte() else 0
        return bytes.copyOf((bytes.size + ALIGNMENT - 1) / ALIGNMENT * ALIGNMENT).also { it.fill(filler, bytes.size) }
    }
}
