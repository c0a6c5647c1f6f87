package dev.lazyz.strategies.tiled.binning

import dev.lazyz.bytes

/** Keys that are sorted approximately from near to far. Belongs to one thread; reusable. */
internal class NearToFar {
    /** The keys in order of arrival, and sorted. */
    private var keys = LongArray(CAPACITY)
    private var sorted = LongArray(CAPACITY)
    private val ends = IntArray(BUCKETS + 1)

    /** Number of keys. */
    var count: Int = 0
        private set

    /** Bytes held. */
    val bytes: Long get() = keys.bytes + sorted.bytes + ends.bytes

    /** Adds a key. */
    fun add(key: Long) {
        if (count == keys.size) keys = keys.copyOf(2 * count)
        keys[count++] = key
    }

    /** Adds all keys of [other]. */
    fun addAll(other: NearToFar) {
        if (count + other.count > keys.size) keys = keys.copyOf(count + other.count)
        System.arraycopy(other.keys, 0, keys, count, other.count)
        count += other.count
    }

    /** Restarts with [count] keys; the caller must fill them into the returned array. */
    fun begin(count: Int): LongArray {
        if (count > keys.size) keys = LongArray(count + count / 4)
        this.count = count
        return keys
    }

    /** Sorts the keys with a counting sort by the uppermost bits in which they differ. */
    fun sort() {
        if (sorted.size < keys.size) sorted = LongArray(keys.size)
        var least = Long.MAX_VALUE
        var most = Long.MIN_VALUE
        for (i in 0 until count) {
            least = minOf(least, keys[i])
            most = maxOf(most, keys[i])
        }
        val shift = maxOf(0, Long.SIZE_BITS - java.lang.Long.numberOfLeadingZeros(most - least) - BUCKET_BITS)
        ends.fill(0)
        for (i in 0 until count) ends[((keys[i] - least) ushr shift).toInt() + 1]++
        for (bucket in 0 until BUCKETS) ends[bucket + 1] += ends[bucket]
        for (i in 0 until count) sorted[ends[((keys[i] - least) ushr shift).toInt()]++] = keys[i]
    }

    /** Returns key number [i] in sorted order. */
    operator fun get(i: Int): Long = sorted[i]

    private companion object {
        const val CAPACITY = 64
        const val BUCKET_BITS = 8
        const val BUCKETS = 1 shl BUCKET_BITS
    }
}
