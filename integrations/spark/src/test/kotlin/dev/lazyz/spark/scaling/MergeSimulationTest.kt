package dev.lazyz.spark.scaling

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Simulations whose results are known: pictures of some samples, a second for each sample that is merged. */
class MergeSimulationTest {
    private val raw = RawCompositing(secondsPerSample = 1.0)
    private val simulation = MergeSimulation(raw, Network(bytesPerSecond = 12.0, latency = 100.0))
    private val picture = 64L

    @Test
    fun fourNodesSwapHalvesThenQuarters() {
        val swap = simulation.swap(List(4) { picture }, listOf(2, 2))
        assertEquals(listOf(12 * 32L, 12 * 16L), swap.roundBytes)
        assertEquals(32.0 + 16, swap.mergeSeconds)
        assertEquals(3 * 100.0 + 32 + 16 + 48, swap.networkSeconds)
    }

    /** In round r each of P nodes sends the picture / 2^r: in total P - 1 pictures, whatever the factors. */
    @Test
    fun binarySwapSendsThePictureOnceForEachOtherNode() {
        for (rounds in 1..6) {
            val nodes = 1 shl rounds
            val swap = simulation.swap(List(nodes) { picture }, List(rounds) { 2 })
            assertEquals(12 * picture * (nodes - 1), swap.totalBytes)
            assertEquals(12 * picture * (nodes - 1) / nodes, swap.collectedBytes)
            assertEquals(12 * picture * (nodes - 1) / nodes, swap.roundBytes.sum())
            val radix = simulation.swap(List(nodes) { picture }, ScalingMeasurements.factors(nodes, 8))
            assertEquals(swap.totalBytes, radix.totalBytes)
        }
    }

    @Test
    fun factorsMustFit() {
        val error = assertThrows(IllegalArgumentException::class.java) {
            simulation.swap(List(4) { picture }, listOf(2))
        }
        assertEquals("[2] must multiply to 4 nodes", error.message)
    }

    @Test
    fun fourNodesMergePairsAndThenAll() {
        // Groups 0 and 1 of band 0 are merged by nodes 0 and 1: two of four parts cross, and node 1 gets two of them
        val tree = simulation.tree(List(4) { mapOf(0 to picture) }, bands = 1, fanIn = 2)
        assertEquals(listOf(12 * 128L, 12 * 64L), tree.roundBytes)
        assertEquals(12 * (3 + 1) * 64L, tree.totalBytes)
        assertEquals(64.0 + 64, tree.mergeSeconds)
        assertEquals(listOf(picture), tree.pieces)
    }

    @Test
    fun tasksAreNoMoreThanHaveWork() {
        val tree = simulation.tree(List(64) { mapOf(0 to picture, 1 to picture, 2 to picture) }, bands = 3)

        // Eight groups of each of the three bands, then one
        assertEquals(3 * 8 + 3, tree.tasks)
    }
}
