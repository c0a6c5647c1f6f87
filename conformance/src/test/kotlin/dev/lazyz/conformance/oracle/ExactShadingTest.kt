package dev.lazyz.conformance.oracle

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Spans
import dev.lazyz.conformance.broken.BrokenShading
import dev.lazyz.conformance.broken.Changes
import dev.lazyz.conformance.broken.Inside
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.frames.world.WorldFrames
import dev.lazyz.world.Material
import java.util.Random
import net.jqwik.api.Arbitrary
import net.jqwik.api.Example
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue

/** Compares set-up, light and textures of a scene with the contract in double precision. */
class ExactShadingTest {
    private val kinds = listOf(
        WorldFrames.cases(WorldFrames.rasters(24), 4),
        WorldFrames.blended(WorldFrames.rasters(24), 4),
        WorldFrames.turned(WorldFrames.rasters(24)),
    )

    @Example
    fun rule_6_5_coloursAreExact() {
        val comparison = Comparison()
        for (case in kinds.flatMap { some(it, 40) }) {
            assertNull(comparison.fault(case, exact(case))) { "in\n$case" }
        }
        assertTrue(comparison.judged > 0.9 * comparison.samples) { "$comparison" }
        assertTrue(comparison.exact > 0.99 * comparison.judged) { "$comparison" }
    }

    /** Each mistake in the library's shading would be noticed. */
    @Example
    fun rule_6_5_mistakesAreFound() {
        val cases = kinds.flatMap { some(it, 25) }
        val mistakes = mapOf<String, (Inside, Changes) -> Unit>(
            "highlights" to Inside.Companion::loseHighlight,
            "emission" to Inside.Companion::loseEmission,
            "normals" to Inside.Companion::turnNormals,
            "filter" to Inside.Companion::readNearest,
            "perspective" to Inside.Companion::interpolateOnScreen,
        )
        for ((name, mistake) in mistakes) {
            val fault = cases.firstNotNullOfOrNull { case ->
                val exact = exact(case)
                BrokenShading.changed(case.frame, mistake) { Comparison().fault(case, exact) }
            }
            assertNotNull(fault, name)
        }
    }

    /** Uses copies of the materials, which the mistakes do not affect. */
    private fun exact(case: FrameCase): ExactShading {
        val scene = checkNotNull(case.scene).withMaterials {
            Material(
                it.baseColor, it.texture?.run { withSampling(filter, wrapU, wrapV) }, it.shading, it.specular,
                it.shininess, it.emission, it.alphaMode, it.alphaCutoff, it.sides,
            )
        }
        return ExactShading(scene, case.frame.raster)
    }

    /** Compares the colours of all primitives at all samples that they cover, hidden or not. */
    private class Comparison {
        var samples = 0
        var judged = 0
        var exact = 0

        /** Describes the first colour that is not permitted; null if there is none. */
        fun fault(case: FrameCase, shading: ExactShading): String? {
            val frame = case.frame
            check(shading.primitives.size == frame.primitives.size)
            for (i in frame.primitives.indices) {
                for (y in 0 until frame.height) fault(frame, i, y, shading.primitives[i])?.let { return it }
            }
            return null
        }

        private fun fault(frame: Frame, i: Int, y: Int, exactColor: ExactColor): String? {
            val primitive = frame.primitives[i]
            val spans = Spans().also { primitive.spans(y, it) }
            val fragment = Fragment()
            for (span in 0 until spans.count) {
                for (x in spans.start(span) until spans.end(span)) {
                    fragment.moveTo(x, y)
                    primitive.shade(fragment)
                    val words = fault(fragment.toArgb(), exactColor.at(x, y)) ?: continue
                    return "primitive $i at ($x, $y): $words"
                }
            }
            return null
        }

        private fun fault(argb: Int, permitted: List<DoubleArray>): String? {
            samples++
            if (permitted.isEmpty()) return null
            judged++
            val codes = permitted.map { color ->
                List(4) { k ->
                    if (k < 3) ExactTexture.encoded(color[k]) else 255.0 * color[3].coerceIn(0.0, 1.0)
                }
            }
            val actual = listOf(argb ushr 16 and 0xFF, argb ushr 8 and 0xFF, argb and 0xFF, argb ushr 24)
            if (codes.any { code -> (0 until 4).all { Math.abs(code[it] - actual[it]) <= 0.5 } }) exact++
            for (k in 0 until 4) {
                val range = codes.minOf { it[k] } - 1.0..codes.maxOf { it[k] } + 1.0
                if (actual[k].toDouble() !in range) {
                    return "component $k of #%08x is not in %s".format(argb, range)
                }
            }
            return null
        }

        override fun toString(): String = "of $samples samples $judged were judged, and $exact of them exact"
    }

    private fun some(frames: Arbitrary<FrameCase>, count: Int): List<FrameCase> {
        val generator = frames.generator(1000)
        val random = Random(1995)
        return List(count) { generator.next(random).value() }
    }
}
