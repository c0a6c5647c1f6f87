package dev.lazyz.conformance.frames

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.frames.screen.ConfettiPiece
import dev.lazyz.conformance.frames.screen.PolygonPiece
import dev.lazyz.conformance.frames.screen.screenCase
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.report.ReportFiles
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.shared.NotByDefault
import dev.lazyz.spi.LinearForm
import net.jqwik.api.Example
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

@AddLifecycleHook(NotByDefault::class)
class FramesTest {
    @Example
    fun printedCodeMakesTheFrame() {
        val case = screenCase(
            Raster(7, 6, Rgba.WHITE, DepthConvention.LARGER_IS_NEARER),
            listOf(
                PolygonPiece(listOf(doubleArrayOf(0.0, 0.5, 0.25, 6.0, 0.0, 1.0, 3.0, 5.0, 0.5)), FillRule.EVEN_ODD),
                PolygonPiece(listOf(doubleArrayOf(Double.NaN, 0.0, 0.0), doubleArrayOf()), FillRule.NON_ZERO),
                ConfettiPiece(7, 1..20, 0..20, 5, null),
                ConfettiPiece(8, 0..5, 2..4, 1, LinearForm(Long.MIN_VALUE, 1, -2)),
            ),
        )
        val text = """
            FrameBuilder(Raster(7, 6, Rgba.WHITE, DepthConvention.LARGER_IS_NEARER, DepthTest.GREATER, 0))
                .polygon(Frames.tint(0), FillRule.EVEN_ODD, doubleArrayOf(0.0, 0.5, 0.25, 6.0, 0.0, 1.0, 3.0, 5.0, 0.5))
                .polygon(Frames.tint(1), FillRule.NON_ZERO, doubleArrayOf(Double.NaN, 0.0, 0.0), doubleArrayOf())
                .add(Confetti(7, 1, 7, 0, 6, 5))
                .add(Confetti(8, 0, 5, 2, 4, 1, LinearForm(Long.MIN_VALUE, 1L, -2L)))
                .build()
        """
        val frame =
            FrameBuilder(Raster(7, 6, Rgba.WHITE, DepthConvention.LARGER_IS_NEARER, DepthTest.GREATER, 0))
                .polygon(Frames.tint(0), FillRule.EVEN_ODD, doubleArrayOf(0.0, 0.5, 0.25, 6.0, 0.0, 1.0, 3.0, 5.0, 0.5))
                .polygon(Frames.tint(1), FillRule.NON_ZERO, doubleArrayOf(Double.NaN, 0.0, 0.0), doubleArrayOf())
                .add(Confetti(7, 1, 7, 0, 6, 5))
                .add(Confetti(8, 0, 5, 2, 4, 1, LinearForm(Long.MIN_VALUE, 1L, -2L)))
                .build()
        assertEquals(text.trimIndent(), case.toString())
        assertEquals(ReferenceRenderer().render(frame), ReferenceRenderer().render(case.frame))
    }

    /** The file of a failure imports each type that the code of its frame names, also where it is nested in another. */
    @Example
    fun typesOfPrintedCodeAreImported() {
        val cases = some(Frames.screen(), 50) + some(Frames.confetti(), 50) + some(Frames.world(), 300)
        val type = Regex("""(?<![\w."])[A-Z]\w*""")
        val named = cases.flatMap { case -> type.findAll(case.code).map { it.value } }.toSet() - KOTLIN
        assertTrue(named.containsAll(listOf("Confetti", "Scene", "AlphaMode", "Vertex"))) { "$named" }
        val (packages, types) = ReportFiles.IMPORTS.partition { it.endsWith(".*") }
        assertEquals(emptyList<String>(), types.filterNot(::isType))
        val missing = named.filterNot { name ->
            types.any { it.endsWith(".$name") } || packages.any { isType(it.removeSuffix("*") + name) }
        }
        assertEquals(emptyList<String>(), missing)
    }

    private fun isType(name: String): Boolean = generateSequence(name) { outer ->
        outer.lastIndexOf('.').takeIf { it >= 0 }?.let { outer.replaceRange(it, it + 1, "$") }
    }.any { runCatching { Class.forName(it, false, javaClass.classLoader) }.isSuccess }

    @Example
    fun sameSeedGivesTheSameFrames() {
        for (frames in listOf(Frames.screen(), Frames.tied(), Frames.confetti(), Frames.world())) {
            assertEquals(some(frames, 50).map { it.code }, some(frames, 50).map { it.code })
        }
    }

    @Example
    fun sizesAreUpperBounds() {
        val frames = some(Frames.screen(5, 3, 2), 300).map { it.frame }
        assertEquals(5, frames.maxOf { it.width })
        assertEquals(3, frames.maxOf { it.height })
        assertEquals(2, frames.maxOf { it.primitives.size })
    }

    private companion object {
        val KOTLIN = setOf("Double", "Float", "Long")
    }
}
