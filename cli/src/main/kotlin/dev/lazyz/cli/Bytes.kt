package dev.lazyz.cli

/** Amounts of memory, for people. */
internal object Bytes {
    private val units = listOf("bytes", "KiB", "MiB", "GiB", "TiB")

    /** Returns [bytes] in the largest unit that leaves at least 1, with one decimal: `5.9 GiB`. */
    fun readable(bytes: Long): String {
        var unit = 0
        var tenths = bytes * 10
        while (tenths >= 10 * 1024 && unit < units.size - 1) {
            tenths /= 1024
            unit++
        }
        return if (unit == 0) "$bytes bytes" else "${tenths / 10}.${tenths % 10} ${units[unit]}"
    }
}
