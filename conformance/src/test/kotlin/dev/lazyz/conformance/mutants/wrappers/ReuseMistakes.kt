package dev.lazyz.conformance.mutants.wrappers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.conformance.cases.changed.Recovered
import dev.lazyz.conformance.cases.changed.renumbered
import dev.lazyz.conformance.mutants.BrokenRenderer
import dev.lazyz.conformance.mutants.Mistake
import dev.lazyz.conformance.mutants.emit
import dev.lazyz.spi.Spans
import dev.lazyz.strategies.hybrid.HybridRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer

/** Renderers that keep, reuse or count the wrong things. */
internal object ReuseMistakes {
    val mistakes: List<Mistake> = listOf(
        Mistake(::keepsHeavyPrimitives, "keeps all primitives that come one by one, in any budget"),
        Mistake(::placesOf16Bits, "a place within a tile has 16 bits"),
        Mistake(
            ::losesATriangleOfBlocks,
            "of many triangles one is lost where a region begins within a block of eight rows",
        ),
        Mistake(::sortsByNineBits, "primitives are sorted by nine bits of the band in which they begin"),
        Mistake(::tilesOf14Bits, "small triangles are sorted by 14 bits of the number of their tile"),
        Mistake(::fillsEmptyBandsOnce, "a band of rows without primitives is not filled again after another such band"),
        Mistake(
            ::rowsOfTheFirstTallFrame,
            "arrays are made for the first frame of several bands, and not made longer for a later one",
        ),
        Mistake(::drawsAsManyAsBefore, "what is kept of a mesh is found by its vertices, whatever its triangles are"),
        Mistake(::countsALastGroup, "counts the primitives of the last group"),
        Mistake(
            ::countsWhatIsKeptAgain,
            "draws the visible primitives again with each group, and counts their fragments each time",
        ),
        Mistake(::numbersALastGroup, "numbers the primitives of the last group from 0"),
        Mistake(::numbersEachPart, "numbers primitives of streamed parts from 0"),
        Mistake(::streamsAsOpaque, "draws streamed parts as if they were opaque"),
    )

    /** Arrays are made for the first frame of several bands, and not made longer for a later one. */
    fun rowsOfTheFirstTallFrame(): BrokenRenderer {
        var most = 0
        return BrokenRenderer("rows-of-the-first-tall-frame") { frame, sink ->
            if (frame.height > BAND && most == 0) most = frame.height
            val image = ZBufferRenderer().render(frame)
            val kept = if (frame.height > BAND) most * frame.width else image.argb.size
            emit(image.with { place, value, empty -> if (place < kept) value else empty }, sink)
        }
    }

    /** Draws at most as many triangles as the first frame of the size had that began with the same one. */
    fun drawsAsManyAsBefore(): BrokenRenderer {
        val known = HashMap<Any, Int>()
        return BrokenRenderer("draws-as-many-as-before") { frame, sink ->
            val first = frame.primitives.firstOrNull()
            val key = listOf(frame.region, first?.columnStart, first?.rowStart, first?.leastDepth)
            val kept = synchronized(known) { known.getOrPut(key) { frame.primitives.size } }
            ZBufferRenderer().render(frame.keeping { it < kept }, sink)
        }
    }

    /** Where nothing is drawn in a band of rows, nor in the one before, its arrays are handed out as they are. */
    fun fillsEmptyBandsOnce() = BrokenRenderer("fills-empty-bands-once") { frame, sink ->
        val rows = List(BAND) { List(3) { IntArray(frame.width) } }
        val used = frame.primitives.flatMap { it.rowStart / BAND..(it.rowEnd - 1) / BAND }.toSet()
        ZBufferRenderer().render(frame) { y, argb, depth, primitive ->
            val own = rows[y % BAND]
            val isFilled = y / BAND in used || y / BAND - 1 in used || y - frame.region.rowStart < BAND
            if (isFilled) listOf(argb, depth, primitive).zip(own) { from, to -> from.copyInto(to, 0, 0, frame.width) }
            sink.row(y, own[0], own[1], own[2])
        }
    }

    /** Sorts primitives by nine bits of their first band of eight rows, and draws each as soon as it is its turn. */
    fun sortsByNineBits() = BrokenRenderer("sorts-by-nine-bits") { frame, sink ->
        val turns = HashMap<Primitive, Int>()
        var turn = 0
        for (primitive in frame.primitives.sortedBy { it.rowStart / 8 and 0x1FF }) {
            turn = maxOf(turn, primitive.rowStart)
            turns[primitive] = turn
        }
        val late = frame.primitives.map { primitive ->
            object : Recovered(primitive) {
                override fun spans(y: Int, spans: Spans) {
                    if (y >= turns.getValue(primitive)) whole.spans(y, spans)
                }
            }
        }
        ZBufferRenderer().render(Frame(frame.raster, late, frame.region), sink)
    }

    /** Takes primitives one by one and keeps all of them, whatever the budget. */
    fun keepsHeavyPrimitives(): BrokenRenderer = BudgetStream("keeps-heavy-primitives") { _, drawing ->
        val kept = ArrayList<Primitive>()
        object : Rendering {
            override fun add(primitive: Primitive) {
                drawing.add(primitive)
                kept.add(primitive)
            }

            override fun finish(sink: RowSink): Counters = drawing.finish(sink).also { kept.clear() }
        }
    }

