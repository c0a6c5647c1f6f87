package dev.lazyz

import dev.lazyz.spi.Attributes
import dev.lazyz.spi.BatchShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Shader
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

    /** Contract rule 6.1: each shader sets one fragment in two, alone and in a batch. */
    @Test
    fun coloursThatAreNotSetAreBlack() {
        val plain = Shader { if (it.x == 1) it.setColor(1f, 1f, 1f, 0f) }
        val batched = BatchShader {
            for (i in 0 until it.size) {
                if (it.x[i] == 1) for (component in listOf(it.red, it.green, it.blue)) component[i] = 1f
                if (it.x[i] == 1) it.alpha[i] = 0f
            }
        }
        val batch = FragmentBatch(2)
        batch.begin(0)
        batch.size = 2
        val fragment = Fragment()
        for (shader in listOf(plain, batched)) {
            for (first in listOf(1, 0, 1)) {
                batch.place(0, first, 0, 1)
                batch.place(1, 1 - first, 0, 1)
                batch.shade(shader)
                for (i in 0..1) {
                    fragment.moveTo(batch.x[i], 0)
                    shader.shade(fragment)
                    val expected = if (batch.x[i] == 1) listOf(1f, 1f, 1f, 0f) else listOf(0f, 0f, 0f, 1f)
                    assertEquals(expected, with(batch) { listOf(red[i], green[i], blue[i], alpha[i]) })
                    assertEquals(expected, with(fragment) { listOf(red, green, blue, alpha) })
                }
            }
        }
    }
}
