package dev.lazyz.cli.render

import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.planning.RenderPlanner.RenderPlan
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.strategies.tiled.TiledRenderer

/**
 * The option `--memory`: plans a rendering of [request] that stays within [allowed] bytes of Java's memory, or refuses
 * it before it begins. What is already in memory is measured after a garbage collection.
 *
 * A step that does not fit into [allowed] bytes is still made if Java has the memory for it: the refusal comes when it
 * is known what the whole rendering needs.
 *
 * @param others what receives the rows of a picture, and what is kept of it
 */
internal class MemoryPlanning(
    private val allowed: Long,
    private val request: RenderRequest,
    private val source: FrameSource,
    private val choice: StrategyChoice,
    private val others: (Region) -> List<RenderPlan.Item>,
) {
    private val heap = Runtime.getRuntime().maxMemory()

    /** Bytes that may be used: not more than Java itself may use. */
    val memory: Long = minOf(allowed, heap)
    private val advice = MemoryAdvice(request, allowed, memory)

    /** What the steps so far need, at least. */
    private var least = 0L

    /** The first step that does not fit. */
    private var shortage: Shortage? = null

    private val format = source.input.statedFormat

    /** What reading the model as a whole needs, or 0 if that is unknown. */
    private val readingNeed: Long =
        source.input.fileBytes?.let { PROGRAM_BYTES + Scenes.leastMemory(format, it) } ?: 0

    /** Whether the model can be read part by part with the other options. */
    private val canStream: Boolean
        get() = request.streamingForMemory.isPossible(request, choice)

    /** Whether the picture is the same if the model is read part by part. */
    private val isSameInParts: Boolean
        get() = format == SceneFormat.STL && request.shown.settings.hasFaceNormals && canStream

    /**
     * Returns how to read the model: null for as a whole, if it fits, or if its need is unknown; or part by part, if
     * the picture is the same.
     *
     * @throws MemoryRefusal if the model does not fit
     */
    fun streaming(): StreamRequest? {
        if (readingNeed > memory && isSameInParts) return request.streamingForMemory
        recordReading()
        return null
    }

    private fun recordReading() {
        val need = readingNeed
        if (need > 0) record("reading ${source.input.name}", need, need - need / RESERVE_PART)
    }

    /** The limits for reading the model as a whole. */
    val loading: LoadOptions
        get() = with(request.shown.loading) { withLimits(limits.withMemory(maxOf(memory, least))) }

    /**
     * Whether the model can be read in the other way, as a whole or part by part, and perhaps with less memory, after
     * [refusal] of reading it as [streaming] says. Prepares for that.
     */
    fun hasOtherWay(streaming: StreamRequest?, refusal: MemoryRefusal): Boolean {
        if (!isSameInParts) return false
        if (streaming != null && (readingNeed > heap || readingNeed >= (refusal.enough ?: Long.MAX_VALUE))) return false
        least = 0
        shortage = null
        if (streaming != null) recordReading()
        return true
    }

    /** Calls [prepare], which reads and sets up all that a rendering needs. */
    fun <T> preparing(prepare: () -> T): T = try {
        prepare()
    } catch (full: OutOfMemoryError) {
        throw exhausted()
    } catch (refused: SceneFormatException) {
        throw if (refused.cause is OutOfMemoryError) exhausted() else refused
    }

    private fun exhausted(): MemoryRefusal {
        val unknown = Shortage("reading and setting up ${source.input.name}", null)
        return advice.refusal(shortage ?: unknown, if (shortage == null) Enough(null) else estimate())
    }

    /**
     * Checks that [loaded] can be set up.
     *
     * @throws MemoryRefusal otherwise
     */
    fun requireSetUp(loaded: LoadedScene) {
        val setUp = loaded.scene.setUpBytes

        // Small scenes need no look at the memory, which takes time
        if (setUp < memory / SMALL_PART) return
        val bytes = held() + setUp
        record("setting up ${source.input.name}", RenderPlan.leastMemory(bytes), bytes)
    }

    /** Records a step that needs [need] bytes, and refuses it if Java does not even have the [bytes] of its objects. */
    private fun record(what: String, need: Long, bytes: Long) {
        least = maxOf(least, need)
        if (need <= memory) return
        val first = shortage ?: Shortage(what, need, format.takeIf { canStream })
        shortage = first
        if (bytes > heap) throw advice.refusal(first, estimate())
    }

    /**
     * Returns the plan for [shot], with the first strategy that fits.
     *
     * @throws MemoryRefusal if none fits, or if an earlier step did not fit
     */
    fun plan(shot: PictureFrame): RenderPlan {
        val program = RenderPlan.Item("program, scene and primitives", held())
        val all = listOf(program) + others(shot.pixels)
        val plan = plan(shot, all, memory)
        val short = shortage
        if (short != null) throw advice.refusal(short, Enough(enough(shot, all)))
        if (plan.fits) return plan

        // Would a picture of one pixel fit?
        val corner = with(shot.pixels) { Region(columnStart, rowStart, columnStart + 1, rowStart + 1) }
        val smallest = plan(shot.within(corner), listOf(program), memory)
        val picture = Shortage("the picture", plan.leastMemory)
        throw advice.refusal(picture, Enough(enough(shot, all)), plan, canShrink = smallest.fits)
    }

    private fun plan(shot: PictureFrame, items: List<RenderPlan.Item>, bytes: Long): RenderPlan =
        shot.plan(
            RenderPlanner(bytes, request.choices.forFrame(shot.frame).options()),
            choice.rendererChoices(shot.frame, bytes),
            items,
        )

    /** Returns the memory with which [shot] can be rendered, besides [items], after the steps so far. */
    private fun enough(shot: PictureFrame, items: List<RenderPlan.Item>): Long {
        // With more memory, another plan may be the first
        var bytes = least
        while (true) {
            val plan = plan(shot, items, bytes)
            if (plan.fits) return bytes
            bytes = plan.leastMemory
        }
    }

    /** Estimates the memory that is enough by the size of the file, or returns that it is not known. */
    private fun estimate(): Enough {
        val file = source.input.fileBytes ?: return Enough(null)
        val blank = source.blank(request.choices.options())
        val drawing = when {
            choice.usual !is TiledRenderer -> OTHERS_PER_BYTE
            format in MESHES -> MESH_PER_BYTE
            else -> COMPACT_PER_BYTE
        }
        val model = RenderPlan.Item("program, scene and primitives", least - least / RESERVE_PART + file * drawing)
        return Enough(enough(blank, listOf(model) + others(blank.pixels)), isEstimate = true)
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

        /** Part of the memory for reading that is a reserve, one in so many. */
        const val RESERVE_PART = 4

        /** About what set-up and drawing take for each byte of a file of [MESHES], with `tiled`; measured. */
        const val MESH_PER_BYTE = 3L

        /** The same for other formats, whose meshes take fewer bytes. */
        const val COMPACT_PER_BYTE = 8L

        /** The same for strategies that need an object for each triangle. */
        const val OTHERS_PER_BYTE = 96L

        val MESHES = setOf(SceneFormat.STL, SceneFormat.PLY, SceneFormat.OBJ, SceneFormat.OFF)

        /** Set-up that needs less than this part of the memory is not checked. */
        const val SMALL_PART = 16
    }
}

