package dev.lazyz.conformance.probes.memory

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.conformance.cases.Glass
import dev.lazyz.conformance.cases.Once
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.probes.dust
import dev.lazyz.conformance.probes.saw
import dev.lazyz.conformance.probes.threads.KindOfWork
import dev.lazyz.conformance.probes.threads.Stepping
import dev.lazyz.conformance.probes.ways
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Mesh

// Memory is measured on the heap, because a renderer's own counters may be wrong. A violation holds several times the
// allowed memory, and the allowed memory is several times the usual noise.

private val DISCARD = RowSink { _, _, _, _ -> }

/** A few samples, so that rows take little time, and even some bytes a row are noticed. */
private const val NARROW = 8

/** More rows than a renderer with bands of a thousand rows processes at a time in two threads. */
private const val FEW_ROWS = 4096
private const val MANY_ROWS = Raster.MAX_SIDE

/** Allowed growth in bytes for other reasons than arrays of rows: a byte for each additional row. */
private const val ROWS_ALLOWANCE = (MANY_ROWS - FEW_ROWS).toLong()

/** Fails if more rows take more memory, according to the renderer's counters or to the heap. */
internal fun constantMemory(renderer: Renderer) {
    for (kind in KindOfWork.entries) if (kind.isFor(renderer)) constantMemory(renderer, kind)
}

private fun constantMemory(renderer: Renderer, kind: KindOfWork) {
    // Several threads may process several blocks of rows at a time, but not more of them for a higher picture
    val configured = renderer.configured(kind.options(threads = 2))
    val few = configured.inTime(stripes(kind, NARROW, FEW_ROWS), DISCARD).peakBytes
    val many = configured.inTime(stripes(kind, NARROW, MANY_ROWS), DISCARD).peakBytes
    val what = "${kind.name.lowercase()} primitives: "
    if (many > few + few / 8 + Long.SIZE_BYTES) {
        fail(renderer, "${what}peakBytes is $few for $FEW_ROWS rows of $NARROW samples, $many for $MANY_ROWS")
    }
    fun held(rows: Int) = heldForRows(configured, rows) { stripes(kind, NARROW, rows, it) }
    Heap.requireAtMost(ROWS_ALLOWANCE, { held(MANY_ROWS) - held(FEW_ROWS) }) {
        fail(renderer, "$what$MANY_ROWS rows of $NARROW samples hold $it than $FEW_ROWS rows")
    }
}

/**
 * Fails if [renderer] holds much more than it reports, however it renders. Not reporting anything is another mistake.
 */
internal fun holdsWhatItReports(renderer: Renderer) {
    for (kind in KindOfWork.entries) {
        if (!kind.isFor(renderer)) continue
        val what = "${kind.name.lowercase()} primitives in $FEW_ROWS rows"
        holdsWhatItReports(renderer.configured(kind.options(threads = 2)), what, FEW_ROWS) { onQuery ->
            stripes(kind, WIDE, FEW_ROWS, onQuery)
        }
    }
    val saw = saw(TRIANGLES, SAW_ROWS)
    holdsWhatItReports(renderer, saw, "$TRIANGLES triangles of a mesh in the first of $SAW_ROWS rows")
    holdsWhatItReports(renderer, dust(0, TRIANGLES, DUST_ROWS), "$TRIANGLES triangles of a mesh in $DUST_ROWS rows")
    if (Capability.COHERENCE in renderer.capabilities) {
        val stepping = renderer.configured(RenderOptions(Coherence.INCREMENTAL, threads = 1))
        holdsWhatItReports(stepping, "$CHAINS primitives in a row, shaded by steps", rows = 1) { onQuery ->
            Frame(Raster(CHAINS, 1), List(CHAINS) { Stepping(Stripe(it..it, 0..0, 1000, onQuery)) })
        }
    }
    if (Capability.TRANSPARENCY !in renderer.capabilities) return
    holdsWhatItReports(renderer, "$DEEP translucent layers on $DEEP_SIDE x $DEEP_SIDE samples", DEEP_SIDE) { onQuery ->
        val layers = List(DEEP) { Stripe(0..<DEEP_SIDE, 0..<DEEP_SIDE, 1000 + it, onQuery) }
        Frame(Raster(DEEP_SIDE, DEEP_SIDE), layers.map { Glass(it, DEEP) })
    }
}

private fun holdsWhatItReports(renderer: Renderer, mesh: Frame, what: String) {
    // What makes objects of triangles for the frame makes them before
    mesh.primitives.first()
    holdsWhatItReports(renderer.configured(RenderOptions(threads = 1)), what, mesh.height) { mesh }
}

private fun holdsWhatItReports(renderer: Renderer, what: String, rows: Int, frame: (onQuery: (Int) -> Unit) -> Frame) {
    val reported = renderer.inTime(frame {}, DISCARD).peakBytes
    if (reported <= 0) return
    Heap.requireAtMost(MOST_TIMES * reported + REPORT_ALLOWANCE, { heldForRows(renderer, rows, frame) }) {
        fail(renderer, "$what: peakBytes is $reported, but they hold $it")
    }
}

