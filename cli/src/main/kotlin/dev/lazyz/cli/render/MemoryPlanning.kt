package dev.lazyz.cli.render

import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.Shot
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.planning.MemoryItem
import dev.lazyz.planning.RenderPlan
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.planning.SetUpMemory
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.Scenes

/**
 * The option `--memory`: plans a rendering of [request] that stays within [allowed] bytes of Java's memory, or refuses
 * it before it begins. What is already in memory is measured after a garbage collection.
 */
internal class MemoryPlanning(private val allowed: Long, private val request: RenderRequest) {
    /** Bytes that may be used: not more than Java itself may use. */
    val memory: Long = minOf(allowed, Runtime.getRuntime().maxMemory())
    private val advice = MemoryAdvice(request, allowed, memory)

    /**
     * Returns how to read the model of [source]: null for as a whole, if it fits, or if its need is unknown; or part
     * by part, if the picture is the same.
     *
     * @throws Mistake if the model does not fit
     */
    fun streaming(source: FrameSource, choice: StrategyChoice): StreamRequest? {
        val input = source.input
        val need = PROGRAM_BYTES + Scenes.leastMemory(input.statedFormat, input.fileBytes ?: return null)
        if (need <= memory) return null
        val streaming = request.streamingForMemory
        val isPossible = choice.canStream && streaming.obstacle(request) == null
        if (input.statedFormat == SceneFormat.STL && request.subject.hasFaceNormals && isPossible) return streaming
        throw advice.refusal("reading ${input.name}", need, streamed = input.statedFormat.takeIf { isPossible })
    }

    /** Calls [prepare], which reads and sets up all that a rendering needs. */
    fun <T> preparing(source: FrameSource, prepare: () -> T): T = try {
        prepare()
    } catch (full: OutOfMemoryError) {
        throw advice.refusal("reading and setting up ${source.input.name}", null)
    }

    /**
     * Checks that [loaded] can be set up.
     *
     * @throws Mistake otherwise
     */
    fun requireSetUp(source: FrameSource, loaded: LoadedScene) {
        val setUp = SetUpMemory.bytes(loaded.scene)

        // Small scenes need no look at the memory, which takes time
        if (setUp < memory / SMALL_PART) return
        val need = RenderPlan.leastMemory(held() + setUp)
        if (need > memory) throw advice.refusal("setting up ${source.input.name}", need)
    }

    /**
     * Returns the plan for [shot], with the first strategy of [choice] that fits.
     *
     * @param outputs what receives the rows
     * @throws Mistake if none fits
     */
    fun plan(source: FrameSource, shot: Shot, choice: StrategyChoice, outputs: List<MemoryItem>): RenderPlan {
        val others = listOf(MemoryItem("program, scene and primitives", held())) + outputs
        val planner = RenderPlanner(memory, request.choices.options())
        val renderers = choice.rendererChoices(shot.frame, memory)
        val plan = shot.plan(planner, renderers, others)
        if (plan.fits) return plan

        // Would a picture of one pixel fit?
        val corner = with(shot.pixels) { Region(columnStart, rowStart, columnStart + 1, rowStart + 1) }
        val smallest = shot.within(corner).plan(planner, renderers, others.take(1))
        throw advice.refusal("the picture", plan.leastMemory, plan, canShrink = smallest.fits)
    }

    /** Returns lines about the [plan], and about the disk. */
    fun explain(plan: RenderPlan, frame: Frame, streaming: StreamRequest?): String {
        val limit = if (memory < allowed) {
            "memory: of ${Bytes.readable(allowed)}, Java keeps a part for its garbage collector\n"
        } else {
            ""
        }
        val disk = if (frame.isStreamed && streaming != null) {
            "disk: the model stays in its file; temporary files, unless it is a binary STL file, in ${streaming.spool}\n"
        } else {
            "disk: the output only\n"
        }
        return limit + plan.explain() + disk
    }

    private fun held(): Long {
        // Twice: objects that the first collection makes unreachable are free only after the second
        repeat(2) { System.gc() }
        return Runtime.getRuntime().run { totalMemory() - freeMemory() }
    }

    private companion object {
        /** What the program takes before it reads anything; measured, with a reserve. */
        const val PROGRAM_BYTES = 12L shl 20

        /** Set-up that needs less than this part of the memory is not checked. */
        const val SMALL_PART = 16
    }
}
