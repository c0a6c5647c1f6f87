package dev.lazyz.conformance.probes

import dev.lazyz.Cell
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.Selector
import java.util.concurrent.atomic.AtomicIntegerArray
import java.util.concurrent.atomic.AtomicReference

/**
 * A selector that shows the nearest fragment, computes the colour of the last, and notes for which samples of [region]
 * it is called. Thread safe.
 */
internal class CellWitness(private val region: Region) : Selector {
    private val calls = AtomicIntegerArray(region.size.toInt())
    private val problem = AtomicReference<String?>()

    override fun select(cell: Cell) {
        val (column, row) = cell.x - region.columnStart to cell.y - region.rowStart
        if (column in 0 until region.width && row in 0 until region.height) {
            calls.incrementAndGet(row * region.width + column)
        } else {
            problem.compareAndSet(null, "the selector is called for (${cell.x}, ${cell.y}), outside the region")
        }
        cell.shade(cell.size - 1)
        cell.show(0)
    }

    /** Describes a call too many or too few, or returns null. [image] is the right picture. */
    fun complaint(image: Image): String? = problem.get() ?: image.primitive.indices.firstNotNullOfOrNull { i ->
        val expected = if (image.primitive[i] == DepthTest.BACKGROUND) 0 else 1
        val place = "(${region.columnStart + i % region.width}, ${region.rowStart + i / region.width})"
        if (calls[i] == expected) null else "the selector is called ${calls[i]} times for $place, not $expected"
    }
}
