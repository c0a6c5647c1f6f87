package dev.lazyz.conformance.cases.changed

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.UncoveredPrimitive
import dev.lazyz.scenes.Tint
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.SpanCursor
import dev.lazyz.spi.Spans
import java.util.Collections

/** A primitive with other coverage than [whole]. Its cursor calls [spans] for each row. */
internal abstract class Recovered(protected val whole: Primitive) : Primitive by whole {
    override fun cursor(y: Int): SpanCursor {
        var row = y
        return SpanCursor { spans ->
            spans.clear()
            spans(row++, spans)
        }
    }

    /** Adds the part of row [y] of [whole] within [columns], moved [by] columns. */
    protected fun add(y: Int, columns: IntRange, by: Int, spans: Spans) {
        val all = Spans(columns.first, columns.last + 1)
        whole.spans(y, all)
        for (i in 0 until all.count) spans.add(all.start(i) + by, all.end(i) + by)
    }
}

/** What [whole] covers, with bounds that are much larger than any raster (contract rule 2.8). */
internal class Unbounded(whole: Primitive) : Recovered(whole) {
    override val columnStart: Int get() = -FAR
    override val columnEnd: Int get() = FAR
    override val rowStart: Int get() = -FAR
    override val rowEnd: Int get() = FAR

    override fun spans(y: Int, spans: Spans): Unit = whole.spans(y, spans)

    private companion object {
        const val FAR = 1 shl 30
    }
}

/** The part of [whole] within [columns] and [rows]. */
internal class Cutting(whole: Primitive, private val columns: IntRange, private val rows: IntRange) :
    Recovered(whole) {
    override val columnStart: Int get() = maxOf(whole.columnStart, columns.first)
    override val columnEnd: Int get() = minOf(whole.columnEnd, columns.last + 1)
    override val rowStart: Int get() = maxOf(whole.rowStart, rows.first)
    override val rowEnd: Int get() = minOf(whole.rowEnd, rows.last + 1)

    override fun spans(y: Int, spans: Spans) {
        if (y in rows) add(y, columns, 0, spans)
    }
}

/** A primitive [whole] of a raster with [height] rows, moved by [right] columns and [down] rows. */
internal class Moved(whole: Primitive, private val height: Int, private val right: Int, private val down: Int) :
    Recovered(whole) {
    override val columnStart: Int get() = whole.columnStart + right
    override val columnEnd: Int get() = whole.columnEnd + right
    override val rowStart: Int get() = whole.rowStart + down
    override val rowEnd: Int get() = whole.rowEnd + down

    /** The same plane, relative to another sample. Sums wrap around, so the bits are the same (rule 3.1). */
    override val depthForm: LinearForm?
        get() = whole.depthForm?.let { LinearForm(it.c - it.dx * right - it.dy * down, it.dx, it.dy) }

    override fun spans(y: Int, spans: Spans) {
        if (y - down in 0 until height) add(y - down, 0..<Int.MAX_VALUE, right, spans)
    }

    override fun depth(x: Int, y: Int): Int = whole.depth(x - right, y - down)

    override fun shade(fragment: Fragment): Unit = shadeElsewhere(fragment, whole::shade)

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? {
        val cursor = whole.shadingCursor(x - right, y - down) ?: return null
        return object : ShadingCursor {
            override fun step() = cursor.step()

            override fun shade(fragment: Fragment) = shadeElsewhere(fragment, cursor::shade)
        }
    }

    /** Gives [fragment] the colour that [shade] computes where this primitive was before it was moved. */
    private fun shadeElsewhere(fragment: Fragment, shade: (Fragment) -> Unit) {
        val elsewhere = Fragment()
        elsewhere.moveTo(fragment.x - right, fragment.y - down)
        shade(elsewhere)
        fragment.setColor(elsewhere.red, elsewhere.green, elsewhere.blue, elsewhere.alpha)
    }
}

/**
 * A primitive one unit behind the visible surface in [image] at each sample, except where no such depth exists. It must
 * never be visible.
 */
internal class HiddenSurface(private val raster: Raster, private val image: Image) : Primitive {
    private val shader: Shader = Tint(-1)
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = raster.height
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = raster.width

    private val isLeastVisible = raster.depthTest == DepthTest.LESS || raster.depthTest == DepthTest.LESS_OR_EQUAL

