package dev.lazyz.spark.pictures

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import java.io.IOException
import java.util.UUID
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock
import org.apache.spark.SparkException
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SparkSession

/**
 * A [Renderer] whose bands are tasks of Spark in this JVM: `local[2]` and the like. It is the same code as that of
 * [DistributedPicture], so everything that works with renderers can test it; the conformance suite does.
 *
 * Frames hold primitives that cannot be sent to other JVMs. So with a cluster, [render] throws
 * [IllegalArgumentException]: use [DistributedPicture], which sends how to make a frame. Thread safe.
 *
 * @param spark where to render, in local mode
 */
public class SparkRenderer(spark: SparkSession) : Renderer {
    private val context = JavaSparkContext.fromSparkContext(spark.sparkContext())

    override val id: String get() = "spark"

    override val summary: String get() = "bands of rows as tasks of Apache Spark"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.TRANSPARENCY)

    /**
     * Renders [frame], and passes every row to [sink], on this thread.
     *
     * @throws IllegalArgumentException if Spark is not in local mode, or the frame is streamed
     * @throws InterruptedException if this thread is interrupted; all tasks have stopped then
     */
    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        require(context.isLocal) { "a frame cannot be sent to executors; use DistributedPicture with a PictureSource" }
        require(!frame.isStreamed) { "the frame is streamed, and each band would read it; use TrianglePicture" }
        if (Thread.interrupted()) throw InterruptedException("interrupted before rendering")
        val held = HeldFrame(SuperSampling.NONE.of(frame))
        frames[held.id] = held
        val bands = SortFirst.bands(frame.region, context.defaultParallelism())
        context.setJobGroup(held.id, "render $frame", true)
        try {
            return SortFirst(context, OncePerJvm(LocalFrame(held.id)), SortFirst.ALL_PLANES).use {
                it.render(bands, sink)
            }
        } catch (e: SparkException) {
            // The task's own exception, not Spark's about it
            throw held.failure ?: e
        } finally {
            context.cancelJobGroup(held.id)
            context.clearJobGroup()
            held.close()
            frames.remove(held.id)
        }
    }

    override fun toString(): String = "SparkRenderer(${context.master()})"

    /** A frame that is being rendered, and what a task of it has thrown. */
    private class HeldFrame(val picture: SampledFrame) {
        val id: String = "${UUID.randomUUID()}"
        private val lock = ReentrantLock()
        private val changed = lock.newCondition()
        private var running = 0
        private var isClosed = false

        @Volatile
        var failure: Throwable? = null
            private set

        fun <T> during(work: () -> T): T {
            lock.withLock {
                check(!isClosed) { "the rendering is over" }
                running++
            }
            try {
                return work()
            } catch (e: Throwable) {
                if (e !is InterruptedException) failure = failure ?: e

                // Spark ends the JVM on some errors, which is not for it to decide here
                throw IllegalStateException("rendering failed", e)
            } finally {
                lock.withLock {
                    running--
                    changed.signalAll()
                }
            }
        }

        /** Waits until no task works on the frame, and lets no other begin. */
        fun close() = lock.withLock {
            isClosed = true
            while (running > 0) changed.awaitUninterruptibly()
        }
    }

    /** The name of a frame in this JVM. */
    private class LocalFrame(private val id: String) :
        PictureSource,
        TaskWitness {
        private fun held() = checkNotNull(frames[id]) { "the rendering is over, or the frame is in another JVM" }

        override fun picture(): SampledFrame = held().picture

        override fun <T> during(work: () -> T): T = held().during(work)
    }

    private companion object {
        val frames = ConcurrentHashMap<String, HeldFrame>()
    }
}
