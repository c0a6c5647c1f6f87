package dev.lazyz.cli.batch

import dev.lazyz.Renderer
import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.cli.strategies.StrategyChoice
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureParameters
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path

/**
 * Renders all pictures of one input. Reads it once, and holds memory meanwhile: first as much as most files need; if
 * that is too little, it begins again with what the limits permit, and at last with all memory.
 *
 * @param streams where standard input comes from
 */
internal class InputJob(
    private val request: BatchRequest,
    private val plan: BatchPlan,
    private val input: InputPlan,
    private val shares: Shares,
    private val streams: Streams,
) {
    private val shown: ShownInput = request.shown(input.input)
    private var counted = 0

    /** Renders the pictures, and reports what happened. Failures are reported, not thrown. */
    fun run(): InputReport {
        try {
            val usual = StrategyChoice(request.strategy, request.choices.sharing(1)).usual
            val memory = InputMemory(shown, usual, plan, shares.memory.total)
            for (step in memory.steps()) {
                val report = shares.memory.hold(step.bytes) {
                    shares.threads.forInput { attempt(memory, step) }
                }
                if (report != null) return report
            }
            error("the last attempt at ${input.input} has no report")
        } finally {
            while (counted < plan.perInput) count(counted)
        }
    }

    /** Returns the report, or null if it must be tried again with more memory. */
    private fun attempt(memory: InputMemory, step: MemoryStep): InputReport? {
        val messages = ByteArrayOutputStream()
        val own = Streams(streams.input, OutputStream.nullOutputStream(), PrintStream(messages))
        val statistics = StringBuilder()
        val files = ArrayList<Path>()
        var failure: Throwable? = null
        try {
            val source = FrameSource(shown, own, step.loading)
            TimeLimit.OF_INPUT.hold(shown.timeLimit, source.input.name) {
                val loaded = source.load()
                source.requireKept(loaded, plan.replaced)
                val pictures = InputPictures(request, plan, shares, source, loaded, own, ::count) { strategy, shot ->
                    memory.require(step, strategy, shot)
                }
                input.views.forEach { pictures.render(it, statistics, files) }
            }
        } catch (e: InterruptedException) {
            throw e
        } catch (e: Throwable) {
            if (!step.isLast && needsMore(e, step)) return null
            failure = e
        }
        own.flushMessages()
        return InputReport(input.input, messages.toString(), statistics.toString(), files, failure)
    }

    /** Counts the picture with this number of the input as done, once. */
    private fun count(number: Int) {
        if (number < counted) return
        counted = number + 1
        shares.progress.advance()
    }

    /** A file that cannot be read within reduced limits is read again, because the limits may be the reason. */
    private fun needsMore(failure: Throwable, step: MemoryStep): Boolean =
        failure is TooLittleMemory || (failure is SceneFormatException && step.isReduced) ||
            generateSequence(failure) { it.cause }.any { it is OutOfMemoryError }
}

/**
 * What there is to say about an input after it was rendered.
 *
 * @property messages warnings and other text for standard error
 * @property output statistics for standard output
 * @property files the files that were written
 * @property failure why a picture is missing, or null
 */
internal class InputReport(
    val input: String,
    val messages: String,
    val output: String,
    val files: List<Path>,
    val failure: Throwable?,
)

/** Something does not fit into the memory that an input holds. It is tried again with more. */
internal class TooLittleMemory : RuntimeException("more memory is needed than the input holds")

/**
 * An attempt to render an input.
 *
 * @property bytes the memory that it holds
 * @property loading the options for reading the file
 * @property isReduced whether their limits are lower than those of the user
 * @property isLast whether it holds all memory
 */
internal class MemoryStep(val bytes: Long, val loading: LoadOptions, val isReduced: Boolean, val isLast: Boolean)

/**
 * How much of [total] bytes of memory an input needs.
 *
 * @param usual the strategy that most scenes are rendered with
 */
internal class InputMemory(
    private val shown: ShownInput,
    usual: Renderer,
    private val plan: BatchPlan,
    private val total: Long,
) {
    /** The size of the file; 0 for a built-in scene or a missing file, null if it is not known. */
    private val file: Long? =
        if (shown.input == "-") null else Path.of(shown.input).let { if (Files.exists(it)) Files.size(it) else 0 }

    /** Memory for a picture of the usual size. */
    private val guess: Long = run {
        val size = shown.settings.size
        val pixels = shown.settings[PictureParameters.REGION]?.size ?: (size.width.toLong() * size.height)
        val side = shown.settings.factor
        bytes(usual, pixels * side * side, pixels)
    }

    /** Returns the attempts, from the least memory to the [total]. */
    fun steps(): List<MemoryStep> {
        val last = MemoryStep(total, shown.loading, isReduced = false, isLast = true)
        val size = file ?: return listOf(last)
        val own = shown.loading
        val most = own.limits.decodedBytes ?: LoadLimits.defaultDecodedBytes(size)
        val little = minOf(FREE_BYTES + DECODED_PER_BYTE * size, most)
        val reduced = own.withLimits(own.limits.withDecodedBytes(little))
        val steps = listOf(
            MemoryStep(guess, reduced, isReduced = little < most, isLast = false),
            MemoryStep(guess + most, own, isReduced = false, isLast = false),
        )
        return steps.filter { it.bytes < total } + last
    }

    /**
     * Checks whether [shot] can be rendered with [strategy].
     *
     * @throws TooLittleMemory if it needs more than [step] holds
     * @throws Mistake if it needs more than there is
     */
    fun require(step: MemoryStep, strategy: Renderer, shot: PictureFrame) {
        if (!step.isLast && bytes(strategy, shot.frame.region.size, shot.pixels.size) > step.bytes) {
            throw TooLittleMemory()
        }
        Strategies.requireMemory(strategy, shot.frame.region, available = total, aa = shot.factor)
        plan.obstacle(shot.pixels.width, shot.pixels.height)?.let {
            throw Mistake("$it; choose a smaller --size, or -o with .png")
        }
        val collected = plan.collected(shot.pixels.size)
        if (collected > total) {
            val need = Bytes.readable(collected)
            throw Mistake(
                "a GIF of ${plan.frames} frames of ${shot.pixels.width}x${shot.pixels.height} needs $need of memory, " +
                    "and there are ${Bytes.readable(total)}; choose a smaller --size, fewer steps of --turntable, or " +
                    "-o with .png",
            )
        }
    }

    private fun bytes(strategy: Renderer, samples: Long, pixels: Long): Long =
        PICTURE_BYTES + BYTES_PER_BYTE * (file ?: 0) + RenderPlanner.bytesPerSample(strategy) * samples +
            plan.collected(pixels)

    private companion object {
        /** The writer of a PNG file and the tiles of the default strategy need up to this. */
        const val PICTURE_BYTES = 16L shl 20

        /** Meshes take 3 to 10 bytes for each byte of their file until they are rendered. */
        const val BYTES_PER_BYTE = 16L

        /** The part of that which may be decoded data. */
        const val DECODED_PER_BYTE = 4L
        const val FREE_BYTES = 8L shl 20
    }
}
