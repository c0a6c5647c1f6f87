package dev.lazyz.conformance.strangers3

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink

/** What all renderers here have in common: a name, options, and at most one mistake. */
internal abstract class Third(base: String, protected val options: RenderOptions, protected val mistake: Mistake?) :
    Renderer {
    override val id: String = mistake?.id ?: "third-$base"

    override val summary: String get() = "a stranger"

    /** Refuses what it cannot blend. */
    protected fun refuseTranslucent(frame: Frame, test: (Primitive) -> Boolean = { true }) {
        if (!frame.hasTranslucency) return
        val index = frame.primitives.indexOfFirst { it.isTranslucent && test(it) }
        require(index < 0) { "primitive $index is translucent, '$id' does not blend: use 'lists' or asOpaque()" }
    }

    override fun toString(): String = "$id($options)"
}

/** Whether the bounds meet the region. */
internal fun Primitive.meets(region: Region): Boolean =
    maxOf(rowStart, region.rowStart) < minOf(rowEnd, region.rowEnd) &&
        maxOf(columnStart, region.columnStart) < minOf(columnEnd, region.columnEnd)

/** The depth at a sample, by the form if there is one. */
internal fun Primitive.depthAt(x: Int, y: Int): Int {
    val form = depthForm ?: return depth(x, y)
    return (form.at(x, y) shr 32).toInt()
}

/** The key of the background: what is not below it is not seen. */
internal val Frame.backgroundKey: Long get() = raster.depthTest.key(raster.backgroundDepth, DepthTest.BACKGROUND)

/** First rows and indices of the primitives that meet the region, sorted. */
internal fun arrivals(frame: Frame): LongArray {
    val region = frame.region
    val keys = LongArray(frame.primitives.count { it.meets(region) })
    var used = 0
    for ((index, primitive) in frame.primitives.withIndex()) {
        if (!primitive.meets(region)) continue
        keys[used++] = maxOf(primitive.rowStart, region.rowStart).toLong() shl 32 or index.toLong()
    }
    keys.sort()
    return keys
}

/** One row on its way out. */
internal class OutRow(private val frame: Frame) {
    private val background = frame.raster.background.toArgb()
    val argb = IntArray(frame.width)
    val depth = IntArray(frame.width)
    val primitive = IntArray(frame.width)

    val bytes: Long get() = 12L * frame.width

    fun clear() {
        argb.fill(background)
        depth.fill(frame.raster.backgroundDepth)
        primitive.fill(DepthTest.BACKGROUND)
    }

    fun send(y: Int, sink: RowSink) = sink.row(y, argb, depth, primitive)
}