private const val TRIANGLES = 20_000
private const val SAW_ROWS = 8
private const val DUST_ROWS = 128
private const val CHAINS = 1 shl 17
private const val DEEP = 256
private const val DEEP_SIDE = 64

private const val WIDE = 128

/** Objects, which are not counted, take about as much as the arrays, in the worst case. */
private const val MOST_TIMES = 2

/** Allowed bytes in addition: less than half of what the rows take if they are all held. */
private const val REPORT_ALLOWANCE = FEW_ROWS * WIDE * 4L

private fun stripes(kind: KindOfWork, width: Int, rows: Int, onQuery: (Int) -> Unit = {}): Frame {
    val stripes = listOf(Stripe(0..3, 0..<rows, 1000, onQuery), Stripe(2..7, 0..<rows, 2000, onQuery))
    return Frame(Raster(width, rows), stripes.map(kind::of))
}

/** Returns what is held when the last row is queried, and when the first and the last one are delivered. */
private fun heldForRows(renderer: Renderer, rows: Int, frame: (onQuery: (Int) -> Unit) -> Frame): HeapContent =
    Heap.most { measure ->
        val last = Once(rows - 1, measure)
        renderer.inTime(frame(last)) { y, _, _, _ -> if (y == 0 || y == rows - 1) measure() }
    }

private const val FEW_PRIMITIVES = 2048
private const val MANY_PRIMITIVES = 131_072

/** Allowed growth in bytes for other reasons than records of primitives. */
private const val PRIMITIVES_ALLOWANCE = MANY_PRIMITIVES - FEW_PRIMITIVES.toLong()

/** Fails if many more hidden primitives take more memory, whether they are hidden immediately or later. */
internal fun constantMemoryInPrimitives(renderer: Renderer) {
    for (order in Order.entries) {
        if (order == Order.GLASS_HIDDEN_LATER && Capability.TRANSPARENCY !in renderer.capabilities) continue
        for (way in renderer.ways()) constantMemoryInPrimitives(way, order)
    }
}

private fun constantMemoryInPrimitives(renderer: Renderer, order: Order) {
    val few = renderer.inTime(arriving(order, FEW_PRIMITIVES), DISCARD).peakBytes
    val many = renderer.inTime(arriving(order, MANY_PRIMITIVES), DISCARD).peakBytes
    if (many > few + PRIMITIVES_ALLOWANCE) {
        fail(renderer, "peakBytes is $few for $FEW_PRIMITIVES primitives $order, $many for $MANY_PRIMITIVES")
    }
    val growth = {
        heldForArrivals(renderer, order, MANY_PRIMITIVES) - heldForArrivals(renderer, order, FEW_PRIMITIVES)
    }
    Heap.requireAtMost(PRIMITIVES_ALLOWANCE, growth) {
        fail(renderer, "$MANY_PRIMITIVES primitives $order hold $it than $FEW_PRIMITIVES")
    }
}

/** The order of primitives of which one hides all others. */
private enum class Order(private val words: String) {
    HIDDEN_AT_ONCE("from near to far"),
    HIDDEN_LATER("from far to near"),
    GLASS_HIDDEN_LATER("from far to near, of which every second one is translucent"),
    ;

    override fun toString(): String = words
}

/**
 * Returns a frame that does not store primitives: each is created when it is requested, and is garbage unless the
 * renderer keeps it.
 */
private fun arriving(order: Order, count: Int, onQuery: (Int) -> Unit = {}): Frame {
    val primitives = object : AbstractList<Primitive>() {
        override val size: Int get() = count

        override fun get(index: Int): Primitive {
            val depth = 1000 + if (order == Order.HIDDEN_AT_ONCE) index else count - index
            val stripe = Stripe(0..7, 0..1, depth) { onQuery(index) }
            return if (order == Order.GLASS_HIDDEN_LATER && index % 2 == 0) Glass(stripe) else stripe
        }
    }
    return Frame(Raster(8, 2), primitives)
}

/** Returns what is held when the last primitive is queried, and when the first row is delivered. */
private fun heldForArrivals(renderer: Renderer, order: Order, count: Int): HeapContent = Heap.most { measure ->
    renderer.inTime(arriving(order, count, Once(count - 1, measure))) { y, _, _, _ -> if (y == 0) measure() }
}

private const val SIDE = 512

/** Number of primitives that share a row, so that adjacent samples always show different ones. */
private const val SHARERS = 32

/** Allowed bytes beyond a budget, in addition to a quarter of it: renderers count arrays, but not their headers. */
private const val BUDGET_ALLOWANCE = 256L * 1024

/** Bytes of the image: 12 a sample, see rule 7.6. */
private const val IMAGE_BYTES = 12L * SIDE * SIDE

/**
 * Fails if the heap holds more than a budget in addition to the image's memory: for one large primitive, in bytes a
 * sample, and for many small ones in comparison with it.
 */
