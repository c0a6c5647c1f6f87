package dev.lazyz.spark.scaling

import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class ScalingModelTest {
    private fun facts(overdraw: Double) =
        PictureFacts(samples = 4000, visible = 1000, bandEnds = listOf(0.25, 0.5, 0.75, 1.0), overdraw)

    private fun sizes(split: Split, exponent: Double, overdraw: Double = 2.0) =
        PartSizes(facts(overdraw), split, exponent, doubleArrayOf(4.0, 2.0))

    private fun model(split: Split, exponent: Double, overdraw: Double) = ScalingModel(
        facts(overdraw), sizes(split, exponent, overdraw), drawing = doubleArrayOf(1.0, 0.0, 0.0, 0.0),
        merging = doubleArrayOf(0.0, 1.0, 0.0), Network(1e9, 1.0),
    )

    @Test
    fun theFitFindsItsOwnFactors() {
        val factors = doubleArrayOf(3e-7, 2e-9, 5e-3)
        val features = (1..6).map { doubleArrayOf(1e6 / it, 4e6 * it, 1.0 + it % 3) }
        assertArrayEquals(factors, Fit.factors(features, features.map { Fit.sum(factors, it) }), 1e-12)
    }

    @Test
    fun noFactorIsNegative() {
        val features = listOf(doubleArrayOf(1.0, 1.0), doubleArrayOf(1.0, 2.0), doubleArrayOf(1.0, 3.0))
        val found = Fit.factors(features, listOf(3.0, 2.0, 1.0))
        assertEquals(0.0, found[1])
        assertEquals(true, found[0] > 0)
    }

    @Test
    fun theExponentIsFoundAgain() {
        for (split in Split.entries) {
            val shares = listOf(0.25, 0.125, 1.0 / 16)
            val covered = shares.map {
                sizes(split, 0.7).fragments(ExpectedPiece(0.0, it, 4000.0, 0.0, 1.0, 1.0)) / 1000
            }
            assertEquals(0.7, PartSizes.exponent(facts(2.0), split, shares, covered), 1e-9)
        }
    }

    @Test
    fun bandsOfAPartAddUpToIt() {
        for (split in Split.entries) {
            val bands = (0 until 4).sumOf {
                sizes(split, 0.7).fragments(ExpectedPiece(0.0, 0.25, 1000.0, it / 4.0, (it + 1) / 4.0, 1.0))
            }
            assertEquals(sizes(split, 0.7).fragments(ExpectedPiece(0.0, 0.25, 4000.0, 0.0, 1.0, 1.0)), bands, 1e-9)
        }
    }

    @Test
    fun factorsMultiplyToTheNodes() {
        assertEquals(listOf(8, 5, 5, 5), ScalingMeasurements.factors(1000, 8))
        assertEquals(listOf(8, 4), ScalingMeasurements.factors(32, 8))
        assertEquals(listOf(2, 2, 2), ScalingMeasurements.factors(8, 2))
        assertEquals(emptyList<Int>(), ScalingMeasurements.factors(1, 8))
        assertEquals(listOf(2, 11), ScalingMeasurements.factors(22, 8))
    }

    /** Four nodes at random, and two layers: each merges two halves of 437.5 fragments, then two quarters of 750. */
    @Test
    fun theModelMergesWhatItExpects() {
        val swap = model(Split.SCATTERED, 2.0, 2.0).swap(4, listOf(2, 2))
        assertEquals(437.5 + 2 * 750 / 4.0, swap.mergeSeconds, 1e-9)
        assertEquals(4, swap.pieces.size)
        assertEquals(listOf(0.0 to 1.0), swap.pieces.map { it.from to it.to }.distinct())
    }

    /** A range of a quarter that reaches no further is in one band of four, and nothing has to be sent. */
    @Test
    fun rangesThatReachOneBandStayThere() {
        val tree = model(Split.RANGES, 1.0, overdraw = 1.0).tree(4)
        assertEquals(0L, tree.totalBytes)
        assertEquals(4, tree.pieces.size)
    }
}
