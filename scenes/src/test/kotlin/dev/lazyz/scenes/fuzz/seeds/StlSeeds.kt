package dev.lazyz.scenes.fuzz.seeds

import java.nio.ByteBuffer
import java.nio.ByteOrder

/** Two facets in both forms of STL. */
internal object StlSeeds {
    private val facets = listOf(
        floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f),
        floatArrayOf(1f, 0f, 0f, 1f, 1f, 0.3f, 0f, 1f, 0f),
    )

    private fun text(name: String, normal: String = "0 0 1", corners: Int = 3) = buildString {
        append("solid $name\n")
        for (facet in facets) {
            append("  facet normal $normal\n    outer loop\n")
            for (i in 0 until corners) append("      vertex ${facet.drop(i % 3 * 3).take(3).joinToString(" ")}\n")
            append("    endloop\n  endfacet\n")
        }
        append("endsolid $name\n")
    }

    private fun binary(header: String, attribute: Int = 0, more: Int = 0): ByteArray {
        val buffer = ByteBuffer.allocate(84 + 50 * facets.size + more).order(ByteOrder.LITTLE_ENDIAN)
        buffer.put(header.toByteArray()).position(80).putInt(facets.size)
        for (facet in facets) {
            for (number in floatArrayOf(0f, 0f, 1f) + facet) buffer.putFloat(number)
            buffer.putShort(attribute.toShort())
        }
        return buffer.array()
    }

    val all: List<ByteArray> = listOf(
        text("a").toByteArray(),
        (text("part one", "nan nan nan", 4) + "solid empty\nendsolid\n" + text("b").uppercase()).toByteArray(),
        binary(""),
        binary("solid part", 0x7FFF, 7),
        binary("COLOR=abcd MATERIAL=abcdefghijkl", 0x8421),
    )
}
