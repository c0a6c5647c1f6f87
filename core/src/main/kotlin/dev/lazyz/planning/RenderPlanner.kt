package dev.lazyz.planning

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.HeapLayout
import dev.lazyz.Image
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.StreamingRenderer
import dev.lazyz.filter.SampledFrame
import dev.lazyz.pipeline.LayeredRendering
import dev.lazyz.pipeline.SampleBuffer
import dev.lazyz.setup.triangleBatch
import dev.lazyz.strategies.FrameNumbers
import dev.lazyz.strategies.Renderers.StrategyEstimates
import dev.lazyz.strategies.StrategyMemory
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.tiled.TiledMemory
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.material.Material.Shading

/**
 * Plans renderings that stay within limited memory: chooses a renderer, its threads, its tiles, the bands of a streamed
 * frame, and a budget for renderers that can keep one. No choice changes the picture. Immutable and thread safe.
 *
 * ```
 * RenderPlan plan = new RenderPlanner(512L << 20).plan(frame, Renderers.getBuiltIn(), others);
 * if (plan.getFits()) frame.render(plan.getRenderer(), sink);
 * ```
 *
 * The needs of `TiledRenderer` are upper bounds; those of other renderers come from the model of
 * [dev.lazyz.strategies.Renderers.estimates], doubled, and vertices of triangles. Custom primitives, surfaces and
 * shaders that hold more memory than they report are not known.
 *
 * @param memory bytes of memory that may be used, in all
 * @param options what is requested. Threads and size of tiles are the most that a plan may use, and so is the limit for
 *   the bands of `TiledRenderer`, unless there would be more than 64 of them. Other renderers choose their bands. A
 *   budget is kept as it is
 * @throws IllegalArgumentException if [memory] is negative
 */
