package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.Selector.Cell
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Misread
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.drawing
import dev.lazyz.conformance.mutants.painting
import dev.lazyz.conformance.mutants.primitives
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that are correct as long as nothing is large. */
internal object SizeMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::columnsIn16Bits, "columns are kept in 16 bits where they are shaded"),
        Mistake(::rowsIn15Bits, "rows are kept in a short where they are shaded"),
        Mistake(::lastColumnOfATileOf64, "the last column of each tile of 64 x 64 samples is lost"),
        Mistake(::lastRowOfABandOf128, "the last row of each band of 128 rows is lost"),
        Mistake(::noTilesBeyondTheFirstOf256, "tiles of 256 right of or below the first are lost"),
        Mistake(::elevenBitsOfATile, "what is visible in a tile of 64 x 64 samples has numbers of eleven bits"),
        Mistake(
            ::sortsByRecursion,
            "the fragments of a sample are sorted by calls as deep as there are fragments, if they come in order",
        ),
        Mistake(::coversItsTile, "a wide primitive covers its last tile, although it ends before the last column"),
        Mistake(
            ::stopsAtTheFirstHidden,
            "primitives after the first hidden one are lost, in a rough order from near to far",
        ),
        Mistake(
            ::forgetsWhatBeganBefore,
            "a row is processed in pieces of a million fragments, and a piece lacks spans of the one before",
        ),
        Mistake(::sixteenSpans, "a primitive has at most 16 spans in a row"),
        Mistake(::spansIn14Bits, "a primitive has at most 16,384 spans in a row"),
        Mistake(::blendsAMillionFragments, "a picture has at most a million translucent fragments"),
        Mistake(::keepsEightLayers, "an opaque fragment that comes late leaves at most eight layers"),
        Mistake(::thirtyTwoLayers, "a sample takes at most 32 fragments"),
        Mistake(::layersInAByte, "a sample takes at most 255 fragments"),
        Mistake(::blends32Layers, "at most 32 layers are blended"),
        Mistake(::indexThroughAFloat, "indices go through a float"),
        Mistake(::indexIn24Bits, "indices have 24 bits"),
    )

    fun columnsIn16Bits() = primitives("columns-in-16-bits") { ShadedAt(it) { x, y -> (x and 0xFFFF) to y } }

    fun rowsIn15Bits() = primitives("rows-in-15-bits") { ShadedAt(it) { x, y -> x to (y and 0x7FFF) } }

    fun lastColumnOfATileOf64() = primitives("last-column-of-a-tile-of-64") { Sifted(it) { x, _ -> x % 64 < 63 } }

    fun lastRowOfABandOf128() = primitives("last-row-of-a-band-of-128") { Sifted(it) { _, y -> y % 128 < 127 } }

    fun noTilesBeyondTheFirstOf256() = primitives("no-tiles-beyond-256") { Sifted(it) { x, y -> x < 256 && y < 256 } }

    /** A tile of 64 x 64 samples has numbers of eleven bits for what is visible in it. */
    fun elevenBitsOfATile() = painting("eleven-bits-of-a-tile") { image, frame ->
        val numbers = HashMap<Pair<Int, Int>, HashSet<Int>>()
        val isLost = BooleanArray(image.argb.size) { i ->
            val tile = i % image.width / 64 to i / image.width / 64
            val seen = numbers.getOrPut(tile) { HashSet() }
            val isNew = image.primitive[i] !in seen
            if (isNew && seen.size < 1 shl 11) seen.add(image.primitive[i])
            image.primitive[i] !in seen
        }
        fun IntArray.without(value: Int) = IntArray(size) { if (isLost[it]) value else this[it] }
        val raster = frame.raster
        Image(
            image.region,
            image.argb.without(raster.background.toArgb()),
            image.depth.without(raster.backgroundDepth),
            image.primitive.without(DepthTest.BACKGROUND),
            image.counters,
        )
    }

    /** Sorts the fragments of a sample by calls as deep as there are fragments, if they come in order. */
    fun sortsByRecursion() =
        BrokenRenderer("sorts-by-recursion", setOf(Capability.TRANSPARENCY)) { frame, sink ->
            val spans = Spans()
            val x = frame.region.columnStart
            val y = frame.region.rowStart
            val depths = frame.primitives.asSequence().filter { primitive ->
                spans.clear()
                if (y in primitive.rowStart until primitive.rowEnd) primitive.spans(y, spans)
                (0 until spans.count).any { x in spans.start(it)..<spans.end(it) }
            }.map { it.depth(x, y) }.toList().toIntArray()
            sort(depths, 0, depths.size)
            ListsRenderer().render(frame, sink)
        }

    /** Quicksort with the first element as the pivot, from [start] until [end]. */
    private fun sort(values: IntArray, start: Int, end: Int) {
        if (end - start < 2) return
        val pivot = values[start]
        var smaller = start
        for (i in start + 1 until end) {
            if (values[i] >= pivot) continue
            smaller++
            values[smaller] = values[i].also { values[i] = values[smaller] }
        }
        values[start] = values[smaller].also { values[smaller] = values[start] }
        sort(values, start, smaller)
        sort(values, smaller + 1, end)
    }

    /** A row is processed in two pieces if it has a million fragments; the second lacks what began in the first. */
    fun forgetsWhatBeganBefore() = drawing("forgets-what-began-before") { frame ->
        val second = frame.region.columnStart + 1_000_000 / maxOf(frame.primitives.size, 1)
        val kept = frame.primitives.map { Sifted(it) { x, _ -> x < second || it.columnStart >= second } }
        Frame(frame.raster, kept, frame.region)
    }

    /** Takes a tile of 8 columns as covered by a wide primitive that ends just before its last column. */
    fun coversItsTile() = painting("covers-its-tile") { image, frame ->
        val first = image.region.columnStart
        val primitive = image.primitive.copyOf()
        val argb = image.argb.copyOf()
        val depth = image.depth.copyOf()
        for (i in argb.indices) {
            val x = first + i % image.width
            if (x % 8 != 7 || i % image.width == 0) continue
            val front = frame.primitives.getOrNull(image.primitive[i - 1]) ?: continue
            if (front.columnEnd != x || front.columnEnd - front.columnStart < WIDE) continue
            argb[i] = frame.raster.background.toArgb()
            depth[i] = frame.raster.backgroundDepth
            primitive[i] = DepthTest.BACKGROUND
        }
        Image(image.region, argb, depth, primitive, image.counters)
    }

    private const val WIDE = 31

    /** Stops at the first hidden primitive, although the order from near to far is a rough one. */
    fun stopsAtTheFirstHidden() = drawing("stops-at-the-first-hidden") { frame ->
        val order = frame.primitives.indices.sortedBy { frame.primitives[it].leastDepth ushr 23 }
        var farthest = Int.MAX_VALUE
        val drawn = order.takeWhile {
            val primitive = frame.primitives[it]
            val isVisible = primitive.leastDepth < farthest
            if (isVisible && primitive.coversAll(frame)) farthest = minOf(farthest, primitive.greatestDepth)
            isVisible || frame.raster.depthTest != DepthTest.LESS
        }.toSet()
        val kept = frame.primitives.mapIndexed { i, it -> if (i in drawn) it else Sifted(it) { _, _ -> false } }
        Frame(frame.raster, kept, frame.region)
    }

    private fun Primitive.coversAll(frame: Frame): Boolean =
        (frame.region.rowStart until frame.region.rowEnd).all { y ->
            val spans = frame.region.spans().also { spans(y, it) }
            spans.count == 1 && spans.end(0) - spans.start(0) == frame.region.width
        }

    fun sixteenSpans() = spans("sixteen-spans-in-a-row", 16)

    fun spansIn14Bits() = spans("spans-in-14-bits", 1 shl 14)

    /** Uses at most [most] spans in a row of a primitive. */
    private fun spans(id: String, most: Int) = primitives(id) {
        object : Misread(it) {
            override fun misread(from: Spans, to: Spans) {
                for (i in 0 until minOf(from.count, most)) to.add(from.start(i), from.end(i))
            }
        }
    }

    fun thirtyTwoLayers() = layers("thirty-two-layers", 32)

    fun layersInAByte() = layers("layers-in-a-byte", 255)

    fun blends32Layers() = blending("blends-32-layers") { { cell -> First(cell, 32) } }

    /** A picture has room for so many fragments, and further ones are lost. */
    fun blendsAMillionFragments() = blending("blends-a-million-fragments") {
        var room = 1_000_000
        { cell -> First(cell, cell.size.coerceIn(1, maxOf(room, 1))).also { room -= cell.size } }
    }

    /** When an opaque fragment arrives, at most eight of the layers before it are looked at. */
    fun keepsEightLayers() = blending("keeps-eight-layers") {
        { cell ->
            val opaque = (0 until cell.size).firstOrNull { !cell.isTranslucent(it) } ?: 0
            val isLate = (0 until opaque).count { cell.primitive(it) < cell.primitive(opaque) } > 8
            if (isLate) First(cell, 8) else cell
        }
    }

    /** Blends what is left of the cells of a frame. */
    private fun blending(id: String, left: () -> (Cell) -> Cell) =
        BrokenRenderer(id, setOf(Capability.TRANSPARENCY)) { frame, sink ->
            val change = left()
            val selector = Selector { cell -> Selector.blend().select(change(cell)) }
            val chosen = if (frame.hasTranslucency) selector else Selector.nearest()
            ListsRenderer(RenderOptions(selector = chosen)).render(frame, sink)
        }

    fun indexThroughAFloat() = painting("index-through-a-float") { image, _ ->
        image.renumbered { it.toFloat().toInt() }
    }

    fun indexIn24Bits() = painting("index-in-24-bits") { image, _ -> image.renumbered { it and 0xFFFFFF } }

    private class First(private val cell: Cell, private val most: Int) : Cell by cell {
        override val size: Int get() = minOf(cell.size, most)
    }

    /** Uses at most [most] fragments at a sample. */
    private fun layers(id: String, most: Int) = BrokenRenderer(id) { frame, sink ->
        val counts = HashMap<Pair<Int, Int>, Int>()
        val kept = frame.primitives.map { primitive ->
            val samples = HashSet<Pair<Int, Int>>()
            for (y in frame.region.rowStart until frame.region.rowEnd) {
                val spans = frame.region.spans().also { primitive.spans(y, it) }
                for (i in 0 until spans.count) {
                    for (x in spans.start(i) until spans.end(i)) {
                        if (counts.merge(x to y, 1, Int::plus)!! <= most) samples.add(x to y)
                    }
                }
            }
            Sifted(primitive) { x, y -> (x to y) in samples }
        }
        ZBufferRenderer().render(Frame(frame.raster, kept, frame.region), sink)
    }

    /** Covers the samples of [whole] for which [isKept] returns true. */
    private class Sifted(whole: Primitive, private val isKept: (x: Int, y: Int) -> Boolean) : Recovered(whole) {
        override fun spans(y: Int, spans: Spans) {
            val all = Spans().also { whole.spans(y, it) }
            for (i in 0 until all.count) {
                for (x in all.start(i) until all.end(i)) if (isKept(x, y)) spans.add(x, x + 1)
            }
        }
    }

    private class ShadedAt(private val whole: Primitive, private val place: (x: Int, y: Int) -> Pair<Int, Int>) :
        Primitive by whole {
        override fun shade(fragment: Fragment) {
            val (x, y) = fragment.x to fragment.y
            val (column, row) = place(x, y)
            fragment.moveTo(column, row)
            whole.shade(fragment)
            fragment.moveTo(x, y)
        }
    }
}
