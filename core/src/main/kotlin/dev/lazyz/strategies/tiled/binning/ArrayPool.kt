package dev.lazyz.strategies.tiled.binning

/**
 * Large arrays that a rendering leaves to the next one of the same renderer, so that similar frames allocate them only
 * once. The content of an array from the pool is undefined. Thread safe.
 *
 * Source: the pool of segments of Square's okio, for reusing memory instead of freeing it.
 */
internal class ArrayPool {
    private val ints = Shelf(::IntArray)
    private val longs = Shelf(::LongArray)

    /** Must be called before each rendering: drops the arrays that the last rendering did not use. */
    @Synchronized
    fun begin() {
        ints.begin()
        longs.begin()
    }

    /** Returns an array of [size] numbers. */
    @Synchronized
    fun ints(size: Int): IntArray = ints.take(size)

    /** See [ints]. */
    @Synchronized
    fun longs(size: Int): LongArray = longs.take(size)

    /** Returns an array to the pool. It must no longer be used. */
    @Synchronized
    fun release(array: IntArray) {
        ints.put(array.size, array)
    }

    /** See [release]. */
    @Synchronized
    fun release(array: LongArray) {
        longs.put(array.size, array)
    }

    /** Arrays of one type, by their size. */
    private class Shelf<A : Any>(private val make: (size: Int) -> A) {
        private var free = HashMap<Int, ArrayList<A>>()

        /** Arrays that the last rendering left, and this one has not yet taken. */
        private var leftover = HashMap<Int, ArrayList<A>>()

        fun begin() {
            leftover = free
            free = HashMap()
        }

        fun take(size: Int): A = free[size]?.removeLastOrNull() ?: leftover[size]?.removeLastOrNull() ?: make(size)

        fun put(size: Int, array: A) {
            free.getOrPut(size) { ArrayList() }.add(array)
        }
    }

    companion object {
        /**
         * Returns a size that is at least [least] and slightly greater at most. There are only a few such sizes, so
         * different frames can share arrays.
         */
        fun roomy(least: Int): Int {
            val step = Integer.highestOneBit(maxOf(least, LEAST)) / PARTS
            return maxOf(least, minOf(((least - 1L) / step + 1) * step, MOST).toInt())
        }

        private const val LEAST = 64

        /** The largest array size that every JVM supports. */
        private const val MOST = Int.MAX_VALUE - 8L

        /** Number of sizes from a power of two to the next. */
        private const val PARTS = 8
    }
}
