package dev.lazyz.tiled

/**
 * Large arrays that a rendering leaves to the next one of the same renderer, so that frames that are alike allocate them
 * once. What is in an array that is taken is anything. Thread safe.
 *
 * Source: the pool of segments of Square's okio, for lending memory out instead of giving it up.
 */
internal class ArrayPool {
    private var free = Free()

    /** What the last rendering left, and this one has not yet asked for. */
    private var leftover = Free()

    /** To be called before each rendering: forgets what the last one did not need. */
    @Synchronized
    fun begin() {
        leftover = free
        free = Free()
    }

    /** Returns an array of [size] numbers. */
    @Synchronized
    fun ints(size: Int): IntArray =
        free.ints[size]?.removeLastOrNull() ?: leftover.ints[size]?.removeLastOrNull() ?: IntArray(size)

    /** See [ints]. */
    @Synchronized
    fun longs(size: Int): LongArray =
        free.longs[size]?.removeLastOrNull() ?: leftover.longs[size]?.removeLastOrNull() ?: LongArray(size)

    /** Takes an array back that nobody looks at any longer. */
    @Synchronized
    fun release(array: IntArray) {
        free.ints.getOrPut(array.size) { ArrayList() }.add(array)
    }

    /** See [release]. */
    @Synchronized
    fun release(array: LongArray) {
        free.longs.getOrPut(array.size) { ArrayList() }.add(array)
    }

    /** Arrays by their size. */
    private class Free {
        val ints = HashMap<Int, ArrayList<IntArray>>()
        val longs = HashMap<Int, ArrayList<LongArray>>()
    }

    companion object {
        /** Returns a size that is not less than [least] nor much greater, and one of a few: what frames that differ share. */
        fun roomy(least: Int): Int {
            val step = Integer.highestOneBit(maxOf(least, LEAST)) / PARTS
            return maxOf(least, minOf(((least - 1L) / step + 1) * step, MOST).toInt())
        }

        private const val LEAST = 64

        /** The largest array that a JVM is sure to have. */
        private const val MOST = Int.MAX_VALUE - 8L

        /** Sizes from a power of two to the next. */
        private const val PARTS = 8
    }
}
