package dev.lazyz.scenes.fuzz.mutations

import java.io.ByteArrayInputStream
import java.io.IOException
import java.util.Random
import java.util.zip.ZipInputStream

/** Changes the files in an archive, and packs them again. */
internal object ZipMutations : Mutations {
    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray? {
        val entries = entries(input)?.toMutableList() ?: return null
        if (entries.isEmpty()) return null
        val at = random.nextInt(entries.size)
        val (name, bytes) = entries[at]
        val donor = entries(other)?.firstOrNull { it.first == name }?.second ?: bytes
        when (random.nextInt(16)) {
            0 -> entries.removeAt(at)
            1 -> entries.add(random.nextInt(entries.size + 1), random.pick(entries))
            2 -> entries[at] = TextMutations.mutate(name, random.pick(entries).first, random) to bytes
            3 -> entries[at] = name to random.pick(entries).second
            4 -> entries[at] = name to bytes + ByteArray(random.small(MOST_PADDING)) { ' '.code.toByte() }
            else -> entries[at] = name to content(bytes, donor, random)
        }
        return ZipFiles.of(entries)
    }

    private fun content(bytes: ByteArray, donor: ByteArray, random: Random): ByteArray {
        val isText = bytes.firstOrNull() == '<'.code.toByte() && random.nextInt(6) != 0
        return if (isText) XmlMutations.mutate(bytes, donor, random) else ByteMutations.mutate(bytes, donor, random)
    }

    private fun entries(bytes: ByteArray): List<Pair<String, ByteArray>>? = try {
        ZipInputStream(ByteArrayInputStream(bytes)).use { zip ->
            generateSequence { zip.nextEntry }.map { it.name to zip.readNBytes(MOST_BYTES) }.toList()
        }
    } catch (_: IOException) {
        null
    } catch (_: IllegalArgumentException) {
        null
    }

    private const val MOST_BYTES = 1 shl 17
    private const val MOST_PADDING = 1 shl 24
}