/**
 * A step of a rendering that does not fit into memory.
 *
 * @property what what does not fit
 * @property need how many bytes it needs, if that is known
 * @property streamed the format of the model, if it can be read part by part, and is not yet
 */
internal class Shortage(val what: String, val need: Long?, val streamed: SceneFormat? = null)

/**
 * The memory with which a whole rendering fits.
 *
 * @property bytes the bytes, or null if that is not known
 * @property isEstimate whether it is not measured, but estimated by the size of the model
 */
internal class Enough(val bytes: Long?, val isEstimate: Boolean = false)

/** The mistake that a rendering does not fit into memory. [enough] bytes would do, if that is known. */
internal class MemoryRefusal(message: String, val enough: Long?) : Mistake(message)

/**
 * What to do if a rendering of [request] does not fit into memory.
 *
 * @param allowed the bytes of `--memory`
 * @param memory the bytes of them that can be used
 */
internal class MemoryAdvice(private val request: RenderRequest, private val allowed: Long, private val memory: Long) {
    /** Whether Java was started with less memory than `--memory` allows, and not only keeps a part for itself. */
    private val isHeapSmaller = memory < allowed / 4 * 3

    /**
     * Returns the mistake to report.
     *
     * @param shortage the first step that does not fit
     * @param plan the plan that needs the least, if there is one
     * @param canShrink whether a smaller picture would fit
     */
    fun refusal(
        shortage: Shortage,
        enough: Enough,
        plan: RenderPlan? = null,
        canShrink: Boolean = false,
    ): MemoryRefusal {
        val verb = if (shortage.need == null) "needs more" else "needs ${Bytes.readable(shortage.need + TENTH)}"
        val usable = Bytes.readable(memory)
        val limit = when {
            isHeapSmaller -> "and Java was started with only $usable (-Xmx)"
            memory < allowed -> "and --memory allows $usable (${Bytes.readable(allowed)} less a reserve)"
            else -> "and --memory allows $usable"
        }
        val steps = "${larger(enough)}${stream(shortage.streamed)}${smaller(canShrink)}"
        val text = "${shortage.what} $verb, $limit\n${plan?.explain().orEmpty()}$steps See 'zcli render --help'."
        return MemoryRefusal(text, enough.bytes)
    }

    private fun larger(enough: Enough): String {
        val amount = enough.bytes?.let { "${((it + it / MARGIN) shr 20) + SLACK}m" }
        val origin = if (enough.isEstimate) ", an estimate by the size of the model" else ""
        return when {
            isHeapSmaller && amount != null -> "Start Java with -Xmx$amount, and use --memory $amount$origin."
            isHeapSmaller -> "Start Java with a larger -Xmx, and use a larger --memory."
            amount != null -> "Use --memory $amount$origin."
            else -> "Use a larger --memory; how much is enough is not known."
        }
    }

    /** With the parts that a model is read in, most models need less memory. */
    private fun stream(format: SceneFormat?): String =
        StreamRequest.loss(format)?.let { " Or add --stream; $it." }.orEmpty()

    private fun smaller(canShrink: Boolean): String {
        if (!canShrink) return ""
        val ways = listOfNotNull(
            "a smaller --size", "a --region",
            "--aa 1".takeIf { request.shown.settings.run { factor > 1 && !hasOcclusion } },
            "a .ppm file".takeIf { request.output?.endsWith(".ppm") == false },
        )
        return " These need less: ${ways.dropLast(1).joinToString()} or ${ways.last()}."
    }

    private companion object {
        /** Rounds up in the tenths of a mebibyte that are printed. */
        const val TENTH = (1L shl 20) / 10

        /**
         * The memory that is named is larger than what was found to be enough by one part in so many, and mebibytes:
         * what is in memory is measured again, and varies.
         */
        const val MARGIN = 16
        const val SLACK = 3
    }
}
