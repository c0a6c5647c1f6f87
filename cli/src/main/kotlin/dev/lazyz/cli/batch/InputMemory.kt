package dev.lazyz.cli.batch

import dev.lazyz.Renderer
import dev.lazyz.cli.input.Subject
import dev.lazyz.cli.output.Bytes
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.strategies.Strategies
import dev.lazyz.planning.RenderPlanner
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.pictures.PictureFrame
import dev.lazyz.scenes.pictures.PictureParameters
import java.nio.file.Files
import java.nio.file.Path

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
    private val subject: Subject,
    usual: Renderer,
    private val plan: BatchPlan,
    private val total: Long,
) {
    /** The size of the file; 0 for a built-in scene or a missing file, null if it is not known. */
    private val file: Long? =
        if (subject.input == "-") null else Path.of(subject.input).let { if (Files.exists(it)) Files.size(it) else 0 }

    /** Memory for a picture of the usual size. */
    private val guess: Long = run {
        val size = subject.settings.size
        val pixels = subject.settings[PictureParameters.REGION]?.size ?: (size.width.toLong() * size.height)
        val side = subject.settings.factor
        bytes(usual, pixels * side * side, pixels)
    }

    /** Returns the attempts, from the least memory to the [total]. */
    fun steps(): List<MemoryStep> {
        val last = MemoryStep(total, subject.loading, isReduced = false, isLast = true)
        val size = file ?: return listOf(last)
        val own = subject.loading
        val most = own.limits.decodedBytes ?: LoadLimits.defaultDecodedBytes(size)
        val little = minOf(FREE_BYTES + DECODED_PER_BYTE * size, most)
        val reduced = LoadOptions(own.limits.withDecodedBytes(little), own.animationTime, own.smoothNormals)
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
