package dev.lazyz.strategies.tiled.binning

/**
 * Large arrays that a rendering leaves to the next one of the same renderer, so that frames that are alike allocate them
 * once. What is in an array that is taken is anything. Thread safe.
 *
 * Source: the pool of segments of Square's okio, for lending memory out instead of giving it up.
 */
internal class ArrayPool {
    private val ints = Shelf(::IntArray)
    private val longs = Shelf(::LongArray)

    /** To be called before each rendering: forgets what the last one did not need. */
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

    /** Takes an array back that nobody looks at any longer. */
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

        /** What the last rendering left, and this one has not yet asked for. */
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
