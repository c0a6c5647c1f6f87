package dev.lazyz.conformance.strangers2

import dev.lazyz.Capability
import dev.lazyz.Cell
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.RowSink
import dev.lazyz.Selector
import dev.lazyz.Spans

/** All fragments of each sample of a row, sorted; then blended, or given to a selector. */
internal class Layers(private val steps: LayerSteps, private val options: RenderOptions) : Renderer {
    override val id: String get() = "layers"
    override val summary: String get() = "a base of the second gallery"
    override val capabilities: Set<Capability>
        get() {
            val always = setOf(
                Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.TRANSPARENCY, Capability.SELECTION,
            )
            val isUsual = options.selector == null || options.selector === Selector.nearest()
            return if (isUsual) always + Capability.SHADES_ONLY_VISIBLE else always
        }

    override fun configured(options: RenderOptions): Renderer = Layers(steps, options.requireSupportedBy(this))

    override fun render(frame: Frame, sink: RowSink): Counters = LayerPass(frame, options, steps, sink).run()
}

/** The fragments of one column of a row. */
internal class Column {
    var keys = LongArray(4)
    var size = 0

    fun add(key: Long) {
        if (size == keys.size) keys = keys.copyOf(2 * size)
        keys[size++] = key
    }
}

/** One rendering of [Layers]. */
internal class LayerPass(val frame: Frame, val options: RenderOptions, val steps: LayerSteps, val sink: RowSink) {
    val region = frame.region
    val test = frame.raster.depthTest
    val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    val counters = Counters.Builder()
    val columns = Array(frame.width) { Column() }
    val fragment = Fragment()
    val selector: Selector? = steps.selector(frame, options)
    private val spans = Spans(region)

    fun run(): Counters {
        counters.primitives = frame.primitives.size.toLong()
        val cell = LayerCell(this)
        val argb = IntArray(frame.width)
        val depths = IntArray(frame.width)
        val indices = IntArray(frame.width)
        for (y in region.rowStart until region.rowEnd) {
            gather(y)
            argb.fill(frame.raster.background.toArgb())
            depths.fill(frame.raster.backgroundDepth)
            indices.fill(DepthTest.BACKGROUND)
            for (i in columns.indices) {
                val column = columns[i]
                steps.sort(this, column)
                if (column.size == 0) continue
                counters.depthPasses++
                cell.moveTo(region.columnStart + i, y, column)
                val chosen = selector
                if (chosen != null) chosen.select(cell) else steps.blend(cell)
                steps.choose(cell)
                if (!cell.isShown) continue
                argb[i] = cell.argb
                depths[i] = cell.shownDepth
                indices[i] = cell.shownPrimitive
            }
            sink.row(y, argb, depths, indices)
        }
        counters.peakBytes = columns.sumOf { 8L * it.keys.size + 40 } + 12L * frame.width
        return counters.build()
    }

    private fun gather(y: Int) {
        for (column in columns) column.size = 0
        val columnRange = region.columnStart until region.columnEnd
        for ((index, primitive) in frame.primitives.withIndex()) {
            if (!overlaps(primitive, columnRange, y..y)) continue
            spans.clear()
            primitive.spans(y, spans)
            for (i in 0 until spans.count) {
                counters.fragments += spans.end(i) - spans.start(i)
                counters.depthEvaluations += spans.end(i) - spans.start(i)
                for (x in spans.start(i) until spans.end(i)) {
                    val key = test.key(primitive.depth(x, y), index)
                    if (steps.passes(this, key)) steps.keep(this, columns[x - region.columnStart], key)
                }
            }
        }
    }
}

/** What a selector sees of a sample. */
internal class LayerCell(val pass: LayerPass) : Cell {
    private var column = Column()
    private var shown = -1
    var argb = 0
        private set
    override var x = 0
        private set
    override var y = 0
        private set
    val isShown: Boolean get() = shown >= 0
    val shownDepth: Int get() = depth(pass.steps.shownDepth(shown))
    val shownPrimitive: Int get() = primitive(shown)
    override val size: Int get() = column.size
    override val background: Rgba get() = pass.frame.raster.background

    fun moveTo(x: Int, y: Int, column: Column) {
        this.x = x
        this.y = y
        this.column = column
        shown = -1
    }

    private fun key(i: Int): Long {
        require(i in 0 until size) { "fragment must be in 0..<$size: $i" }
        return column.keys[i]
    }

    override fun depth(i: Int): Int = pass.test.depthOf(key(i))

    override fun primitive(i: Int): Int = pass.test.indexOf(key(i))

    override fun isTranslucent(i: Int): Boolean = pass.frame.primitives[primitive(i)].isTranslucent

    override fun shade(i: Int): Fragment {
        pass.counters.shadingCalls++
        pass.counters.shadingStarts++
        pass.fragment.moveTo(x, y)
        pass.frame.primitives[primitive(i)].shade(pass.fragment)
        return pass.fragment
    }

    override fun show(i: Int) {
        if (!pass.steps.mayShow(this)) return
        argb = shade(i).toArgb()
        shown = i
    }

    override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
        if (!pass.steps.mayShow(this)) return
        argb = Rgba(red, green, blue, alpha).toArgb()
        shown = pass.steps.shownInColor(i)
    }
}
