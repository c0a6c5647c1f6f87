package dev.lazyz.spark.pictures

import dev.lazyz.Counters
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RowSink
import dev.lazyz.strategies.tiled.TiledRenderer
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.api.java.function.Function
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.storage.StorageLevel

/**
 * Divides a picture into rectangles, each of which a task renders ("sort-first"). Regions of a frame are exact, so
 * their pixels are those of the whole picture. The source is broadcast, and makes its frame once in each JVM.
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994).
 *
 * @param planes see [PixelBlock]
 * @param kept where finished parts stay; null for nowhere
 */
internal class SortFirst(
    private val context: JavaSparkContext,
    source: OncePerJvm,
    private val planes: Int,
    private val kept: PartFiles? = null,
) : AutoCloseable {
    private val broadcast: Broadcast<OncePerJvm> = context.broadcast(source)

    /** Returns the rendered regions, a partition for each, which Spark computes when they are needed. */
    fun blocks(regions: List<Region>): JavaRDD<PixelBlock> {
        val numbers = regions.map { intArrayOf(it.columnStart, it.rowStart, it.columnEnd, it.rowEnd) }
        return context.parallelize(numbers, numbers.size).map(RenderRegion(broadcast, planes, kept))
    }

    /**
     * Renders all [regions], which are bands of whole rows from the top, in parallel; then passes their rows to [sink]
     * on this thread. Finished bands are on the disks of the executors; if they are lost, Spark renders them again.
     */
    fun render(regions: List<Region>, sink: RowSink): Counters {
        val bands = blocks(regions).persist(StorageLevel.DISK_ONLY())
        try {
            bands.count()
            return handOut(bands.toLocalIterator(), sink)
        } finally {
            bands.unpersist(false)
        }
    }

    private fun handOut(bands: Iterator<PixelBlock>, sink: RowSink): Counters {
        val sum = Counters.Builder()
        for (band in bands) {
            band.sendTo(sink)
            sum.add(band.counters)
            sum.primitives = band.counters.primitives
        }
        return sum.build()
    }

    override fun close(): Unit = broadcast.destroy()

    /** Renders a region, given as its four sides. */
    private class RenderRegion(
        private val source: Broadcast<OncePerJvm>,
        private val planes: Int,
        private val kept: PartFiles?,
    ) : Function<IntArray, PixelBlock> {
        override fun call(sides: IntArray): PixelBlock {
            val region = Region(sides[0], sides[1], sides[2], sides[3])
            return kept?.read(region, planes) ?: rendered(region).also { kept?.write(it, planes) }
        }

        private fun rendered(region: Region): PixelBlock {
            val block = PixelBlock.Builder(region, planes)
            val renderer = TiledRenderer(RenderOptions(threads = 1))
            return source.value().rendering { picture ->
                val counters = picture.within(region).render(renderer) { _, argb, depth, primitive ->
                    block.add(argb)
                    if (planes == ALL_PLANES) {
                        block.add(depth)
                        block.add(primitive)
                    }
                }
                block.build(counters)
            }
        }
    }

    companion object {
        /** Colours, depths and primitives. */
        const val ALL_PLANES: Int = 3

        /** Bands for each thread of the cluster, so that fast ones can take more of them. */
        private const val BANDS_PER_THREAD = 4

        /** A multiple of the rows of tiles, so that few tiles are cut. */
        private const val ROWS = 64

        /** Most pixels of a band, which is in memory while it is compressed. */
        private const val MOST_PIXELS = 1L shl 24

        /** Returns bands of whole rows of [region], for [threads] threads. */
        fun bands(region: Region, threads: Int): List<Region> {
            val wished = region.height / (BANDS_PER_THREAD * threads)
            val most = (MOST_PIXELS / region.width).coerceAtLeast(1).toInt()
            val rows = maxOf((wished + ROWS - 1) / ROWS * ROWS, ROWS).coerceAtMost(most)
            return (region.rowStart until region.rowEnd step rows).map { region.rows(it, it + rows) }
        }
    }
}
