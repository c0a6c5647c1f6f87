package dev.lazyz.strategies.tiled

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.LibraryThreads
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.RowSink
import dev.lazyz.StreamingRenderer
import dev.lazyz.StreamingRenderer.Rendering
import dev.lazyz.Workers
import dev.lazyz.pipeline.GroupedPrimitives
import dev.lazyz.pipeline.GuardedDrawing
import dev.lazyz.pipeline.LayeredRendering
import dev.lazyz.pipeline.StreamedRendering
import dev.lazyz.pipeline.bandBytes
import dev.lazyz.strategies.tiled.binning.ArrayPool
import dev.lazyz.strategies.tiled.raster.TileGrid
import java.io.IOException
import java.lang.ref.SoftReference
import java.util.concurrent.Executor
import java.util.concurrent.atomic.AtomicReference

/**
 * The default for production: divides the picture into tiles, and renders them on all cores, each tile by one thread
 * within its cache.
 *
 * Primitives are sorted into bins, one for each tile. A tile runs a small depth buffer of 64-bit visibility keys, in
 * which the nearest fragment is the minimum. Triangles of meshes are drawn from near to far, in blocks of samples; a
 * triangle is rejected where it is behind everything visible in a tile or a block. After all primitives are drawn, each
 * visible sample is shaded once, in batches. Each thread takes tiles of its own columns first, and then those of other
 * threads. The result in each tile is a minimum of a total order and does not depend on the order of evaluation. The
 * bits and the counters are therefore the same for any number of threads, except [Counters.peakBytes], which grows
 * with it and then depends on which thread took which tiles. Translucent fragments in front of opaque ones are
 * recorded, sorted by sample and blended in exact order of depth.
 *
 * Use it unless there is a reason against it. Use `ZBufferRenderer` where primitives arrive one by one and are too many
 * to keep, `LazyRenderer` or `FlowRenderer` to stop after some rows or to compute only a few samples, and
 * `ScanlineRenderer` where depth is expensive.
 *
 * It is by far the fastest if the JVM was started with `--add-modules jdk.incubator.vector` and opaque surfaces are
 * [dev.lazyz.world.surface.Mesh]es in a [dev.lazyz.world.Scene]: no objects are created for their triangles. Custom
 * shaders are faster as [dev.lazyz.spi.BatchShader]s.
 *
 * Memory:
 *
 * - one row of tiles (with several threads two or more), at 12 bytes a sample;
 * - for at most 4096 tiles at a time, 20 bytes for each pair of a mesh's triangle and a tile, and 24 bytes for each
 *   fragment of a triangle of less than ten samples and for each triangle that reaches 8 tiles;
 * - about 30 bytes for each other primitive in a row of tiles, and the spans of primitives that several tiles share;
 * - for each thread, the keys of a tile at 8 bytes a sample, and 20 bytes for each translucent fragment of a tile;
 * - 16 bytes for each primitive of the frame that is not from a mesh.
 *
 * A streamed frame (see [Frame.isStreamed]) is rendered part by part into a picture in memory, at 12 bytes a sample. If
 * that is more than [RenderOptions.bandBytes], by default a third of the heap, into one band of rows after the other,
 * with a pass over the parts for each. Each part is shaded where it is nearest within itself, so later parts can hide
 * some of what was shaded. If it has translucent primitives, one thread draws it into areas that each take at most as
 * much, at 28 bytes for each sample and each translucent fragment that was not yet hidden when it was drawn. A single
 * sample may take a third of the heap.
 *
 * Otherwise memory does not grow with the number of rows. For very wide pictures use smaller tiles. Rows and bins are
 * kept for the next rendering through soft references: rendering a frame similar to the last one allocates no large
 * arrays, and the garbage collector can reclaim them if memory is short. So reuse the renderer.
 *
 * Time: proportional to the number of triangles, of samples that are not rejected and of visible samples, divided by
 * the number of threads.
 *
 * The sink is called on the calling thread, which also renders tiles. Up to [RenderOptions.threads] - 1 other threads
 * help, from [RenderOptions.executor] or from a pool of the library, and have always stopped when the rendering ends.
 * An exception that a primitive, a shader or the sink throws on any
 * thread is thrown unchanged to the caller; if there are several, one is thrown, and the others are suppressed.
 * Primitives and shaders are called from all threads concurrently. Thread safe; only unused arrays are kept between
 * calls.
 *
 * Source: Henry Fuchs et al., "Pixel-Planes 5: A Heterogeneous Multiprocessor Graphics System Using Processor-Enhanced
 * Memories", SIGGRAPH 1989, for bins of regions that processors take one after the other; Steven Molnar, Michael Cox,
 * David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering", IEEE Computer Graphics and
 * Applications 14 (1994), which calls this method "sort-middle"; Larry Seiler et al., "Larrabee: A Many-Core x86
 * Architecture for Visual Computing", SIGGRAPH 2008, for the method in software; Juan Pineda, "A Parallel Algorithm for
 * Polygon Rasterization", SIGGRAPH 1988, for edge functions and blocks. In these, a bin keeps the order of submission
 * because later results depend on it; here the order is part of the key.
 */
