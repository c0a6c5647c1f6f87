package dev.lazyz.spark.scaling

import dev.lazyz.Counters
import dev.lazyz.spark.pictures.PixelBlock
import dev.lazyz.spark.triangles.FragmentRuns
import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.jobs.BandPart
import dev.lazyz.spark.triangles.jobs.DrawPart
import dev.lazyz.spark.triangles.jobs.MergeParts
import java.lang.management.ManagementFactory
import org.apache.spark.broadcast.Broadcast
import scala.reflect.ClassTag

/** Runs of some bands or strips of a picture, each with its number and the number of its fragments. */
internal class RunPiece(val cells: List<Cell>) {
    class Cell(val number: Int, val part: BandPart, val fragments: Long)

    val fragments: Long get() = cells.sumOf { it.fragments }
}

/**
 * What it took to draw a part.
 *
 * @property covered fragments of all triangles, also of those that are hidden
 */
internal class Drawn(val bands: RunPiece, val triangles: Int, val covered: Long, val seconds: Double)

/** What it took to merge runs with these numbers of [fragments], which show regions of [samples] in total. */
internal class MergeCost(val samples: Long, val fragments: List<Long>, val seconds: Double)

/**
 * Pictures of parts of a [sphere], drawn and merged by the code that the tasks of a Spark job run, without Spark.
 *
 * @param strips the picture is divided into so many when nodes split it
 * @param bandRows rows of a band of the job
 */
internal class PartPictures(
    val sphere: BumpySphere,
    val width: Int,
    val height: Int,
    strips: Int,
    bandRows: Int = PictureSetUp.bandRows(width, height),
) {
    private val camera = SerializableCamera(sphere.camera(width, height))
    private val stripRows = height / strips

    init {
        require(height % strips == 0) { "the height must be a multiple of $strips: $height" }
    }

    /** The picture in bands, as the job divides it. */
    val bandSetUp: PictureSetUp = setUp(bandRows)

    /** The picture in strips. */
    val stripSetUp: PictureSetUp = setUp(stripRows)

    private fun setUp(rows: Int) = PictureSetUp(BumpySphere.SCENE, camera, width, height, rows)

    /** Draws a part as a task does. */
    fun draw(part: Int, parts: Int, split: Split): Drawn {
        val rows = sphere.rows(part, parts, split)
        val drawn = timed {
            DrawPart(Known(bandSetUp), isShaded = true).call(part, rows.iterator()).asSequence().toList()
        }
        val cells = drawn.value.groupBy({ it._1().band }, { it._2() })
            .map { (band, of) -> cell(bandSetUp, band, if (of.size == 1) of.single() else merged(band, of)) }
        val covered = drawn.value.sumOf { it._2().work[FRAGMENTS] }
        return Drawn(RunPiece(cells), rows.size, covered, drawn.seconds)
    }

    private fun merged(band: Int, parts: List<BandPart>) = MergeParts(Known(bandSetUp), true).part(band, parts)

    /** Returns the fragments of [bands] in all strips, also those that show nothing. */
    fun strips(bands: RunPiece): RunPiece {
        val runs = List(stripSetUp.bands) { FragmentRuns.Builder(isShaded = true) }
        for (cell in bands.cells) {
            cell.part.runs.forEach(bandSetUp.region(cell.number)) { x, y, key, color ->
                runs[y / stripRows].add(y % stripRows * width + x, key, color)
            }
        }
        return RunPiece(runs.mapIndexed { i, run -> cell(stripSetUp, i, BandPart(run.build(), 0, NO_WORK)) })
    }

    /** Merges real runs, and keeps what it cost in [costs]. */
    class RunCompositing(private val setUp: PictureSetUp, private val costs: MutableList<MergeCost>) :
        Compositing<RunPiece> {
        private val merge = MergeParts(Known(setUp), isShaded = true)

        override fun bytes(piece: RunPiece): Long = piece.cells.sumOf { it.part.runs.size.toLong() }

        /** Every [ways]-th strip: so that all have about the same share of what is in the middle of a picture. */
        override fun split(piece: RunPiece, ways: Int): List<RunPiece> =
            List(ways) { own -> RunPiece(piece.cells.filterIndexed { i, _ -> i % ways == own }) }

        override fun merge(pieces: List<RunPiece>): Timed<RunPiece> {
            val numbers = pieces.first().cells.map { it.number }
            check(pieces.all { piece -> piece.cells.map { it.number } == numbers }) { "other strips: $numbers" }
            val merged = timed {
                numbers.mapIndexed { i, number -> merge.part(number, pieces.map { it.cells[i].part }) }
            }
            val samples = numbers.sumOf { setUp.region(it).size }
            costs += MergeCost(samples, pieces.map { it.fragments }, merged.seconds)
            val cells = numbers.mapIndexed { i, number -> cell(setUp, number, merged.value[i]) }
            return Timed(RunPiece(cells), merged.seconds)
        }
    }

    /** What is broadcast, in one JVM. */
    private class Known<T : Any>(private val known: T) : Broadcast<T>(0, ClassTag.apply(known.javaClass)) {
        override fun getValue(): T = known

        override fun doUnpersist(blocking: Boolean) = Unit

        override fun doDestroy(blocking: Boolean) = Unit
    }

    companion object {
        private const val FRAGMENTS = 1
        private val NO_WORK = PixelBlock.work(Counters.NONE)
        private val threads = ManagementFactory.getThreadMXBean()

        /** Calls [work], and returns its result with the processor time of this thread. */
        fun <T> timed(work: () -> T): Timed<T> {
            val start = threads.currentThreadCpuTime
            val value = work()
            return Timed(value, (threads.currentThreadCpuTime - start) / 1e9)
        }

        private fun cell(setUp: PictureSetUp, number: Int, part: BandPart): RunPiece.Cell {
            var fragments = 0L
            part.runs.forEach(setUp.region(number)) { _, _, _, _ -> fragments++ }
            return RunPiece.Cell(number, part, fragments)
        }
    }
}