public class RenderPlanner @JvmOverloads constructor(
    private val memory: Long,
    private val options: RenderOptions = RenderOptions(),
) {
    init {
        require(memory >= 0) { "memory must not be negative: $memory" }
    }

    /**
     * Returns the first plan that fits: with the first of [renderers] that can render [frame] and all threads and the
     * largest tiles, then with smaller tiles and fewer threads, then with the next renderer. If none fits, returns the
     * one that needs the least.
     *
     * Cost: a few passes over the primitives of the frame; a streamed frame is not read.
     *
     * @param others what else is in memory during the rendering: the scene, and what receives the rows
     * @throws IllegalArgumentException if there are no [renderers], or none of them can render the frame
     * @throws InterruptedException if the calling thread is interrupted while a renderer is measured
     */
    @Throws(InterruptedException::class)
    @JvmOverloads
    public fun plan(
        frame: SampledFrame,
        renderers: List<Renderer>,
        others: List<RenderPlan.Item> = emptyList(),
    ): RenderPlan {
        require(renderers.isNotEmpty()) { "there are no renderers to choose from; pass some, as Renderers.builtIn" }
        val filter = frame.filterBytes
        val around = if (filter == 0L) others else others + RenderPlan.Item("samples to pixels", filter)
        var least: RenderPlan? = null
        val able = renderers.asSequence().filter { isAble(it, frame.frame) }
        for (plan in able.flatMap { plans(it, frame, around) }) {
            if (plan.fits) return plan
            if (least == null || plan.leastMemory < least.leastMemory) least = plan
        }
        return requireNotNull(least) { "none of the renderers can render $frame: ${renderers.joinToString { it.id }}" }
    }

    private fun isAble(renderer: Renderer, frame: Frame): Boolean =
        renderer.capabilities.containsAll(options.needs) &&
            (!frame.hasTranslucency || Capability.TRANSPARENCY in renderer.capabilities) &&
            (!frame.isStreamed || renderer is StreamingRenderer)

    private fun plans(renderer: Renderer, sampled: SampledFrame, others: List<RenderPlan.Item>): Sequence<RenderPlan> {
        val frame = sampled.frame
        return when {
            renderer !is TiledRenderer -> sequenceOf(other(renderer, frame, others))
            frame.isStreamed -> variants().map { streamed(renderer, frame, others, it) }
            else -> variants().map { tiled(renderer, sampled, others, it) }
        }
    }

    /** The options with all threads and ever smaller tiles, and then the same for one thread. */
    private fun variants(): Sequence<RenderOptions> {
        val tiles = generateSequence(options.tileSize) { it / 2 }.takeWhile { it >= LEAST_TILE }
        return listOf(options.threads, 1).distinct().asSequence()
            .flatMap { threads -> tiles.map { options.withThreads(threads).withTileSize(it) } }
    }

    private fun tiled(
        renderer: TiledRenderer,
        sampled: SampledFrame,
        others: List<RenderPlan.Item>,
        chosen: RenderOptions,
    ): RenderPlan {
        val tile = if (sampled.factor == 1) chosen.tileSize else TiledRenderer.pixelTileSize(chosen.tileSize)
        val need = TiledMemory(sampled.frame, tile, chosen.threads)
        val items = others + listOf(
            RenderPlan.Item("rows of tiles", HeapLayout.array(need.rowBytes, memory) * need.rowArrays),
            RenderPlan.Item("triangles by tile", need.bins),
            RenderPlan.Item("other primitives by tile", need.singles),
            RenderPlan.Item("translucent layers of tiles", need.layers),
            RenderPlan.Item("threads", need.workers),
        ).filter { it.bytes > 0 }
        return RenderPlan(renderer.configured(chosen), memory, items, 1, "${words(renderer, chosen)}, in one pass")
    }

    /** The rows of the picture are divided into as few bands as fit. */
    private fun streamed(
        renderer: TiledRenderer,
        frame: Frame,
        others: List<RenderPlan.Item>,
        chosen: RenderOptions,
    ): RenderPlan {
        val need = TiledMemory(Frame(frame.raster, emptyList(), frame.region), chosen.tileSize, chosen.threads)
        val parts = others + listOf(
            RenderPlan.Item("parts of the model", StrategyMemory.STREAM),
            RenderPlan.Item("rows of tiles", HeapLayout.array(need.rowBytes, memory) * need.rowArrays),
            RenderPlan.Item("threads", need.workers),
        )
        val sampleBytes =
            if (frame.hasTranslucency) LayeredRendering.BYTES_PER_SAMPLE else SampleBuffer.BYTES_PER_SAMPLE
        val rowBytes = frame.width * sampleBytes
        val free = minOf(RenderPlan.usable(memory) - parts.sumOf { it.bytes }, chosen.bandBytes ?: Long.MAX_VALUE)

        // Many passes over the model would take very long
        val leastRows = (frame.height - 1L) / MOST_PASSES + 1
        val mostRows = minOf(frame.height.toLong(), Image.MAX_SAMPLES / frame.width)
        val rows = (free / rowBytes).coerceIn(minOf(leastRows, mostRows), mostRows)
        val passes = ((frame.height - 1) / rows + 1).toInt()

        // Bands of equal height take the least memory for this number of passes
        val bandRows = (frame.height - 1L) / passes + 1
        val band = if (frame.hasTranslucency) {
            // How many fragments have to be kept turns out when they are drawn: in as many passes as that takes
            RenderPlan.Item("areas of translucent layers", maxOf(free, rowBytes * bandRows))
        } else {
            RenderPlan.Item("a band of $bandRows rows", rowBytes * bandRows)
        }
        val configured = renderer.configured(chosen.withBandBytes(band.bytes))
        val how = when {
            frame.hasTranslucency -> "$passes or more passes"
            passes == 1 -> "one pass"
            else -> "$passes passes"
        }
        val summary = "${words(renderer, chosen)}, in $how over the model"
        return RenderPlan(configured, memory, parts + band, passes, summary)
    }

    private fun other(renderer: Renderer, frame: Frame, others: List<RenderPlan.Item>): RenderPlan {
        val isStreamed = frame.isStreamed
        val numbers = if (isStreamed) pictureOnly(frame) else FrameNumbers.of(frame)
        val parts = others + when {
            isStreamed -> listOf(RenderPlan.Item("parts of the model", StrategyMemory.STREAM_OF_OBJECTS))
            else -> listOf(RenderPlan.Item("vertices of triangles", StrategyMemory.VERTEX * vertices(frame)))
        }.filter { it.bytes > 0 }
        val whole = StrategyMemory.reserved(renderer, numbers, options.memoryBudget)
        var chosen = options.withDefaultBandBytes()
        var need = whole
        val free = RenderPlan.usable(memory) - parts.sumOf { it.bytes }
        if (whole > free && options.memoryBudget == null && Capability.MEMORY_BUDGET in renderer.capabilities) {
            // With a budget of 0 only what cannot be avoided is left
            val fixed = StrategyMemory.reserved(renderer, numbers, 0)
            val budget = maxOf(0, free - fixed)
            chosen = chosen.withMemoryBudget(budget)
            need = fixed + budget
        }
        val kept = if (isStreamed && renderer is HierarchicalRenderer) StrategyMemory.SAMPLE * frame.region.size else 0
        val items = parts + RenderPlan.Item("strategy ${renderer.id}", need + kept)
        val words = words(renderer, chosen)
        return RenderPlan(renderer.configured(chosen.supportedBy(renderer)), memory, items, 1, "$words, in one pass")
    }

    /** The vertices of the objects of triangles. Triangles with a normal of their own do not share them. */
    private fun vertices(frame: Frame): Long = frame.content.batches.indices.sumOf { number ->
        val mesh = frame.content.triangleBatch(number).mesh
        val isFlat = mesh.normals == null || mesh.material.shading == Shading.FLAT
        if (isFlat) 3L * mesh.triangleCount else mesh.vertexCount.toLong()
    }

    /** Of a streamed frame only the picture is known, and its primitives are not kept. */
    private fun pictureOnly(frame: Frame) = FrameNumbers(frame.width, frame.height, 0, 0.0, 0.0)

    private fun words(renderer: Renderer, chosen: RenderOptions): String {
        val budget = chosen.memoryBudget?.let { ", a budget of ${RenderPlan.mebibytes(it)}" }.orEmpty()
        if (Capability.PARALLEL !in renderer.capabilities) return renderer.id + budget
        val threads = if (chosen.threads == 1) "1 thread" else "${chosen.threads} threads"
        return "${renderer.id}, $threads, tiles of ${chosen.tileSize} x ${chosen.tileSize}$budget"
    }

    /**
     * How to render a picture in limited memory, and what that needs. Made by [RenderPlanner]. Immutable.
     *
     * @property renderer the renderer, configured with threads, tiles, bands and budget of this plan
     * @property memory bytes of memory that may be used
     * @property items what each part needs
     * @property passes how many times the primitives are read: once, or, if they are streamed, once for each band of
     *   rows; more often if a band has too many translucent fragments
     * @property summary the strategy and its options, in words
     */
    public class RenderPlan internal constructor(
        public val renderer: Renderer,
        public val memory: Long,
        public val items: List<RenderPlan.Item>,
        public val passes: Int,
        public val summary: String,
    ) {
        /** What all [items] need together, in bytes. */
        public val bytes: Long = items.sumOf { it.bytes }

        /**
         * The smallest memory with which this plan fits, in bytes: that of the [items], and a reserve. The garbage
         * collector needs free memory to work, and divides memory into parts that cannot be filled completely.
         */
        public val leastMemory: Long = leastMemory(bytes)

        /** Whether the [memory] is enough. */
        public val fits: Boolean get() = leastMemory <= memory

        /** Returns readable text: a line for each item, the reserve, the sum, and the [summary]. */
        public fun explain(): String = buildString {
            append("memory: ${mebibytes(memory)} may be used\n")
            val all = items + RenderPlan.Item("reserve for the garbage collector", reserve(bytes)) +
                RenderPlan.Item("all", leastMemory)
            for (item in all) append("  %-52s %12s\n".format(null, item.what, mebibytes(item.bytes)))
            append("plan: $summary\n")
        }

        override fun toString(): String = "RenderPlan($summary, $leastMemory of $memory bytes)"

        /**
         * What a part of a rendering needs. Immutable.
         *
         * @property what description of the part
         * @property bytes most bytes of memory that it holds at a time
         * @throws IllegalArgumentException if [bytes] is negative
         */
        public class Item(public val what: String, public val bytes: Long) {
            init {
                require(bytes >= 0) { "bytes must not be negative: $bytes" }
            }

            override fun toString(): String = "Item($what, $bytes bytes)"
        }

        public companion object {
            /** Part of the need that is kept free in addition, one in so many. Measured, see docs/memory.md. */
            private const val RESERVE_PART = 3
            private const val LEAST_RESERVE = 4L shl 20

            /** Returns the memory with which objects of so many [bytes] fit, with a reserve. */
            @JvmStatic
            public fun leastMemory(bytes: Long): Long = bytes + reserve(bytes)

            private fun reserve(bytes: Long): Long = bytes / RESERVE_PART + LEAST_RESERVE

            /** Returns how many bytes items can need with [memory] bytes; negative if there is not even the reserve. */
            internal fun usable(memory: Long): Long = (memory - LEAST_RESERVE) / (RESERVE_PART + 1) * RESERVE_PART

            internal fun mebibytes(bytes: Long): String = StrategyEstimates.mebibytes(bytes.toDouble())
        }
    }

    public companion object {
        private const val LEAST_TILE = 8

        /** A plan with more passes over the model than this would take very long, and is not made. */
        private const val MOST_PASSES = 64

        /**
         * Returns the bytes that [renderer] keeps for each sample of a picture: the growth of its peak when the height
         * of an empty picture doubles. 0 if it keeps no picture, or fails on these pictures; the rendering then reports
         * the error. What it needs for primitives, and for rows and tiles in work, comes in addition. Cost: two
         * renderings of empty pictures of at most 512 x 1024 samples.
         *
         * @throws InterruptedException if the calling thread is interrupted, and the renderer checks for it
         */
        @JvmStatic
        @Throws(InterruptedException::class)
        public fun bytesPerSample(renderer: Renderer): Long = StrategyMemory.bytesPerSample(renderer)
    }
}
