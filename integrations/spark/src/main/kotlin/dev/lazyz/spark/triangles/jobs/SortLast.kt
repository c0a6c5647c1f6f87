package dev.lazyz.spark.triangles.jobs

import dev.lazyz.Counters
import dev.lazyz.spark.pictures.PixelBlock
import dev.lazyz.spark.triangles.BandSamples
import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.TriangleChunk
import org.apache.spark.Partitioner
import org.apache.spark.api.java.JavaPairRDD
import org.apache.spark.api.java.JavaRDD
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.api.java.function.Function2
import org.apache.spark.broadcast.Broadcast
import org.apache.spark.sql.Row
import scala.Tuple2

/**
 * Each partition draws its triangles, and the nearest fragments of all are merged in a tree: eight parts of a band at a
 * time ("sort-last"). With lazy shading only keys are merged. Then all tasks get the list of visible triangles, send
 * these to their bands, and the bands are drawn again with colours: each visible sample is shaded once, and no colour
 * crosses the network before.
 *
 * Source: Steven Molnar, Michael Cox, David Ellsworth, Henry Fuchs, "A Sorting Classification of Parallel Rendering",
 * IEEE Computer Graphics and Applications 14 (1994); Michael Deering et al., "The Triangle Processor and Normal Vector
 * Shader", SIGGRAPH 1988, for shading after visibility.
 */
internal class SortLast(private val rows: JavaRDD<Row>, private val setUp: Broadcast<PictureSetUp>) {
    private val context = JavaSparkContext.fromSparkContext(rows.context())

    /** Returns the bands that show triangles. With lazy shading, the keys are merged now. */
    fun bands(isLazy: Boolean): JavaPairRDD<Int, FinishedBand> {
        val merged = tree(!isLazy)
        val merge = MergeParts(setUp, !isLazy)
        if (!isLazy) {
            return merged.mapToPair { parts ->
                val all = merge.merged(parts._1(), parts._2())
                Tuple2(parts._1(), FinishedBand.of(all.samples, all.moved, all.work))
            }
        }

        val visible = merged.map { parts ->
            val all = merge.merged(parts._1(), parts._2())
            VisibleTriangles.OfBand(parts._1(), all.samples.visible(), VisibleTriangles.Cost(all.moved, all.work))
        }
        val broadcast = context.broadcast(VisibleTriangles(visible.collect()))
        val selected = rows.mapPartitionsToPair { BandTriangles.sent(it, broadcast.value()::byBand) }
        return BandTriangles(setUp, selected).drawn(broadcast, Int.SIZE_BYTES + TriangleChunk.BYTES)
    }

    /** Returns the last parts to be merged, by band. */
    private fun tree(isShaded: Boolean): JavaPairRDD<Int, Iterable<BandPart>> {
        val merge = MergeParts(setUp, isShaded)
        val bands = setUp.value().bands
        var parts = rows.mapPartitionsWithIndex(DrawPart(setUp, isShaded), false).mapToPair { it }
        for (groups in groups(rows.numPartitions).dropLast(1)) {
            val tasks = ByBandAndGroup(groups, tasks(rows.numPartitions, bands, groups))
            parts = parts.mapToPair { Tuple2(BandKey(it._1().band, it._1().group / FAN_IN), it._2()) }
                .groupByKey(tasks)
                .mapToPair { Tuple2(it._1(), merge.part(it._1().band, it._2())) }
        }
        return parts.mapToPair {
            Tuple2(it._1().band, it._2())
        }.groupByKey(tasks(rows.numPartitions, bands, groups = 1))
    }

    companion object {
        /** Parts that are merged at a time. */
        const val FAN_IN: Int = 8

        /** Returns how many groups there are after each round of merging [parts] parts: one after the last. */
        fun groups(parts: Int, fanIn: Int = FAN_IN): List<Int> {
            val rounds = generateSequence(parts) { (it + fanIn - 1) / fanIn }.drop(1)
            return rounds.takeWhile { it > 1 }.toList() + 1
        }

        /** Returns how many tasks merge [parts] parts into [groups] groups of each band: no more than have work. */
        fun tasks(parts: Int, bands: Int, groups: Int): Int = minOf(parts.toLong(), bands.toLong() * groups).toInt()

        /** Returns which of [tasks] tasks merges [key], if there are [groups] groups of each band. */
        fun task(key: BandKey, groups: Int, tasks: Int): Int =
            ((key.band.toLong() * groups + key.group) % tasks).toInt()
    }
}

/** Draws the triangles of a partition. Returns the parts of all bands that they reach. */
internal class DrawPart(private val setUp: Broadcast<PictureSetUp>, private val isShaded: Boolean) :
    Function2<Int, Iterator<Row>, Iterator<Tuple2<BandKey, BandPart>>> {
    override fun call(number: Int, rows: Iterator<Row>): Iterator<Tuple2<BandKey, BandPart>> {
        val known = setUp.value()
        val drawing = known.drawing()
        val most = mostBands(known)
        val finished = ArrayList<Tuple2<BandKey, BandPart>>()
        val bands = LinkedHashMap<Int, BandSamples>(16, 0.75f, true)
        fun finish(band: Int) {
            val runs = bands.remove(band)!!.toRuns(isShaded)
            finished += Tuple2(BandKey(band, number), BandPart(runs, 0, PixelBlock.work(Counters.NONE)))
        }
        for (chunk in TriangleChunk.chunks(rows)) {
            val part = drawing.part(chunk)
            for (band in part.region?.let(known::bands) ?: continue) {
                // A band that is finished early is merged with what follows, like any other part
                if (band !in bands && bands.size == most) finish(bands.keys.first())
                part.draw(bands.getOrPut(band) { BandSamples(drawing.raster, known.region(band)) }, isShaded)
            }
        }
        bands.keys.toList().forEach(::finish)
        if (finished.isNotEmpty()) {
            val last = finished.removeLast()
            finished += Tuple2(last._1(), BandPart(last._2().runs, 0, PixelBlock.work(drawing.work())))
        }
        return finished.iterator()
    }

    private companion object {
        /** The part of the heap for the bands of all tasks. */
        const val PART = 0.2
        const val BYTES_PER_SAMPLE = 12L

        fun mostBands(known: PictureSetUp): Int {
            val share = Runtime.getRuntime().maxMemory() * PART / Runtime.getRuntime().availableProcessors()
            return (share / (BYTES_PER_SAMPLE * known.region(0).size)).toInt().coerceAtLeast(1)
        }
    }
}

/** Spark's hashes would give some tasks several bands, and others none. */
private class ByBandAndGroup(private val groups: Int, private val tasks: Int) : Partitioner() {
    override fun numPartitions(): Int = tasks

    override fun getPartition(key: Any): Int = SortLast.task(key as BandKey, groups, tasks)

    override fun equals(other: Any?): Boolean =
        other is ByBandAndGroup && groups == other.groups && tasks == other.tasks

    override fun hashCode(): Int = 31 * groups + tasks
}
