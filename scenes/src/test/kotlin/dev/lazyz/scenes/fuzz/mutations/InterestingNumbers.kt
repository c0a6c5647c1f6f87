package dev.lazyz.scenes.fuzz.mutations

/** Numbers at which code likes to break: the ends of types, and what is just behind them. */
internal object InterestingNumbers {
    val whole: List<Long> = listOf(0L, 1, -1, 2, 3, 4, 5, 7, 8, 16, 64, 100) +
        listOf(7, 8, 15, 16, 24, 30, 31, 32, 33, 40, 53).flatMap { bits ->
            listOf(-1L shl bits, (1L shl bits) - 1, 1L shl bits)
        } + listOf(
            Long.MAX_VALUE, Long.MIN_VALUE,
            // A third, a fourth, a twelfth of all that an Int can count
            715_827_883L, 1_073_741_825, 357_913_942,
            // Component types and the like of glTF
            5120, 5121, 5122, 5123, 5125, 5126, 9728, 9987, 33_071, 33_648, 10_497,
        )

    val floats: List<Float> = listOf(
        0f, -0f, 1f, -1f, 0.5f, 1e-30f, 1e30f, -1e30f, 1e9f, 1e15f, 16_777_217f, Float.MIN_VALUE, Float.MAX_VALUE,
        -Float.MAX_VALUE, Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY,
    )

    val words: List<String> = whole.map { it.toString() } + listOf(
        "-0", "+1", "0.5", "-0.5", "1.5", "1e400", "-1e400", "1e-400", "1e38", "3.5e38", "1e308", "4.9e-324",
        "1e2147483648",
        "nan", "NaN", "inf", "-Infinity", "1,5", ".5", "5.", ".", "-", "+", "e", "1e", "0x10", "0x1p3", "1_000",
        "1f", "1d",
        "00000000000000000000000000000001", "123456789012345678901234567890", "0." + "0".repeat(400) + "1",
    )
}
