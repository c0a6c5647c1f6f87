package dev.lazyz.conformance.strangers2

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.SpanCursor
import dev.lazyz.Spans

/** One row at a time: a list of active primitives, a minimum for each column, colours at the end. */
internal class RowByRow(private val steps: RowSteps, private val options: RenderOptions) : Renderer {
    override val id: String get() = "row-by-row"
    override val summary: String get() = "a base of the second gallery"
    override val capabilities: Set<Capability> get() = steps.promises

    override fun configured(options: RenderOptions): Renderer = RowByRow(steps, options.requireSupportedBy(this))

    override fun render(frame: Frame, sink: RowSink): Counters {
        steps.check(frame)
        steps.begin(frame)
        val counters = RowPass(frame, options, steps, sink).run()
        steps.end(frame)
        return counters
    }
}

/** A primitive between its first row and its last. */
internal class Active(val index: Int, val primitive: Primitive, val cursor: SpanCursor)

/** One rendering of [RowByRow]. */
internal class RowPass(val frame: Frame, val options: RenderOptions, val steps: RowSteps, val sink: RowSink) {
    val region = frame.region
    val width = frame.width
    val test = frame.raster.depthTest
    val background = frame.raster.background.toArgb()
    val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    val keys = steps.keys(this)
    var argb = IntArray(width)
    var depths = IntArray(width)
    var indices = IntArray(width)
    val counters = Counters.Builder()
    val spans = Spans(region)
    val active = ArrayList<Active>()
    val colors = RowColors(this)
    var extraBytes = 0L

    fun run(): Counters {
        counters.primitives = frame.primitives.size.toLong()
        val arrivals = steps.arrivals(this)
        var next = 0
        var most = 0
        for (y in region.rowStart until region.rowEnd) {
            if (!steps.goesOn(this, y)) break
            while (next < arrivals.size && (arrivals[next] ushr 32).toInt() == y) {
                steps.admit(this, steps.index(arrivals[next++]), y)
            }
            most = maxOf(most, active.size)
            steps.clear(this)
            for (one in active) steps.draw(this, one, y)
            steps.resolve(this, y)
            active.removeAll { it.primitive.rowEnd <= y + 1 }
            steps.handOut(this, y)
        }
        counters.peakBytes = 20L * width + 8L * arrivals.size + 100L * most + extraBytes
        steps.finish(this)
        return counters.build()
    }
}

/** What [RowByRow] does, step by step; mistakes replace single steps. */
internal open class RowSteps : ColorSteps() {
    open val promises: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.STREAMS_ROWS, Capability.COHERENCE,
        )

    open fun check(frame: Frame) = refuseTranslucent(frame, "row-by-row")

    open fun begin(frame: Frame) = Unit

    open fun end(frame: Frame) = Unit

    open fun goesOn(pass: RowPass, y: Int): Boolean = true

    open fun keys(pass: RowPass): LongArray = LongArray(pass.width)

    open fun reaches(pass: RowPass, primitive: Primitive): Boolean = overlaps(
        primitive,
        pass.region.columnStart until pass.region.columnEnd,
        pass.region.rowStart until pass.region.rowEnd,
    )

    /** First row and index of the primitives, sorted. */
    open fun arrivals(pass: RowPass): LongArray {
        val all = LongArray(pass.frame.primitives.count { reaches(pass, it) })
        var count = 0
        for ((index, primitive) in pass.frame.primitives.withIndex()) {
            if (!reaches(pass, primitive)) continue
            all[count++] = maxOf(primitive.rowStart, pass.region.rowStart).toLong() shl 32 or index.toLong()
        }
        all.sort()
        return all
    }

    open fun index(arrival: Long): Int = arrival.toInt()

    open fun admit(pass: RowPass, index: Int, y: Int) {
        val primitive = pass.frame.primitives[index]
        pass.active.add(Active(index, primitive, cursor(primitive, y)))
    }

    open fun cursor(primitive: Primitive, y: Int): SpanCursor = primitive.cursor(y)

    open fun clear(pass: RowPass) = pass.keys.fill(pass.backgroundKey)

    open fun draw(pass: RowPass, one: Active, y: Int) {
        one.cursor.next(pass.spans)
        for (i in 0 until pass.spans.count) span(pass, one, y, pass.spans.start(i), pass.spans.end(i))
    }

    open fun span(pass: RowPass, one: Active, y: Int, start: Int, end: Int) {
        pass.counters.fragments += end - start
        pass.counters.depthEvaluations += end - start
        val form = one.primitive.depthForm
        for (x in start until end) {
            val depth = if (form != null) (form.at(x, y) shr 32).toInt() else one.primitive.depth(x, y)
            merge(pass, one.index, x, depth)
        }
    }

    fun merge(pass: RowPass, index: Int, x: Int, depth: Int) {
        val key = pass.test.key(depth, index)
        val at = x - pass.region.columnStart
        if (key >= pass.keys[at]) return
        pass.keys[at] = key
        pass.counters.depthPasses++
    }

    open fun resolve(pass: RowPass, y: Int) {
        for (i in 0 until pass.width) {
            pass.depths[i] = pass.test.depthOf(pass.keys[i])
            pass.indices[i] = pass.test.indexOf(pass.keys[i])
        }
        pass.colors.row(y)
    }

    open fun handOut(pass: RowPass, y: Int) = pass.sink.row(y, pass.argb, pass.depths, pass.indices)

    open fun finish(pass: RowPass) = Unit
}