    override fun spans(y: Int, spans: Spans) {
        for (x in 0 until raster.width) if (hasRoom(image.depth(x, y))) spans.add(x, x + 1)
    }

    private fun hasRoom(depth: Int) = if (isLeastVisible) depth < Int.MAX_VALUE else depth > 0

    override fun depth(x: Int, y: Int): Int = image.depth(x, y) + if (isLeastVisible) 1 else -1

    override fun shade(fragment: Fragment): Unit = shader.shade(fragment)
}

/** Returns the frame with all primitives appended a second time. */
internal fun FrameCase.doubled(): FrameCase = FrameCase(
    Frame(frame.raster, frame.primitives + frame.primitives),
    "$code\n    .let { Frame(it.raster, it.primitives + it.primitives) }",
    sceneOf { it + it },
)

/** Returns the frame with tens of thousands of primitives with empty bounds before its last primitives. */
internal fun FrameCase.behindMany(): FrameCase {
    val half = frame.primitives.size / 2
    val nothing = Collections.nCopies(MANY, Cutting(UncoveredPrimitive(frame.raster), 0..<0, 0..<0))
    return FrameCase(
        Frame(frame.raster, frame.primitives.take(half) + nothing + frame.primitives.drop(half)),
        "$code\n    .let { SuiteFrames.behindMany(it) }",
    )
}

/**
 * Nearly twice 2^16. If an index is cut to 16 bits, the primitives after these seem to be submitted before the ones in
 * front of them.
 */
private const val MANY = 131_070

/** Returns the frame with an additional primitive just behind what is visible in [image]. */
internal fun FrameCase.backed(image: Image): FrameCase = FrameCase(
    Frame(frame.raster, frame.primitives + HiddenSurface(frame.raster, image)),
    "$code\n    .let { SuiteFrames.backed(it) }",
)

/** Splits each primitive i at [column]: 2 i is the part before it, 2 i + 1 the part from there on. */
internal fun FrameCase.cutAtColumn(column: Int): FrameCase = cut("cutAtColumn(it, $column)") {
    listOf(Cutting(it, 0..<column, 0..<Raster.MAX_SIDE), Cutting(it, column..<Raster.MAX_SIDE, 0..<Raster.MAX_SIDE))
}

/** Splits each primitive i at `row`: 2 i is the part above it, 2 i + 1 the part from there on. */
internal fun FrameCase.cutAtRow(row: Int): FrameCase = cut("cutAtRow(it, $row)") {
    listOf(Cutting(it, 0..<Raster.MAX_SIDE, 0..<row), Cutting(it, 0..<Raster.MAX_SIDE, row..<Raster.MAX_SIDE))
}

private fun FrameCase.cut(call: String, halves: (Primitive) -> List<Primitive>): FrameCase =
    FrameCase(Frame(frame.raster, frame.primitives.flatMap(halves)), "$code\n    .let { SuiteFrames.$call }")

/** Returns the frame with all primitives moved [right] columns and [down] rows, on an accordingly larger raster. */
internal fun FrameCase.moved(right: Int, down: Int): FrameCase = FrameCase(
    Frame(
        with(frame.raster) { withSize(width + right, height + down) },
        frame.primitives.map { Moved(it, frame.raster.height, right, down) },
    ),
    "$code\n    .let { SuiteFrames.moved(it, $right, $down) }",
)

/** Half of [few], then [MILLIONS] times [nothing], then the other half: a list that takes no memory. */
private class WithMillions(private val few: List<Primitive>, private val nothing: Primitive) :
    AbstractList<Primitive>(),
    RandomAccess {
    private val half = few.size / 2
    override val size: Int get() = few.size + MILLIONS

    override fun get(index: Int): Primitive = when {
        index < half -> few[index]
        index < half + MILLIONS -> nothing
        else -> few[index - MILLIONS]
    }
}

/** Returns the frame with [MILLIONS] primitives with empty bounds after half of its primitives. */
internal fun FrameCase.behindMillions(): FrameCase = FrameCase(
    Frame(frame.raster, WithMillions(frame.primitives, Cutting(UncoveredPrimitive(frame.raster), 0..<0, 0..<0))),
    "$code\n    .let { SuiteFrames.behindMillions(it) }",
)

/** More than a float can represent exactly. */
internal const val MILLIONS: Int = (1 shl 24) + 1
