package dev.lazyz.pipeline

import dev.lazyz.FrameContent
import dev.lazyz.FramePart
import dev.lazyz.FrameParts
import dev.lazyz.Helpers
import dev.lazyz.Reach
import dev.lazyz.Region
import dev.lazyz.Workers
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatch
import java.util.concurrent.ExecutionException
import java.util.concurrent.FutureTask
import java.util.concurrent.atomic.AtomicReference

/** A part of a streamed frame whose primitives are in memory. [first] is the submission index of the first one. */
internal class PartInMemory(val first: Int, val content: FrameContent) {
    /** A rectangle that contains all its samples. */
    val reach: Reach by lazy { reachOf(content) }

    private companion object {
        fun reachOf(part: FrameContent): Reach {
            var left = Int.MAX_VALUE
            var top = Int.MAX_VALUE
            var right = Int.MIN_VALUE
            var bottom = Int.MIN_VALUE
            for (primitive in part.singles) {
                left = minOf(left, primitive.columnStart)
                top = minOf(top, primitive.rowStart)
                right = maxOf(right, primitive.columnEnd)
                bottom = maxOf(bottom, primitive.rowEnd)
            }
            for (number in part.batches.indices) {
                val grid = part.triangleBatch(number).grid
                for (i in grid.indices step TriangleBatch.STRIDE) {
                    val column = ScreenGrid.firstSample(grid[i])
                    val row = ScreenGrid.firstSample(grid[i + 1])
                    left = minOf(left, column)
                    top = minOf(top, row)
                    right = maxOf(right, column)
                    bottom = maxOf(bottom, row)
                }
            }
            return Reach(left, top, right, bottom)
        }
    }
}

/** Returns the parts that may cover samples of [area]. */
internal fun FrameParts.reaching(area: Region): List<FramePart> =
    filter { it.reach == null || it.reach.within(area) != null }

/**
 * Calls [action] for each of the [parts] in order. Another thread makes them, if there is one. Ends if the calling
 * thread is interrupted.
 */
internal inline fun inOrder(parts: List<FramePart>, workers: Workers, action: (PartInMemory) -> Unit) {
    val helpers = Helpers(workers.executor)
    var isDone = false
    try {
        var next = parts.firstOrNull()?.let { PartToMake(it) }
        for (number in parts.indices) {
            endIfInterrupted()
            val current = checkNotNull(next)
            next = parts.getOrNull(number + 1)?.let { PartToMake(it) }
            if (next != null && workers.threads > 1) helpers.start(next::make)
            action(current.take())
        }
        isDone = true
    } finally {
        helpers.end(interrupt = !isDone)
    }
}

/** A part that one of two threads makes, whichever comes first. Thread safe. */
internal class PartToMake(part: FramePart) {
    // An executor may keep its task for long, and run it late or never; the task must not keep the part
    private val task = AtomicReference(FutureTask { PartInMemory(part.first, part.content()) })

    /** Makes the part, unless another thread has begun to. Its failure is thrown by [take]. */
    fun make() {
        task.get()?.run()
    }

    /** Returns the part, and forgets it. Makes it if no thread has begun to. Only once. */
    fun take(): PartInMemory {
        val own = checkNotNull(task.getAndSet(null))
        own.run()
        try {
            return own.get()
        } catch (e: ExecutionException) {
            throw e.cause ?: e
        }
    }
}
