package dev.lazyz.conformance.fuzz

import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.judgement.Recording
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.run.smallest
import java.util.function.Supplier
import net.jqwik.api.Shrinkable

/**
 * Two new renderers with the same options, for frames one after the other: what a renderer keeps of one must not change
 * the next. Not thread safe.
 */
internal class RendererPair(makers: List<Supplier<out Renderer>>, options: RenderOptions) {
    private val renderers = makers.map { maker -> maker.get().let { it.configured(options.supportedBy(it)) } }

    /** Describes how the two differ for [case]; null if they do not. Calls [between] before the second renders. */
    fun disagreement(case: FrameCase, between: () -> Unit = {}): String? {
        val one = runCatching { Recording.of(renderers[0], case.frame) }
        between()
        val other = runCatching { Recording.of(renderers[1], case.frame) }
        val thrown = listOf(one, other).map { it.exceptionOrNull()?.javaClass?.name }
        if (thrown[0] != thrown[1]) {
            return "the first threw ${thrown[0] ?: "nothing"}, the second ${thrown[1] ?: "nothing"}"
        }
        val images = listOf(one, other).map { it.getOrNull()?.image ?: return null }
        return difference(images[0], images[1])?.toString()
    }

    /** Renders [cases] one after the other, and describes how the two differ for the last. */
    fun disagreement(cases: List<FrameCase>): String? {
        for (case in cases.dropLast(1)) disagreement(case)
        return disagreement(cases.last())
    }
}

/** Frames that new renderers render one after the other, and how the last one differs. */
internal class Failure(val cases: List<FrameCase>, val why: String)

/**
 * Searches for the shortest part of [frames] that fails, with its last frame, and makes each of these frames small.
 *
 * @param steps how many smaller frames are tried for each frame at most
 * @param failure returns how the last of some frames differs, or null if it does not
 * @return null if [frames] do not fail
 */
internal fun reduced(
    frames: List<Shrinkable<FrameCase>>,
    steps: Int,
    failure: (List<FrameCase>) -> String?,
): Failure? {
    fun fails(some: List<Shrinkable<FrameCase>>) = failure(some.map { it.value() })
    var needed = frames.takeLast(1)
    var why = fails(needed)
    if (why == null) {
        needed = frames
        why = fails(needed) ?: return null
        var count = needed.size / 2
        while (count > 0) {
            var at = 0
            while (at < needed.size - 1) {
                val fewer = needed.take(at) + needed.subList(minOf(at + count, needed.size - 1), needed.size)
                val stillFails = fails(fewer)
                if (stillFails == null) at += count else needed = fewer.also { why = stillFails }
            }
            count /= 2
        }
    }
    val cases = needed.map { it.value() }.toMutableList()
    for (i in cases.indices.reversed()) {
        fun with(case: FrameCase) = cases.toMutableList().also { it[i] = case }
        val (small, stillFails) = smallest(needed[i], checkNotNull(why), steps) { failure(with(it)) }
        cases[i] = small
        why = stillFails
    }
    return Failure(cases, checkNotNull(why))
}
