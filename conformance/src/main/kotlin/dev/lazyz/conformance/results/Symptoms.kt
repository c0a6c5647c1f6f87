package dev.lazyz.conformance.results

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.conformance.cases.Confetti
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.UncoveredPrimitive
import dev.lazyz.conformance.judgement.FirstDifference
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.rules.Symptom
import dev.lazyz.spi.Spans
import java.util.EnumSet

/** Determines the [Symptom]s of a failure from its frame and its pictures. */
internal object Symptoms {
    /** More primitives than a short can number. */
    private const val MANY = 1 shl 15

    /** Returns the symptoms of the exception [thrown], or null if they cannot be determined. */
    fun of(thrown: Throwable): Set<Symptom>? {
        val violation = thrown as? Violation ?: return null
        return try {
            found(violation)
        } catch (_: Exception) {
            // Custom primitives may throw anything; the diagnosis itself must not fail
            null
        }
    }

    private fun found(violation: Violation): Set<Symptom> {
        val symptoms = EnumSet.noneOf(Symptom::class.java)
        val frame = violation.case.frame
        ofFrame(violation.case, symptoms)
        if (violation.isConfigured) symptoms.add(Symptom.OPTIONS)
        if (violation.isAgain) symptoms.add(Symptom.AGAIN)
        if (violation.areRowsWrong) symptoms.add(Symptom.ROWS)
        val expected = violation.expected
        val actual = violation.actual
        if (expected == null || actual == null) {
            if (violation.cause !is Error) symptoms.add(Symptom.PICTURE)
            symptoms.add(Symptom.EXCEPTION)
            return symptoms
        }
        val difference = difference(expected, actual)
        if (difference == null) {
            symptoms.add(Symptom.COUNTERS)
        } else {
            symptoms.add(Symptom.PICTURE)
            ofSample(frame, difference, symptoms)
        }
        return symptoms
    }

    private fun ofFrame(case: FrameCase, symptoms: MutableSet<Symptom>) {
        val frame = case.frame
        val raster = frame.raster
        if (raster.depthTest != raster.convention.nearest) symptoms.add(Symptom.DEPTH_TEST)
        val behind = Rasters.behindAll(raster.depthTest)
        if (behind != Rasters.behindAll(raster.convention.nearest)) symptoms.add(Symptom.AGAINST_CONVENTION)
        if (behind == 0) symptoms.add(Symptom.GREATEST_WINS)
        if (frame.region != raster.region) symptoms.add(Symptom.REGION)
        if (frame.hasTranslucency) symptoms.add(Symptom.TRANSLUCENT)
        if (frame.primitives.any { it is Confetti }) symptoms.add(Symptom.OWN_PRIMITIVE)
        if (case.scene?.isOnScreen == false) symptoms.add(Symptom.IN_SPACE)
        if (frame.primitives.isEmpty()) symptoms.add(Symptom.NO_PRIMITIVES)
        if (frame.primitives.size > MANY) symptoms.add(Symptom.MANY_PRIMITIVES)
        if (frame.primitives.asSequence().take(MANY).any { it.rowStart >= it.rowEnd || it is UncoveredPrimitive }) {
            symptoms.add(Symptom.EMPTY_PRIMITIVE)
        }
        if (raster.width == 1 || raster.height == 1) symptoms.add(Symptom.NARROW)
    }

    /** Adds the symptoms that the first differing sample shows. */
    private fun ofSample(frame: Frame, difference: FirstDifference, symptoms: MutableSet<Symptom>) {
        val x = difference.x
        val y = difference.y
        val right = difference.expected.primitive(x, y)
        val shown = difference.actual.primitive(x, y)
        val depth = difference.expected.depth(x, y)
        val raster = frame.raster
        if (difference.actual.depth.any { it == Recording.MISSING }) {
            symptoms.add(Symptom.ROWS)
            return
        }
        val rivals = frame.primitives.indices.count {
            frame.isAt(it, x, y) && frame.primitives[it].depth(x, y) == depth
        }
        val isBackgroundNear = raster.backgroundDepth != Rasters.behindAll(raster.depthTest)
        val isBackgroundTied = depth == raster.backgroundDepth && rivals > 0
        val isBackgroundShown = right == DepthTest.BACKGROUND || shown == DepthTest.BACKGROUND
        if (rivals > 1) symptoms.add(Symptom.TIE)
        if (isBackgroundShown && (isBackgroundNear || isBackgroundTied)) symptoms.add(Symptom.BACKGROUND)
        when {
            right == shown && depth != difference.actual.depth(x, y) -> symptoms.add(Symptom.DEPTH)
            right == shown -> symptoms.add(Symptom.COLOR)
            shown == DepthTest.BACKGROUND || !frame.isAt(shown, x, y) -> symptoms.add(Symptom.COVERAGE)
            right != DepthTest.BACKGROUND && rivals < 2 -> symptoms.add(Symptom.ORDER)
        }
    }

    private fun Frame.isAt(index: Int, x: Int, y: Int): Boolean {
        val primitive = primitives.getOrNull(index) ?: return false
        if (y !in primitive.rowStart until primitive.rowEnd) return false
        val spans = Spans().also { primitive.spans(y, it) }
        return (0 until spans.count).any { x >= spans.start(it) && x < spans.end(it) }
    }
}
