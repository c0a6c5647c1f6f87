package dev.lazyz.conformance.probes.threads

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Image
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
import dev.lazyz.conformance.probes.closeToAWall
import dev.lazyz.conformance.probes.fromAllSides
import dev.lazyz.conformance.probes.withinAUnit
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans
import java.util.concurrent.atomic.LongAdder

/** Where the primitives of a [Crowd] make threads meet. */
internal enum class Where(
    /**
     * Number of meetings that are enough. Threads that compare and write without a lock lose an update in about one of
     * thirty meetings; a shared fragment is noticed in nearly every one.
     */
    val enough: Int,
) {
    /** At the same row, and at the same sample when its depth is queried: two updates of the same sample. */
    SAME_SAMPLE(1_000),

    /** At any query for spans or colours: two uses of state that must belong to one thread. */
    ANY_SAMPLE(1_000),
}

/**
 * A frame whose primitives cover all samples and, if [meeting] is given, make threads meet. The nearest primitive
 * varies from sample to sample.
 */
internal class Crowd(
    private val salt: Long,
    private val where: Where,
    private val meeting: Meeting?,
    private val kind: KindOfWork = KindOfWork.OPAQUE,
) {
    val frame: Frame = Frame(Raster(SIDE, SIDE), List(COUNT) { Member(it) })

    private val shaded = LongAdder()

    /** Number of shading calls so far. */
    val shadingCalls: Long get() = shaded.sum()

    private fun hash(index: Int, x: Int, y: Int): Int {
        var h = salt + index * 0x632BE59BD9B4E019L + (y * SIDE + x) * -0x61C8864680B583EBL
        h = (h xor (h ushr 32)) * -0x2917014799A6026DL
        return (h ushr 34).toInt()
    }

    /** Returns the same frame without meetings. */
    fun quiet(): FrameCase = FrameCase(
        Crowd(salt, where, null, kind).frame,
        "SuiteFrames.crowd(${salt}L, \"$where\", \"$kind\")",
    )

    /** Returns the step of a sample, for threads that visit rows from left to right. */
    private fun step(x: Int, y: Int): Int = y * (SIDE + 1) + 1 + x

    private inner class Member(private val index: Int) : Primitive {
        override val rowStart: Int get() = 0
        override val rowEnd: Int get() = SIDE
        override val columnStart: Int get() = 0
        override val columnEnd: Int get() = SIDE

        override val isTranslucent: Boolean get() = kind == KindOfWork.TRANSLUCENT

        override fun spans(y: Int, spans: Spans) {
            if (y !in 0 until SIDE) return
            meeting?.meet(if (where == Where.SAME_SAMPLE) step(-1, y) else 0)
            spans.add(0, SIDE / 2 - 1)
            if (where == Where.ANY_SAMPLE) meeting?.meet(0)
            spans.add(SIDE / 2, SIDE)
        }

        override fun depth(x: Int, y: Int): Int {
            val depth = hash(index, x, y)
            if (where == Where.SAME_SAMPLE) meeting?.meet(step(x, y))
            return depth
        }

        override fun shade(fragment: Fragment) {
            shaded.increment()
            if (where == Where.ANY_SAMPLE) meeting?.meet(0)
            val bits = hash(index + COUNT, fragment.x, fragment.y)
            val alpha = if (isTranslucent) (bits shr 24 and 31) / 32f else 1f
            fragment.setColor((bits and 255) / 255f, (bits shr 8 and 255) / 255f, (bits shr 16 and 255) / 255f, alpha)
            if (where == Where.ANY_SAMPLE) meeting?.meet(0)
        }
    }

    companion object {
        const val SIDE = 64
        const val COUNT = 4

        /** Number of covered samples. The bounds of depth are loose, so that no sample is rejected early. */
        const val FRAGMENTS: Long = COUNT * SIDE * (SIDE - 1L)
    }
}

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

/**
 * Fails unless [renderer], which several threads use, renders [frame] as [expected], by default as the oracle [quiet].
 */
internal fun rightInACrowd(
    renderer: Renderer,
    quiet: FrameCase,
    frame: Frame = quiet.frame,
    expected: Image = Recording.of(ReferenceRenderer(), quiet.frame).image,
) {
    val actual = try {
        Recording.of(renderer, frame).image
    } catch (e: Exception) {
        throw Violation("${renderer.id}, when threads meet: threw $e", quiet, expected, cause = e)
    }
    val difference = difference(expected, actual) ?: return
    throw Violation("${renderer.id}, when threads meet: $difference\nin\n$quiet", quiet, expected, actual)
}

/**
 * Fails unless [renderer] renders meshes as before while another thread draws others: one whose triangles need every
 * comparison of depths, one whose triangles need none, and the same from all sides. Threads cannot be made to meet
 * within a mesh, so each draws all again and again.
 */
internal fun meshesAreIndependent(renderer: Renderer, salt: Long) {
    val cases = listOf(withinAUnit(salt), closeToAWall(salt)) + fromAllSides(salt)
    val expected = cases.associateWith { Recording.of(renderer, it.frame).image }
    atOnce(listOf(cases, cases.reversed())) { own ->
        repeat(ROUNDS_OF_MESHES) {
            for (case in own) rightInACrowd(renderer, case, expected = expected.getValue(case))
        }
    }
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
internal class Stepping(private val whole: Primitive) : Primitive by whole {
    override fun shadingCursor(x: Int, y: Int): ShadingCursor = CountingCursor(whole::shade, x, y)
}

private const val WIDTH = 256
private const val HEIGHT = 249
private const val RENDERINGS = 100
private const val ROUNDS_OF_MESHES = 20

private fun miscounted(renderer: Renderer, quiet: FrameCase, what: String): Nothing {
    val right = Recording.of(ReferenceRenderer(), quiet.frame).image
    throw Violation("${renderer.id}, when threads meet: $what\nin\n$quiet", quiet, right, right)
}
