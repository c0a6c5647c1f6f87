package dev.lazyz.spark.scaling

import dev.lazyz.spark.triangles.PictureSetUp
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.jobs.BandKey
import dev.lazyz.spark.triangles.jobs.BandPart
import dev.lazyz.spark.triangles.jobs.DrawPart
import dev.lazyz.spark.triangles.jobs.MergeParts
import dev.lazyz.spark.triangles.jobs.SortLast
import java.lang.management.ManagementFactory
import org.apache.spark.broadcast.Broadcast
import scala.reflect.ClassTag

/** A result, and the seconds of one processor that it took. */
internal class Timed<T>(val value: T, val seconds: Double)

/** A part of a band, and the node that has it. */
internal class Held(val key: BandKey, val node: Int, val part: BandPart)

/**
 * A round of merging.
 *
 * @property tasks tasks that merge, including those without work
 * @property bytes what the busiest node sends or receives
 * @property seconds what the busiest node needs to merge
 */
internal class Round(val tasks: Int, val bytes: Long, val seconds: Double)

/**
 * Pictures of parts of a [sphere], drawn and merged by the code that the tasks of a Spark job run, without Spark.
 *
 * @param bandRows rows of a band of the job
 */
internal class PartPictures(
    val sphere: BumpySphere,
    width: Int,
    height: Int,
    bandRows: Int = PictureSetUp.bandRows(width, height),
) {
    /** The picture in bands, as the job divides it. */
    val setUp: PictureSetUp =
        PictureSetUp(BumpySphere.SCENE, SerializableCamera(sphere.camera(width, height)), width, height, bandRows)

    private val known = Known(setUp)
    private val merge = MergeParts(known, isShaded = true)

    /** Draws a part as a task does, on the node with its number. */
    fun draw(part: Int, parts: Int, split: Split): Timed<List<Held>> {
        val rows = sphere.rows(part, parts, split)
        val drawn = timed { DrawPart(known, isShaded = true).call(part, rows.iterator()).asSequence().toList() }
        return Timed(drawn.value.map { Held(it._1(), part, it._2()) }, drawn.seconds)
    }

    /**
     * Merges what [nodes] nodes have drawn, as [SortLast] does: [fanIn] parts of a band at a time, in rounds that begin
     * when the one before has ended. A task runs on the node with its number.
     */
    fun merged(drawn: List<Held>, nodes: Int, fanIn: Int = SortLast.FAN_IN): Pair<List<Held>, List<Round>> {
        var held = drawn
        val rounds = SortLast.groups(nodes, fanIn).map { groups ->
            val tasks = SortLast.tasks(nodes, setUp.bands, groups)
            val sent = LongArray(nodes)
            val received = LongArray(nodes)
            val seconds = DoubleArray(nodes)
            held = held.groupBy { BandKey(it.key.band, it.key.group / fanIn) }.map { (key, all) ->
                val node = SortLast.task(key, groups, tasks)
                // What is merged where it was made crosses no network
                for (one in all) {
                    if (one.node == node) continue
                    sent[one.node] += one.part.runs.size.toLong()
                    received[node] += one.part.runs.size.toLong()
                }
                val result = timed { merge.part(key.band, all.map { it.part }) }
                seconds[node] += result.seconds
                Held(key, node, result.value)
            }
            Round(tasks, (sent + received).max(), seconds.max())
        }
        return held to rounds
    }

    /** What is broadcast, in one JVM. */
    private class Known<T : Any>(private val known: T) : Broadcast<T>(0, ClassTag.apply(known.javaClass)) {
        override fun getValue(): T = known

        override fun doUnpersist(blocking: Boolean) = Unit

        override fun doDestroy(blocking: Boolean) = Unit
    }

    private companion object {
        private val threads = ManagementFactory.getThreadMXBean()

        /** Calls [work], and returns its result with the processor time of this thread. */
        fun <T> timed(work: () -> T): Timed<T> {
            val start = threads.currentThreadCpuTime
            val value = work()
            return Timed(value, (threads.currentThreadCpuTime - start) / 1e9)
        }
    }
}