internal fun budgetOnTheHeap(renderer: Renderer) {
    val plain = listOf(0..<SIDE to 0..<SIDE)
    val speckles = List(SIDE * SHARERS) { (it % SHARERS..<SIDE step SHARERS) to (it / SHARERS..it / SHARERS) }
    for (budget in listOf(0L, 1_000_000L)) {
        val configured = renderer.configured(RenderOptions(memoryBudget = budget, threads = 1))
        val most = IMAGE_BYTES + budget + budget / 4 + BUDGET_ALLOWANCE
        Heap.requireAtMost(most, { heldForColours(configured, plain) }) {
            fail(renderer, "the budget is $budget bytes, the image takes $IMAGE_BYTES, but one colour holds $it")
        }
        val held = { heldForColours(configured, speckles) - heldForColours(configured, plain) }
        Heap.requireAtMost(budget + budget / 4 + BUDGET_ALLOWANCE, held) {
            fail(renderer, "the budget is $budget bytes, but many colours hold $it than one colour")
        }
    }
    val combs = List(2) { (it..<COMB_WIDTH step 2) to (0..<SIDE) }
    val configured = renderer.configured(RenderOptions(memoryBudget = COMB_BUDGET, threads = 1))
    val held = { heldForColours(configured, combs, COMB_WIDTH) - heldForColours(configured, wide, COMB_WIDTH) }
    Heap.requireAtMost(COMB_BUDGET + BUDGET_ALLOWANCE, held) {
        fail(renderer, "the budget is $COMB_BUDGET bytes, but spans of one sample hold $it than long ones")
    }
    if (renderer is StreamingRenderer) budgetOfHeavyPrimitives(renderer)
}

private const val COMB_WIDTH = 2048
private const val COMB_BUDGET = 64L * 1024
private val wide = listOf(0..<COMB_WIDTH to 0..<SIDE)

/** Fails if primitives that say how much they hold are kept although the budget has no room for them. */
private fun budgetOfHeavyPrimitives(renderer: StreamingRenderer) {
    val configured = renderer.configured(RenderOptions(memoryBudget = HEAVY_BUDGET, threads = 1)) as? StreamingRenderer
        ?: fail(renderer, "it takes primitives one by one, but not if it has a memory budget")
    for (kind in HeavyKind.entries) {
        val held = {
            Heap.most { measure ->
                val drawing = configured.begin(Raster(HEAVY, 1))
                repeat(HEAVY) { drawing.add(kind.primitive(it)) }
                measure()
                drawing.finish { _, _, _, _ -> }
            }
        }
        Heap.requireAtMost(HEAVY_BUDGET + HEAVY_BUDGET / 4 + BUDGET_ALLOWANCE, held) {
            fail(renderer, "the budget is $HEAVY_BUDGET bytes, but $HEAVY $kind of $HEAVY_BYTES bytes hold $it")
        }
    }
}

/** What holds [HEAVY_BYTES] bytes, at least. */
private enum class HeavyKind(private val words: String) {
    PRIMITIVE("primitives") {
        override fun primitive(column: Int): Primitive = HeavyPrimitive(column, HEAVY_BYTES)
    },

    /** The only triangle of a mesh of many vertices, which all its triangles share. */
    MESH("meshes") {
        override fun primitive(column: Int): Primitive {
            val left = column.toFloat()
            val positions = FloatArray(3 * VERTICES)
            floatArrayOf(left, -1f, 0.5f, left + 2, -1f, 0.5f, left, 3f, 0.5f).copyInto(positions)
            val normals = FloatArray(3 * VERTICES) { if (it % 3 == 2) -1f else 0f }
            val mesh = Mesh(positions, intArrayOf(0, 1, 2), normals = normals)
            return Scene(listOf(mesh), viewpoint = Camera.screen()).primitives(Raster(HEAVY, 1)).first()
        }
    }, ;

    /** Returns a primitive that covers sample [column]. */
    abstract fun primitive(column: Int): Primitive

    override fun toString(): String = words
}

private const val HEAVY = 64
private const val HEAVY_BYTES = 1 shl 17
private const val HEAVY_BUDGET = 1L shl 20

/** Each takes 24 bytes at least: a position and a normal. */
private const val VERTICES = HEAVY_BYTES / 24 + 1

/** Covers one sample, and holds [bytes] bytes. */
private class HeavyPrimitive(override val columnStart: Int, private val bytes: Int) : Primitive {
    private val data = ByteArray(bytes)
    override val columnEnd: Int get() = columnStart + 1
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = 1
    override val heldBytes: Long get() = bytes + 64L

    override fun spans(y: Int, spans: Spans) {
        if (y == 0) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = 1000

    override fun shade(fragment: Fragment) = fragment.setColor(1f, data[0].toFloat(), 0f)
}

/** Returns what is held when the last primitive is queried, and when the first row is delivered. */
private fun heldForColours(
    renderer: Renderer,
    places: List<Pair<IntProgression, IntRange>>,
    width: Int = SIDE,
): HeapContent {
    var onQuery: (Int) -> Unit = {}
    val primitives = places.mapIndexed { index, (columns, rows) -> Stripe(columns, rows, 1000) { onQuery(index) } }
    return Heap.most { measure ->
        onQuery = Once(places.lastIndex, measure)
        renderer.inTime(Frame(Raster(width, SIDE), primitives)) { y, _, _, _ -> if (y == 0) measure() }
    }
}
