package dev.lazyz.scenes.builtin

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class TeapotPatchesTest {
    @Test
    fun sampledControlPointsAreThePublishedOnes() {
        val published =
            listOf(
                // Rim, body, handle, where the handle meets the body, spout, knob, lid, bottom
                listOf(0.784, -1.4, 2.4),
                listOf(-1.12, 2.0, 0.9),
                listOf(-2.65, -0.3, 0.9375),
                listOf(-2.0, 0.0, 0.9),
                listOf(3.525, -0.25, 2.49375),
                listOf(-0.8, 0.45, 3.15),
                listOf(-0.728, 1.3, 2.4),
                listOf(-1.425, -0.798, 0.0),
            )
        val actual = TeapotPatches.all.flatMap { points(it) }.toSet()
        assertEquals(emptyList<List<Double>>(), published - actual)
    }

    @Test
    fun setOfPatchesIsSymmetric() {
        val patches = TeapotPatches.all.map { points(it) }.toSet()
        assertEquals(32, patches.size)
        // The whole is symmetric front to back, body and lid left to right as well
        assertEquals(patches, TeapotPatches.all.map { points(it.mirrored(Axis.Y)) }.toSet())
        val round = TeapotPatches.body + TeapotPatches.lid
        assertEquals(round.map { points(it) }.toSet(), round.map { points(it.mirrored(Axis.X)) }.toSet())
    }

    private fun points(patch: BezierPatch): List<List<Double>> = patch.controlPoints.toList().chunked(BezierPatch.AXES)
}
