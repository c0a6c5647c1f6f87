package dev.lazyz.conformance.strangers4

/**
 * The translucent fragments of a tile that lie before what is opaque, sorted by sample, and each sample's by key.
 *
 * @param opaque the key of the nearest opaque fragment of each sample
 */
internal class TileVeils(private val opaque: LongArray, private val mistake: Mistake?) {
    private var samples = IntArray(16)
    private var keys = LongArray(16)
    private var sorted = LongArray(0)
    private val ends = IntArray(opaque.size + 1)

    var count: Int = 0
        private set

    val bytes: Long get() = 4L * (samples.size + ends.size) + 8L * (keys.size + sorted.size)

    fun clear() {
        count = 0
        ends.fill(0)
    }

    /** Adds a fragment if it is before what is opaque; returns whether it is. */
    fun add(at: Int, key: Long): Boolean {
        val isBefore =
            if (mistake == Mistake.TILE_VEIL_TIE_LOST) key ushr 32 < opaque[at] ushr 32 else key < opaque[at]
        if (!isBefore) return false
        if (count == keys.size) {
            samples = samples.copyOf(2 * count)
            keys = keys.copyOf(2 * count)
        }
        samples[count] = at
        keys[count++] = key
        return true
    }

    /** Sorts what has been added to a tile of [size] samples. */
    fun sort(size: Int) {
        if (count == 0) return
        if (sorted.size < count) sorted = LongArray(keys.size)
        for (i in 0 until count) ends[samples[i] + 1]++
        for (at in 0 until size) ends[at + 1] += ends[at]

        // Place backward, so that ends become starts and fragments keep their order
        for (i in count - 1 downTo 0) sorted[--ends[samples[i] + 1]] = keys[i]
        for (at in 0 until size) ends[at] = ends[at + 1]
        ends[size] = count
        for (at in 0 until size) sortSample(ends[at], ends[at + 1])
    }

    fun start(at: Int): Int = ends[at]

    fun end(at: Int): Int = ends[at + 1]

    fun key(i: Int): Long = sorted[i]

    private fun sortSample(from: Int, until: Int) {
        if (until - from < 2) return
        if (mistake != Mistake.TILE_VEILS_BY_DEPTH) {
            sorted.sort(from, until)
            return
        }
        for (i in from + 1 until until) {
            val key = sorted[i]
            var at = i
            while (at > from && sorted[at - 1] ushr 32 > key ushr 32) {
                sorted[at] = sorted[at - 1]
                at--
            }
            sorted[at] = key
        }
    }
}
