package dev.lazyz.strategies

/**
 * Coefficients of [StrategyModel], fitted to `docs/growth/results.json` by the command that measured it. Generated: not to
 * be edited.
 */
internal object StrategyCosts {
    /** Nanoseconds for each of [StrategyModel.timeTermNames]. */
    val nanoseconds: Map<String, DoubleArray> = mapOf(
        "tiled" to doubleArrayOf(10900.0, 348.0, 1.59, 13.6, 0.0, 1.08, 0.0),
        "zbuffer" to doubleArrayOf(0.0, 622.0, 36.7, 11.6, 2.42, 0.0, 19.8),
        "lazy" to doubleArrayOf(0.0, 546.0, 132.0, 12.1, 0.161, 20.2, 0.0),
        "flow" to doubleArrayOf(0.0, 808.0, 105.0, 12.4, 0.208, 19.2, 0.0),
        "hybrid" to doubleArrayOf(0.0, 306.0, 143.0, 10.5, 4.03, 17.5, 0.0),
        "lists" to doubleArrayOf(0.0, 486.0, 121.0, 10.5, 4.49, 17.1, 0.0),
        "scanline" to doubleArrayOf(0.0, 1160.0, 102.0, 15.0, 0.0, 18.8, 0.0),
        "painter" to doubleArrayOf(0.0, 717.0, 62.2, 0.0, 33.7, 0.0, 26.9),
        "warnock" to doubleArrayOf(0.0, 286.0, 186.0, 4.99, 0.0, 22.6, 0.0),
        "hierarchical" to doubleArrayOf(0.0, 940.0, 14.2, 12.7, 0.0, 24.7, 0.0),
    )

    /** Bytes for each of [StrategyModel.memoryTermNames]. */
    val bytes: Map<String, DoubleArray> = mapOf(
        "tiled" to doubleArrayOf(112000.0, 888.0, 0.0, 9.59, 991.0, 0.0),
        "zbuffer" to doubleArrayOf(0.0, 0.0, 12.0, 0.0, 0.0, 0.0),
        "lazy" to doubleArrayOf(2200.0, 16.9, 2.61E-4, 9.29, 446.0, 0.0),
        "flow" to doubleArrayOf(1590.0, 18.2, 1.67E-4, 9.32, 294.0, 0.0),
        "hybrid" to doubleArrayOf(0.0, 0.0, 13.2, 44.8, 196.0, 0.0),
        "lists" to doubleArrayOf(1070.0, 31.9, 0.00186, 7.45, 69.4, 7.72),
        "scanline" to doubleArrayOf(2650.0, 9.31, 2.09E-4, 9.15, 469.0, 0.0),
        "painter" to doubleArrayOf(0.0, 0.0, 8.25, 184.0, 0.0, 0.132),
        "warnock" to doubleArrayOf(0.0, 478.0, 0.0, 98.3, 695.0, 2.37),
        "hierarchical" to doubleArrayOf(61.3, 12.1, 8.18, 8.0, 0.0, 0.0),
    )

    /** The part of the time that threads do not share. */
    val serialShares: Map<String, Double> = mapOf("tiled" to 0.249)
}