    /** Keeps to a budget, but draws primitives that come one by one into what [make] returns. */
    private class BudgetStream(
        id: String,
        private val options: RenderOptions = RenderOptions(),
        private val make: (RenderOptions, Rendering) -> Rendering,
    ) : BrokenRenderer(id, setOf(Capability.MEMORY_BUDGET), how = HybridRenderer(options)::render),
        StreamingRenderer {
        override fun configured(options: RenderOptions): Renderer =
            BudgetStream(id, options.requireSupportedBy(this), make)

        override fun begin(raster: Raster, region: Region): Rendering =
            make(options, HybridRenderer(options).begin(raster, region))
    }

    /** Counts the primitives of the last group. */
    fun countsALastGroup() = StreamMistakes.stream("stream-counts-a-last-group") { begin ->
        val drawing = begin()
        object : Rendering by drawing {
            override fun finish(sink: RowSink): Counters =
                drawing.finish(sink).toBuilder().apply { primitives %= GROUP }.build()
        }
    }

    /** Numbers primitives of a later group by their place in it. */
    fun numbersALastGroup() = StreamMistakes.stream("stream-numbers-a-last-group") { begin ->
        val drawing = begin()
        object : Rendering by drawing {
            override fun finish(sink: RowSink): Counters = drawing.finish { y, argb, depth, primitive ->
                sink.row(y, argb, depth, IntArray(primitive.size) { primitive[it] % GROUP })
            }
        }
    }

    /** Draws the visible primitives of earlier groups again with each group, and counts their fragments each time. */
    fun countsWhatIsKeptAgain() = StreamMistakes.stream("stream-counts-what-is-kept-again") { begin ->
        val drawing = begin()
        object : Rendering by drawing {
            override fun finish(sink: RowSink): Counters {
                var visible = 0L
                val counters = drawing.finish { y, argb, depth, primitive ->
                    visible += primitive.count { it >= 0 }
                    sink.row(y, argb, depth, primitive)
                }
                return counters.toBuilder().apply { fragments += primitives / GROUP * visible }.build()
            }
        }
    }

    /** Where small triangles are sorted, tiles of 8 x 8 samples have numbers of 14 bits. */
    fun tilesOf14Bits() = BrokenRenderer("tiles-of-14-bits") { frame, sink ->
        val left = frame.primitives.map { primitive ->
            val isLost = primitive.columnEnd - primitive.columnStart <= SMALL && primitive.columnStart / 8 >= 1 shl 14
            object : Recovered(primitive) {
                override fun spans(y: Int, spans: Spans) {
                    if (!isLost) whole.spans(y, spans)
                }
            }
        }
        ZBufferRenderer().render(Frame(frame.raster, left, frame.region), sink)
    }

    /** A place within a tile has 16 bits, and those of tiles of 512 x 512 samples need more. */
    fun placesOf16Bits(): BrokenRenderer = placesOf16Bits(RenderOptions())

    private fun placesOf16Bits(options: RenderOptions): BrokenRenderer = BrokenRenderer(
        "places-of-16-bits",
        options = { placesOf16Bits(it) },
    ) { frame, sink ->
        val side = options.tileSize
        val image = ZBufferRenderer().render(frame)
        emit(
            image.with { place, value, empty ->
                val inTile = place / frame.width % side * side + place % frame.width % side
                if (inTile < 1 shl 16) value else empty
            },
            sink,
        )
    }

    /** Loses a triangle of many where a region begins within a block of eight rows. */
    fun losesATriangleOfBlocks() = BrokenRenderer("loses-a-triangle-of-blocks") { frame, sink ->
        val isLost = frame.region.rowStart % 8 != 0 && frame.primitives.size > MANY_TRIANGLES
        val left = if (isLost) frame.primitives.drop(1) else frame.primitives
        ZBufferRenderer().render(Frame(frame.raster, left, frame.region), sink)
    }

    /** Streamed frames are drawn part by part, and the primitives of each part are numbered from 0. */
    fun numbersEachPart() = BrokenRenderer("numbers-each-part") { frame, sink ->
        val image = ZBufferRenderer().render(frame)
        emit(if (frame.isStreamed) image.renumbered { it % PART } else image, sink)
    }

    /** The parts of a streamed frame are drawn as if all of them were opaque. */
    fun streamsAsOpaque() = BrokenRenderer("streams-as-opaque", setOf(Capability.TRANSPARENCY)) { frame, sink ->
        TiledRenderer().render(if (frame.isStreamed) frame.asOpaque() else frame, sink)
    }

    /** Returns the image with other samples; [change] gets a sample's place, its value, and that of the background. */
    private fun Image.with(change: (place: Int, value: Int, empty: Int) -> Int) = Image(
        region,
        IntArray(argb.size) { change(it, argb[it], WHITE) },
        IntArray(argb.size) { change(it, depth[it], Int.MAX_VALUE) },
        IntArray(argb.size) { change(it, primitive[it], DepthTest.BACKGROUND) },
        counters,
    )

    private const val WHITE = -1
    private const val BAND = 64
    private const val SMALL = 4
    private const val GROUP = 1 shl 14
    private const val MANY_TRIANGLES = 80
    private const val PART = 2
}
