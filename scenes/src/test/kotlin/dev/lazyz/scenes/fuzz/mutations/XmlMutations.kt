package dev.lazyz.scenes.fuzz.mutations

import java.util.Random

/** Changes the tags of XML: whole elements, and words within them. */
internal object XmlMutations : Mutations {
    private val tag = Regex("<[^>]*>|[^<]+")

    override fun mutate(input: ByteArray, other: ByteArray, random: Random): ByteArray {
        if (random.nextInt(3) != 0) return TextMutations.mutate(input, other, random)
        val tags = tags(input)
        val donors = tags(other)
        val at = random.nextInt(tags.size + 1)
        val count = random.small(tags.size - at + 1)
        when (random.nextInt(4)) {
            0 -> tags.subList(at, at + count).clear()
            1 -> tags.addAll(random.nextInt(tags.size + 1), tags.subList(at, at + count).toList())
            2 -> if (donors.isNotEmpty()) tags.add(at, random.pick(donors))
            else -> tags.add(at, "<a>".repeat(random.small(MOST_DEEP)))
        }
        return tags.joinToString("").toByteArray(Charsets.ISO_8859_1)
    }

    private fun tags(bytes: ByteArray): MutableList<String> =
        tag.findAll(String(bytes, Charsets.ISO_8859_1)).mapTo(ArrayList()) { it.value }

    private const val MOST_DEEP = 20_000
}
