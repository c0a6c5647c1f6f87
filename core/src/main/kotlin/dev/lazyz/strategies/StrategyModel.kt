package dev.lazyz.strategies

import dev.lazyz.Primitive
import dev.lazyz.RenderOptions

/**
 * What strategies take for a frame, by a model that was fitted to measurements (`docs/growth.md`): times and bytes are
 * sums of [timeTerms] and [memoryTerms], each times a coefficient of the strategy's own, none negative.
 *
 * Times are those of a warm JVM on the machine that was measured, set-up included. On another machine trust their
 * ratios, and those roughly. Thread safe.
 */
public object StrategyModel {
    /**
     * How far the model is trusted: another renderer than the usual one is chosen only if it is expected to be at least so many
     * times as fast.
     */
    public const val DOUBT: Double = 1.5

    /** What [timeTerms] are. */
    @JvmStatic
    public val timeTermNames: List<String> = listOf(
        "frame", "primitives", "primitive rows", "samples", "fragments", "late colours", "early colours",
    )

    /** What [memoryTerms] are. */
    @JvmStatic
    public val memoryTermNames: List<String> =
        listOf("frame", "columns", "samples", "primitives", "primitives a row", "fragments a row")

    /** Returns the numbers that times are sums of. */
    @JvmStatic
    public fun timeTerms(numbers: FrameNumbers): DoubleArray {
        // A sample's nearest fragment so far changes at one of two, of three, ... that come in random order
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

    /** Returns the numbers that bytes are sums of. */
    @JvmStatic
    public fun memoryTerms(numbers: FrameNumbers): DoubleArray = doubleArrayOf(
        1.0,
        numbers.columns.toDouble(),
        numbers.samples,
        numbers.primitives.toDouble(),
        numbers.primitiveRows / numbers.rows,
        numbers.fragments / numbers.rows,
    )

    /**
     * Returns how long the strategy called [id] takes for a frame with these [numbers] on so many [threads], milliseconds; NaN
     * if it was never measured.
     */
    @JvmStatic
    @JvmOverloads
    public fun milliseconds(id: String, numbers: FrameNumbers, threads: Int = 1): Double {
        val coefficients = StrategyCosts.nanoseconds[id] ?: return Double.NaN
        val alone = sum(coefficients, timeTerms(numbers)) / NANOS
        val serial = StrategyCosts.serialShares[id] ?: return alone
        return alone * (serial + (1.0 - serial) / minOf(threads, Runtime.getRuntime().availableProcessors()))
    }

    /**
     * Returns the most bytes that the strategy called [id] holds while it renders a frame with these [numbers]: working memory
     * and, unless it draws meshes from their arrays, the primitives that their triangles become. Neither the scene nor the
     * picture. NaN if it was never measured.
     *
     * @param budget a [RenderOptions.memoryBudget] that the strategy keeps to, or null
     */
    @JvmStatic
    @JvmOverloads
    public fun bytes(id: String, numbers: FrameNumbers, budget: Long? = null): Double {
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

    /** What [Primitive.heldBytes] says of a triangle. */
    private const val PRIMITIVE_BYTES = 256.0

    /** A sample of the image that a budget does not count: colour, depth and primitive. */
    private const val IMAGE_BYTES = 12.0

    /** Strategies to which triangles of meshes are no objects. */
    private val fromArrays = setOf("tiled")
}
