package dev.lazyz.strategies.tiled

import dev.lazyz.Capability
import dev.lazyz.Coherence
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.strategies.tiled.binning.ArrayPool
import dev.lazyz.strategies.tiled.raster.TileGrid
import java.lang.ref.SoftReference
import java.util.concurrent.atomic.AtomicReference

/**
 * The production default: the picture in tiles, each decided by one thread in its cache, on all cores.
 *
 * Primitives are put into bins, one a tile. A tile runs a small depth buffer of 64-bit visibility keys: the nearest
 * fragment is a minimum. Triangles of meshes are drawn from near to far, in blocks of samples, and a triangle is thrown away
 * where it is behind all that a tile or a block shows. When all has been drawn, each visible sample is shaded once, in
 * batches. Each thread takes tiles of its own columns, and then of the others'; what they decide is a minimum of a total order, so nothing depends on who
 * was first: the same bits, and the same counters, for any number of threads (but [Counters.peakBytes], which grows with it).
 * Translucent fragments that lie before what is opaque are noted, sorted by sample and blended in exact order of depth.
 *
 * Use it wherever nothing speaks against it. Use `ZBuffer` where primitives arrive one by one and are too many to
 * keep, `LazyZBuffer` or `FlowPipeline` to stop after some rows or to look at few samples, and `ScanLine` where depth
 * is expensive.
 *
 * Fastest by far where the JVM was started with `--add-modules jdk.incubator.vector` and where opaque surfaces are
 * [dev.lazyz.world.Mesh]es in a [dev.lazyz.world.Scene]: their triangles are never objects. Shaders of one's own are faster as
 * [dev.lazyz.BatchShader]s.
 *
 * Memory: one row of tiles (with several threads two or more), at 12 bytes a sample; for at most 4096 tiles at a time, 20 bytes
 * for each pair of a mesh's triangle and a tile, and 24 for each fragment of one of less than ten samples and for each triangle that
 * reaches 8 tiles; some 30 bytes for each other primitive in a row of tiles, and the spans of those that several tiles share; for each thread a tile's
 * keys, 8 bytes a sample, and 20 bytes for each translucent fragment of a tile; and 16 bytes for each primitive of the
 * frame that is not a mesh's. It does not grow with the number of rows. Make tiles smaller for pictures that are very wide.
 * Rows and bins are kept for the next rendering, softly: a frame like the last one allocates nothing that is large, and
 * where memory is short the collector takes them. So keep the renderer, too.
 * Time: proportional to the triangles, to the samples that are not rejected and to the visible samples, divided by the
 * threads.
 *
 * Rows reach the sink on the calling thread, which also renders tiles. [RenderOptions.threads] - 1 threads are started
 * for a rendering and have ended when it ends, however it ends: what a primitive, a shader or the sink throws on any
 * thread reaches the caller as it is; of several exceptions one, with the others suppressed. Primitives and shaders are
 * called from all threads at once. Thread safe; between calls nothing is kept but empty arrays.
 *
 * Source: Henry Fuchs et al., "Pixel-Planes 5: A Heterogeneous Multiprocessor Graphics System Using Processor-Enhanced
 * Memories", SIGGRAPH 1989, for bins of regions that processors take one after the other; Steven Molnar, Michael Cox,
 * David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering", IEEE Computer Graphics and
 * Applications 14 (1994), whose "sort-middle" this is; Larry Seiler et al., "Larrabee: A Many-Core x86 Architecture
 * for Visual Computing", SIGGRAPH 2008, for doing it in software; Juan Pineda, "A Parallel Algorithm for Polygon
 * Rasterization", SIGGRAPH 1988, for edge functions and blocks. There a bin keeps the order of submission
 * because later results depend on it; here order is part of the key.
 */
public class Tiled internal constructor(
    private val coherence: Coherence,
    private val threads: Int,
    private val tileSize: Int,
    private val kernels: () -> Kernels = Kernels::best,
) : Renderer {
    /** The arrays of the last rendering, until memory is short. */
    private val kept = AtomicReference<SoftReference<ArrayPool>>()

    /** A renderer that heeds [RenderOptions.coherence], [RenderOptions.threads] and [RenderOptions.tileSize]. */
    @JvmOverloads
    public constructor(options: RenderOptions = RenderOptions()) :
        this(options.coherence, options.threads, options.tileSize)

    override val id: String get() = "tiled"

    override val summary: String get() = "tiles on all cores, visibility keys merged by minimum, colours at the end"

    /** What the innermost loops are: `vector` where the JVM has the module `jdk.incubator.vector`, otherwise `scalar`. */
    public val kernel: String get() = kernels().name.lowercase()

    override val capabilities: Set<Capability>
        get() = setOf(
            Capability.SHADES_ONLY_VISIBLE,
            Capability.CONSTANT_MEMORY,
            Capability.PARALLEL,
            Capability.TRANSPARENCY,
            Capability.COHERENCE,
        )

    override fun configured(options: RenderOptions): Tiled = Tiled(options)

    /**
     * Renders [frame] and hands every row to [sink], on this thread.
     *
     * @throws InterruptedException if this thread is interrupted; all threads stop at their next primitive or row, and
     *   the sink gets no further row
     */
    @Throws(InterruptedException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        // Whoever renders at the same time has a pool of its own
        val pool = kept.getAndSet(null)?.get() ?: ArrayPool()
        pool.begin()
        val counters = Rendering(frame, TileGrid(frame.region, tileSize), coherence, threads, kernels(), pool).run(sink)
        kept.set(SoftReference(pool))
        return counters
    }

    override fun toString(): String = "Tiled($coherence, threads=$threads, tileSize=$tileSize)"
}
