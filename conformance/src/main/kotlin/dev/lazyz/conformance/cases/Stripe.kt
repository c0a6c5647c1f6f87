package dev.lazyz.conformance.cases

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
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

/**
 * A primitive that covers nothing, although its bounds are the whole raster. Throws when its depth or colour is
 * queried.
 */
internal class UncoveredPrimitive(private val raster: Raster) : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = raster.height
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = raster.width

    override fun spans(y: Int, spans: Spans): Unit = Unit

    override fun depth(x: Int, y: Int): Int =
        throw AssertionError("depth was queried at ($x, $y), where nothing is covered")

    override fun shade(fragment: Fragment): Unit =
        throw AssertionError("shade was called at (${fragment.x}, ${fragment.y}), where nothing is covered")
}
