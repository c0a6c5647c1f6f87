package dev.lazyz.conformance

import dev.lazyz.Frame
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Multitude
import dev.lazyz.conformance.cases.changed.cutAtRow
import dev.lazyz.conformance.cases.changed.flecked
import dev.lazyz.conformance.cases.changed.moved
import dev.lazyz.conformance.cases.changed.padded
import dev.lazyz.conformance.cases.changed.withHiddenGlass
import dev.lazyz.conformance.cases.veils
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.probes.smallFrames
import dev.lazyz.conformance.probes.surfacesOfOneShader
import dev.lazyz.conformance.probes.textured
import dev.lazyz.strategies.lists.ListsRenderer
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** A frame of a report can be made outside the suite, by the call that the report names. */
class SuiteFramesTest {
    private fun assertSame(case: FrameCase, code: String, made: Frame) {
        assertEquals(code, case.code)
        assertNull(difference(ListsRenderer().render(case.frame), ListsRenderer().render(made)), code)
    }

    @Test
    fun framesOfANumberAreThoseOfTheRules() {
        assertSame(textured(3659), "SuiteFrames.textured(3659L)", SuiteFrames.textured(3659))
        assertSame(surfacesOfOneShader(7), "SuiteFrames.surfacesOfOneShader(7L)", SuiteFrames.surfacesOfOneShader(7))
        assertSame(veils(5), "SuiteFrames.veils(5L)", SuiteFrames.veils(5))
        val sorted = Multitude.ofSorted(fromFar = true, isTranslucent = true).case
        assertSame(sorted, "SuiteFrames.sorted(true, true)", SuiteFrames.sorted(fromFar = true, isTranslucent = true))
    }

    @Test
    fun changedFramesAreThoseOfTheRules() {
        val frame = smallFrames.first()
        val case = FrameCase(frame, "frame")
        fun code(call: String) = "frame\n    .let { SuiteFrames.$call }"
        assertSame(case.padded(), code("padded(it)"), SuiteFrames.padded(frame))
        assertSame(case.flecked(), code("flecked(it)"), SuiteFrames.flecked(frame))
        assertSame(case.cutAtRow(3), code("cutAtRow(it, 3)"), SuiteFrames.cutAtRow(frame, 3))
        assertSame(case.moved(2, 1), code("moved(it, 2, 1)"), SuiteFrames.moved(frame, 2, 1))
        val glass = case.withHiddenGlass(Random(1)).last()
        val (index, place) = Regex("""it, (\d+), "(\w+)""").find(glass.code)!!.destructured
        assertSame(glass, glass.code, SuiteFrames.withHiddenGlass(frame, index.toInt(), place))
    }

    /** What is a comment is no code. */
    @Test
    fun codeOfFailuresIsNoComment() {
        val suite = Conformance { WrongColors() }.tries(0.01).withoutShrinking()
        for (rule in listOf("1.3", "2.5", "6.1")) suite.rule(rule)
        val codes = suite.run().results.mapNotNull { it.failure?.code }
        assertTrue(codes.size > 2, "$codes")
        assertEquals(emptyList<String>(), codes.filter { "//" in it || "/*" in it })
    }
}
