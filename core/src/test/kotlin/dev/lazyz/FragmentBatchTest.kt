package dev.lazyz

import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Nothing of the fragments of a batch remains for the next ones. */
class FragmentBatchTest {
    /** A surface with one set of coordinates after one with the other set: contract rule 6.2. */
    @Test
    fun derivativesOfCoordinatesThatThereAreNotAreReset() {
        val batch = FragmentBatch(1)
        val first = Attributes.FOOTPRINT or Attributes.UV
        val second = Attributes.FOOTPRINT or Attributes.UV2
        for ((before, after) in listOf(first to second, second to first, first to Attributes.UV, second to 0)) {
            batch.begin(before)
            batch.dudx[0] = if (before == first) 7f else 0f
            batch.dvdy[0] = if (before == first) 7f else 0f
            batch.du2dx[0] = if (before == second) 7f else 0f
            batch.dv2dy[0] = if (before == second) 7f else 0f
            batch.begin(after)
            val left = listOf(batch.dudx, batch.dvdy, batch.du2dx, batch.dv2dy).map { it[0] }
            assertEquals(listOf(0f, 0f, 0f, 0f), left, "$before, then $after")
        }
    }
}