public class TiledRenderer internal constructor(
    private val coherence: Coherence,
    private val threads: Int,
    private val tileSize: Int,
    private val kernels: () -> Kernels = Kernels::best,
    private val executor: Executor = LibraryThreads,
    private val bandBytes: Long? = null,
) : StreamingRenderer {
    /** The arrays of the last rendering, as long as there is enough memory. */
    private val kept = AtomicReference<SoftReference<ArrayPool>>()

    /**
     * Creates a renderer that uses [RenderOptions.coherence], [RenderOptions.threads], [RenderOptions.executor],
     * [RenderOptions.tileSize] and [RenderOptions.bandBytes].
     */
    @JvmOverloads
    public constructor(options: RenderOptions = RenderOptions()) :
        this(
            options.coherence, options.threads, options.tileSize, executor = options.workers.executor,
            bandBytes = options.bandBytes,
        ) {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "tiled"

    override val summary: String get() = "tiles on all cores, visibility keys merged by minimum, colours at the end"

    /** The innermost loops: `vector` if the JVM has the module `jdk.incubator.vector`, otherwise `scalar`. */
    public val kernel: String get() = kernels().name.lowercase()

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.PARALLEL,
            Capability.TRANSPARENCY,
            Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): TiledRenderer = TiledRenderer(options)

    /**
     * Renders [frame] and passes every row to [sink], on this thread.
     *
     * @throws IllegalArgumentException if the frame is streamed, and one sample has more translucent fragments than fit
     *   into a third of the heap; or if a row of tiles has more than 2^32 samples
     * @throws InterruptedException if this thread is interrupted; all threads stop at their next primitive or row, and
     *   the sink receives no further rows
     */
    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        val pool = takePool()
        val parts = frame.content.parts
        val workers = Workers(threads, executor)
        val most = bandBytes(bandBytes)
        val counters = when {
            parts == null -> render(frame, sink, pool)
            parts.hasTranslucency -> LayeredRendering(frame, parts, workers, most).run(sink)
            else ->
                StreamedRendering(frame, parts, workers, most) { part, merge -> render(part, merge, pool) }.run(sink)
        }
        keep(pool)
        return counters
    }

    /**
     * Begins an image. Visible primitives and all translucent ones are kept until it ends; hidden ones are dropped
     * whenever there are as many again.
     */
    override fun begin(raster: Raster, region: Region): Rendering {
        val primitives = GroupedPrimitives(raster, region, ::render)
        return GuardedDrawing(this, primitives::draw, primitives::finish)
    }

    /**
     * Adds up the samples of each pixel within its tile, if pixels divide tiles and have at most [MOST_SIDE] samples a
     * side, and the frame is in memory.
     */
    @Throws(InterruptedException::class, IOException::class)
    override fun renderPixels(frame: Frame, side: Int, sink: RowSink): Counters? {
        require(side in 2..Raster.MAX_SIDE) { "a pixel has 2 or more samples a side: $side" }
        val region = frame.region
        val sides = listOf(region.columnStart, region.rowStart, region.columnEnd, region.rowEnd)
        require(sides.all { it % side == 0 }) { "$region must consist of pixels of $side x $side samples" }
        if (frame.isStreamed || coherence == Coherence.INCREMENTAL) return null
        if (tileSize % side != 0 || side > MOST_SIDE) return null
        val pool = takePool()
        return render(frame, sink, pool, side, pixelTileSize(tileSize)).also { keep(pool) }
    }

    /** Takes the pool that was kept: concurrent renderings each have their own. */
    private fun takePool(): ArrayPool = kept.getAndSet(null)?.get() ?: ArrayPool()

    private fun keep(pool: ArrayPool) = kept.set(SoftReference(pool))

    private fun render(frame: Frame, sink: RowSink, pool: ArrayPool, side: Int = 1, size: Int = tileSize): Counters {
        pool.begin()
        val workers = Workers(threads, executor)
        val grid = TileGrid(frame.region, size)
        return TiledRendering(frame, grid, coherence, workers, kernels(), pool, side).run(sink)
    }

    override fun toString(): String = "TiledRenderer($coherence, threads=$threads, tileSize=$tileSize)"

    internal companion object {
        /**
         * Returns the width of the tiles in which samples become pixels: with several samples a pixel, most triangles
         * reach several of the smaller tiles. Who asks for less than the default has little memory.
         */
        fun pixelTileSize(tileSize: Int): Int = if (tileSize in 64..256) 2 * tileSize else tileSize

        /** Many samples of a pixel can show as many primitives, for which rows of samples are faster. */
        private const val MOST_SIDE = 8
    }
}
