package dev.lazyz.strategies

/**
 * A model of the time that strategies need for a frame, fitted to measurements (`docs/growth.md`): a sum of
 * [timeTerms], each multiplied by a non-negative coefficient that depends on the strategy. Memory is in
 * [StrategyMemory].
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

    /** Returns the sum of [terms], each multiplied by its coefficient. */
    fun sum(coefficients: DoubleArray, terms: DoubleArray): Double {
        var sum = 0.0
        for (i in terms.indices) sum += coefficients[i] * terms[i]
        return sum
    }

    private const val NANOS = 1e6
}
