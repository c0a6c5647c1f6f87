package dev.lazyz.conformance.mutants

import dev.lazyz.Primitive
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Spans

/** A primitive as seen by a renderer that misreads spans. */
internal abstract class Misread(primitive: Primitive) : Recovered(primitive) {
    protected abstract fun misread(from: Spans, to: Spans)

    override fun spans(y: Int, spans: Spans) {
        val read = Spans()
        whole.spans(y, read)
        misread(read, spans)
    }
}

/** Every span lacks its last column. */
internal class ShortSpans(primitive: Primitive) : Misread(primitive) {
    override fun misread(from: Spans, to: Spans) {
        for (i in 0 until from.count) if (from.end(i) - 1 > from.start(i)) to.add(from.start(i), from.end(i) - 1)
    }
}

/** One span from the first start to the last end. */
internal class FilledGaps(primitive: Primitive) : Misread(primitive) {
    override fun misread(from: Spans, to: Spans) {
        if (from.count > 0) to.add(from.start(0), from.end(from.count - 1))
    }
}

/** Shaded one column too far left. */
class ShiftedShade(private val primitive: Primitive) : Primitive by primitive {
    override fun shade(fragment: Fragment) {
        fragment.moveTo(fragment.x - 1, fragment.y)
        primitive.shade(fragment)
    }
}

/** At the same depth everywhere. */
class AtDepth(private val primitive: Primitive, private val depth: Int) : Primitive by primitive {
    override val depthForm: LinearForm get() = LinearForm.constant(depth)

    override fun depth(x: Int, y: Int): Int = depth
}

/** Whether some row has a span. */
fun Primitive.coversAnything(): Boolean = (rowStart until rowEnd).any { y ->
    Spans().also { spans(y, it) }.count > 0
}
