package dev.lazyz.conformance.report

import dev.lazyz.Image
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.differsAt
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.sendTo
import java.io.ByteArrayOutputStream

/** The pictures of a failure as PNG, magnified so that single samples can be seen. */
internal class Pictures private constructor(private val expected: Image, private val actual: Image) {
    /** PNG files by content: `expected`, `actual` and, unless they are equal, `difference`. */
    fun png(): Map<String, ByteArray> {
        val isDifferent = difference(expected, actual) != null
        return listOfNotNull(
            "expected" to png(expected),
            "actual" to png(actual),
            if (isDifferent) "difference" to png(marked()) else null,
        ).toMap()
    }

    /** White where the pictures are equal, red where colours differ, blue where only depth or primitive differs. */
    private fun marked(): Image {
        val argb = IntArray(expected.argb.size) { i ->
            when {
                !expected.differsAt(actual, i) -> SAME
                expected.argb[i] != actual.argb[i] -> OTHER_COLOR
                else -> OTHER_DEPTH
            }
        }
        return Image(expected.region, argb, expected.depth, expected.primitive, expected.counters)
    }

    private fun png(image: Image): ByteArray {
        val magnified = magnified(image)
        val bytes = ByteArrayOutputStream()
        PngSink(bytes, magnified.width, magnified.height).use { magnified.sendTo(it) }
        return bytes.toByteArray()
    }

    private fun magnified(image: Image): Image {
        val factor = (SIDE / maxOf(image.width, image.height)).coerceIn(1, GREATEST_FACTOR)
        val width = image.width * factor
        val height = image.height * factor
        fun enlarged(values: IntArray) = IntArray(width * height) { i ->
            values[i / width / factor * image.width + i % width / factor]
        }
        return Image(
            width, height, enlarged(image.argb), enlarged(image.depth), enlarged(image.primitive), image.counters,
        )
    }

    companion object {
        private const val SIDE = 240
        private const val GREATEST_FACTOR = 40
        private const val SAME = 0xFFFFFFFF.toInt()
        private const val OTHER_COLOR = 0xFFD02020.toInt()
        private const val OTHER_DEPTH = 0xFF2040D0.toInt()

        /** Returns the pictures of [failure], or null if it has none. */
        fun of(failure: RuleFailure): Pictures? {
            val expected = failure.expected ?: return null
            val actual = failure.actual ?: return null
            return Pictures(expected, actual)
        }
    }
}
