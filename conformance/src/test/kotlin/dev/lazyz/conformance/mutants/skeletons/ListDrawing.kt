package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.spi.Fragment

/** Row by row: every sample keeps the keys of all its fragments, and a selector chooses, or they are blended. */
internal open class ListDrawing(frame: Frame, selector: Selector?) :
    SweepDrawing(frame, Coherence.DIRECT),
    Cell {
    val selector = selector ?: Selector { if (frame.hasTranslucency) blend() else show(0) }
    private val lists = Array(width) { LongArray(2) }
    private val counts = IntArray(width)
    private var held = 0L

    /** The fragments of the current sample, sorted. */
    var sorted = LongArray(0)
    override var x = 0
    override var y = 0

    // What the current sample shows
    var shownArgb = 0
    var shownDepth = 0
    var shownIndex = 0

    override fun drawRow(y: Int) {
        counts.fill(0)
        held = 0
        super.drawRow(y)
        counters.peakSuspensions = maxOf(counters.peakSuspensions, held)
        counters.peakBytes = maxOf(counters.peakBytes, 36L * width + 16L * held)
    }

    override fun lower(keys: LongArray, at: Int, index: Int, count: Int) {
        for (i in 0 until count) {
            val key = key(spanDepths[i], index)
            if (isBeforeBackground(key)) keep(at + i, key)
        }
    }

    open fun isBeforeBackground(key: Long): Boolean = key < backgroundKey()

    open fun keep(column: Int, key: Long) {
        val list = lists[column]
        if (counts[column] == list.size) lists[column] = list.copyOf(2 * list.size)
        lists[column][counts[column]++] = key
        held++
    }

    override fun colorRow(y: Int) {
        this.y = y
        for (i in 0 until width) {
            x = region.columnStart + i
            beginSample()
            if (counts[i] > 0) {
                counters.depthPasses++
                sorted = sorted(lists[i].copyOf(counts[i]))
                choose()
            }
            argb[i] = shownArgb
            depths[i] = shownDepth
            indices[i] = shownIndex
        }
    }

    open fun choose() = selector.select(this)

    open fun beginSample() {
        shownArgb = backgroundArgb()
        shownDepth = raster.backgroundDepth
        shownIndex = DepthTest.BACKGROUND
    }

    open fun sorted(keys: LongArray): LongArray = keys.sortedArray()

    override val size: Int get() = sorted.size

    override val background: Rgba get() = raster.background

    override fun depth(i: Int): Int = test.depthOf(sorted[i])

    override fun primitive(i: Int): Int = test.indexOf(sorted[i])

    override fun isTranslucent(i: Int): Boolean = surface(i).isTranslucent

    fun surface(i: Int): Primitive = primitives[primitive(i)]

    override fun shade(i: Int): Fragment {
        counters.shadingCalls++
        counters.shadingStarts++
        fragment.moveTo(x, y)
        surface(i).shade(fragment)
        return fragment
    }

    override fun show(i: Int) {
        shownArgb = shade(i).toArgb()
        place(i)
    }

    override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
        shownArgb = Rgba(red, green, blue, alpha).toArgb()
        place(i)
    }

    open fun place(i: Int) {
        shownDepth = depth(i)
        shownIndex = primitive(i)
    }

    open fun blend() {
        val over = mixture()
        var i = 0
        while (i < size && isTranslucent(i) && over.isOpen) over.add(shade(i++))
        blendBackdrop(over, i)
        show(0, over.red, over.green, over.blue, over.alpha)
    }

    open fun mixture(): Mixture = Mixture()

    open fun blendBackdrop(over: Mixture, i: Int) {
        if (over.isOpen && i < size) {
            val last = shade(i)
            over.end(last.red, last.green, last.blue, last.alpha)
        } else {
            over.end(background.red, background.green, background.blue, background.alpha)
        }
    }
}

internal fun lists(drawing: (Frame, Selector?) -> ListDrawing): Renderer =
    Workbench("sample-lists", { listPromises(it) }) { frame, options -> drawing(frame, options.selector) }

internal fun listPromises(options: RenderOptions): Set<Capability> {
    val always = setOf(
        Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.TRANSPARENCY, Capability.SELECTION,
    )
    return if (options.selector == null) always + Capability.SHADES_ONLY_VISIBLE else always
}
