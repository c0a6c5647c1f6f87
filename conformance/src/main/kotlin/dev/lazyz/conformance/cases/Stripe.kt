package dev.lazyz.conformance.cases

import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.Spans
import java.util.concurrent.atomic.AtomicBoolean

/**
 * A red primitive that covers the samples of [columns] in [rows] at [depth]. Calls [onQuery] with the row before it
 * adds spans, and before it shades its first column.
 */
internal class Stripe(
    private val columns: IntProgression,
    private val rows: IntRange,
    private val depth: Int,
    private val onQuery: (y: Int) -> Unit = {},
) : Primitive {
    override val rowStart: Int get() = rows.first
    override val rowEnd: Int get() = rows.last + 1
    override val columnStart: Int get() = columns.first
    override val columnEnd: Int get() = columns.last + 1
    override val leastDepth: Int get() = depth
    override val greatestDepth: Int get() = depth

    override fun spans(y: Int, spans: Spans) {
        onQuery(y)
        if (y in rows) for (x in columns) spans.add(x, x + 1)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment) {
        if (fragment.x == columnStart) onQuery(fragment.y)
        fragment.setColor(1f, 0f, 0f)
    }
}

/** Calls [action] the first time that it is called with [key]. Thread safe. */
internal class Once(private val key: Int, private val action: () -> Unit) : (Int) -> Unit {
    private val isOver = AtomicBoolean()

    override fun invoke(value: Int) {
        if (value == key && isOver.compareAndSet(false, true)) action()
    }
}
