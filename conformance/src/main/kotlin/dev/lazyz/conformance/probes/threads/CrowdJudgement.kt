package dev.lazyz.conformance.probes.threads

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.CountingCursor
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Stripe
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.Violation
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.fail
import dev.lazyz.conformance.judgement.inTime
import dev.lazyz.conformance.judgement.withoutMemory
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.spi.ShadingCursor

/** Calls [block] until threads have met often enough to show race conditions, or do not meet at all. */
internal fun whileTheyMeet(where: Where, block: (meeting: Meeting, round: Int) -> Unit) {
    var left = where.enough
    repeat(MOST_ROUNDS) { round ->
        val meeting = Meeting(where)
        block(meeting, round)
        left -= meeting.closeMeetings
        if (!meeting.hasMet || left <= 0) return
    }
}

/** One round is usually enough, except where tiles or a busy machine let threads meet less often. */
private const val MOST_ROUNDS = 3

/** Fails unless [renderer] renders [crowd] as the oracle renders [quiet]. */
internal fun rightInACrowd(renderer: Renderer, quiet: FrameCase, crowd: Crowd) {
    val expected = Recording.of(ReferenceRenderer(), quiet.frame).image
    val actual = try {
        Recording.of(renderer, crowd.frame).image
    } catch (e: Exception) {
        throw Violation("${renderer.id}, when threads meet: threw $e", quiet, expected, cause = e)
    }
    val difference = difference(expected, actual) ?: return
    throw Violation("${renderer.id}, when threads meet: $difference\nin\n$quiet", quiet, expected, actual)
}

/** Fails unless [renderer], with four threads, counts what happens in [crowd], and the same as one thread. */
internal fun countsInACrowd(renderer: Renderer, quiet: FrameCase, crowd: Crowd) {
    val counters = Recording.of(renderer.configured(RenderOptions(threads = 4, tileSize = 8)), crowd.frame).counters
    val counted = listOf(counters.primitives, counters.fragments, counters.shadingCalls)
    val happened = listOf(Crowd.COUNT.toLong(), Crowd.FRAGMENTS, crowd.shadingCalls)
    val words = "primitives, fragments and shading calls"
    if (counted != happened) miscounted(renderer, quiet, "$words are $happened, but $counted are counted")
    if (Capability.PARALLEL !in renderer.capabilities) return
    val alone = Recording.of(renderer.configured(RenderOptions(threads = 1, tileSize = 8)), quiet.frame).counters
    if (counters.withoutMemory() != alone.withoutMemory()) {
        miscounted(renderer, quiet, "one thread counts $alone, but several count $counters")
    }
}

/**
 * Fails unless four threads count the same as one, in each of many renderings of many small tiles: two threads that
 * claim the same tile do its work twice. With steps of shading, too: they must not go on from tile to tile.
 */
internal fun countsEachTileOnce(renderer: Renderer) {
    // The last tiles are one row high
    val frame = Frame(Raster(WIDTH, HEIGHT), List(3) { Stepping(Stripe(0..<WIDTH, 0..<HEIGHT, 1000 + it)) })
    for (coherence in listOf(Coherence.DIRECT, Coherence.INCREMENTAL)) {
        if (coherence != Coherence.DIRECT && Capability.COHERENCE !in renderer.capabilities) continue
        fun configured(threads: Int) = renderer.configured(RenderOptions(coherence, threads = threads, tileSize = 8))
        val one = configured(1).inTime(frame) { _, _, _, _ -> }
        val several = configured(4)
        repeat(RENDERINGS) {
            TryUnderWay.current?.goesOn()
            val counters = several.inTime(frame) { _, _, _, _ -> }
            if (counters.withoutMemory() != one.withoutMemory()) {
                val what = "3 primitives that cover $WIDTH x $HEIGHT samples, $coherence"
                fail(renderer, "$what: one thread counts $one, but four count $counters")
            }
        }
    }
}

/** A primitive that shading can step along. */
private class Stepping(private val whole: Primitive) : Primitive by whole {
    override fun shadingCursor(x: Int, y: Int): ShadingCursor = CountingCursor(whole::shade, x, y)
}

private const val WIDTH = 256
private const val HEIGHT = 249
private const val RENDERINGS = 100

private fun miscounted(renderer: Renderer, quiet: FrameCase, what: String): Nothing {
    val right = Recording.of(ReferenceRenderer(), quiet.frame).image
    throw Violation("${renderer.id}, when threads meet: $what\nin\n$quiet", quiet, right, right)
}
