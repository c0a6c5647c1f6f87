package dev.lazyz.strategies

import dev.lazyz.Primitive
import dev.lazyz.RenderOptions

/**
 * A model of the time and memory that strategies need for a frame, fitted to measurements (`docs/growth.md`). Time is a
 * sum of [timeTerms] and memory is a sum of [memoryTerms]; each term is multiplied by a non-negative coefficient that
 * depends on the strategy.
 *
 * Times include set-up and are those of a warm JVM on the machine of the measurements. On other machines only the
 * ratios of times are meaningful, and only roughly. Thread safe.
 */
internal object StrategyModel {
    /** The names of the [timeTerms]. */
    @JvmStatic
    val timeTermNames: List<String> = listOf(
        "frame", "primitives", "primitive rows", "samples", "fragments", "late colours", "early colours",
    )

    /** The names of the [memoryTerms]. */
    @JvmStatic
    val memoryTermNames: List<String> =
        listOf("frame", "columns", "samples", "primitives", "primitives a row", "fragments a row")

    /** Returns the terms of the time. */
    @JvmStatic
    fun timeTerms(numbers: FrameNumbers): DoubleArray {
        // In random order, the k-th fragment of a sample is the nearest so far with probability 1/k
        val changes = 1.0 + StrictMath.log(maxOf(1.0, numbers.depthComplexity))
        return doubleArrayOf(
            1.0,
            numbers.primitives.toDouble(),
            numbers.primitiveRows,
            numbers.samples,
            numbers.fragments,
            numbers.visible * numbers.shadingCost,
            numbers.visible * numbers.shadingCost * changes,
        )
    }

    /** Returns the terms of the memory. */
    @JvmStatic
    fun memoryTerms(numbers: FrameNumbers): DoubleArray = doubleArrayOf(
        1.0,
        numbers.columns.toDouble(),
        numbers.samples,
        numbers.primitives.toDouble(),
        numbers.primitiveRows / numbers.rows,
        numbers.fragments / numbers.rows,
    )

    /**
     * Returns the milliseconds that the strategy [id] needs for a frame with these [numbers] on this many [threads], or
     * NaN if it was never measured.
     */
    @JvmStatic
    @JvmOverloads
    fun milliseconds(id: String, numbers: FrameNumbers, threads: Int = 1): Double {
        val coefficients = StrategyCosts.nanoseconds[id] ?: return Double.NaN
        val alone = sum(coefficients, timeTerms(numbers)) / NANOS
        val serial = StrategyCosts.serialShares[id] ?: return alone
        return alone * (serial + (1.0 - serial) / minOf(threads, Runtime.getRuntime().availableProcessors()))
    }

    /**
     * Returns the peak number of bytes that the strategy [id] holds while it renders a frame with these [numbers], or
     * NaN if it was never measured. This is the working memory and, unless the strategy draws meshes directly from
     * their arrays, the primitives created for their triangles. It does not include the scene or the picture.
     *
     * @param budget a [RenderOptions.memoryBudget] that the strategy observes, or null
     */
    @JvmStatic
    @JvmOverloads
    fun bytes(id: String, numbers: FrameNumbers, budget: Long? = null): Double {
        val coefficients = StrategyCosts.bytes[id] ?: return Double.NaN
        val primitives = if (id in fromArrays) 0.0 else PRIMITIVE_BYTES * numbers.primitives
        val working = sum(coefficients, memoryTerms(numbers))
        val most = if (budget == null) working else minOf(working, budget + IMAGE_BYTES * numbers.samples)
        return most + primitives
    }

    private fun sum(coefficients: DoubleArray, terms: DoubleArray): Double {
        var sum = 0.0
        for (i in terms.indices) sum += coefficients[i] * terms[i]
        return sum
    }

    private const val NANOS = 1e6

    /** The [Primitive.heldBytes] of a triangle. */
    private const val PRIMITIVE_BYTES = 256.0

    /** Bytes of one sample of the image, which a budget does not count: colour, depth and primitive. */
    private const val IMAGE_BYTES = 12.0

    /** Strategies that do not create an object for each triangle of a mesh. */
    private val fromArrays = setOf("tiled")
}
