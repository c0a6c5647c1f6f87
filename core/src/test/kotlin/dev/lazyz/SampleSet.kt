package dev.lazyz

import dev.lazyz.spi.Spans
import org.junit.jupiter.api.Assertions.assertTrue

/** A set of samples of a raster. */
class SampleSet(val width: Int, val height: Int) {
    private val bits = BooleanArray(width * height)

    val size: Int get() = bits.count { it }

    operator fun get(x: Int, y: Int): Boolean = bits[y * width + x]

    operator fun set(x: Int, y: Int, value: Boolean) {
        bits[y * width + x] = value
    }

    override fun equals(other: Any?): Boolean =
        other is SampleSet && width == other.width && bits.contentEquals(other.bits)

    override fun hashCode(): Int = bits.contentHashCode()

    override fun toString(): String = (0 until height).joinToString("\n", "\n", "\n") { y ->
        (0 until width).joinToString("") { x -> if (this[x, y]) "#" else "." }
    }

    companion object {
        fun where(width: Int, height: Int, isIn: (Int, Int) -> Boolean): SampleSet {
            val set = SampleSet(width, height)
            for (y in 0 until height) for (x in 0 until width) set[x, y] = isIn(x, y)
            return set
        }
    }
}

/** Returns the samples that this primitive covers, and checks its spans against contract rule 2.3. */
fun Primitive.samples(raster: Raster): SampleSet {
    val set = SampleSet(raster.width, raster.height)
    val spans = Spans()
    for (y in 0 until raster.height) {
        spans.clear()
        spans(y, spans)
        addRow(set, y, spans)
    }
    return set
}

/** Returns the samples that the cursor of this primitive returns, from [firstRow] on. */
fun Primitive.samplesByCursor(raster: Raster, firstRow: Int): SampleSet {
    val set = SampleSet(raster.width, raster.height)
    val spans = Spans()
    val cursor = cursor(firstRow)
    for (y in firstRow until raster.height) {
        cursor.next(spans)
        addRow(set, y, spans)
    }
    return set
}

private fun Primitive.addRow(set: SampleSet, y: Int, spans: Spans) {
    var last = -1
    for (i in 0 until spans.count) {
        val start = spans.start(i)
        val end = spans.end(i)
        assertTrue(start < end && start > last && start >= 0 && end <= set.width) { "row $y of $this: $spans" }
        assertTrue(y in rowStart until rowEnd && start >= columnStart && end <= columnEnd) {
            "row $y is outside the bounds of $this: $spans"
        }
        for (x in start until end) set[x, y] = true
        last = end
    }
}
