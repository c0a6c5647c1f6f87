package dev.lazyz.strategies.tiled.resolve

/**
 * The runs of a tile's visible samples, grouped by primitive. A run consists of adjacent samples on a row that show the
 * same primitive.
 *
 * Primitives are looked up by the lower bits of their indices. A primitive that is evicted by another one starts a new
 * group, so the same primitive may have several groups. Belongs to one thread; reused for each tile.
 */
internal class PrimitiveRuns {
    /** By the lower bits of their indices: recently used primitives, and the result of [find] for each. */
    private val owners = IntArray(SLOTS)
    private val groups = IntArray(SLOTS)
    private val colors = IntArray(SLOTS)

    /** For each group, the primitive's index, the number of samples, and the last run. */
    private var indices = IntArray(CAPACITY)
    private var sizes = IntArray(CAPACITY)
    private var lasts = IntArray(CAPACITY)

    /** Number of groups. */
    var count: Int = 0
        private set

    /**
     * For each run, the place of the first sample (see [place]), the length, and the group's previous run or [NONE].
     */
    private var starts = IntArray(CAPACITY)
    private var lengths = IntArray(CAPACITY)
    private var previous = IntArray(CAPACITY)
    private var runCount = 0

    /** Bytes held. */
    val bytes: Long get() = Int.SIZE_BYTES * (3L * SLOTS + 3L * indices.size + 3L * starts.size)

    /** Begins a tile. */
    fun begin() {
        count = 0
        runCount = 0
        owners.fill(NONE)
    }

    /**
     * Returns the number of a primitive's group, or [CONSTANT] or [ONE_BY_ONE] if it was recorded as such, or [NONE] if
     * unknown.
     */
    fun find(index: Int): Int {
        val slot = index and SLOTS - 1
        return if (owners[slot] == index) groups[slot] else NONE
    }

    /** Records an unknown primitive whose samples are to be collected, and returns the number of its new group. */
    fun note(index: Int): Int {
        if (count == indices.size) {
            indices = indices.copyOf(2 * count)
            sizes = sizes.copyOf(2 * count)
            lasts = lasts.copyOf(2 * count)
        }
        indices[count] = index
        sizes[count] = 0
        lasts[count] = NONE
        return note(index, count++)
    }

    /** Records an unknown primitive all of whose samples have the colour [argb]; returns [CONSTANT]. */
    fun noteConstant(index: Int, argb: Int): Int {
        colors[index and SLOTS - 1] = argb
        return note(index, CONSTANT)
    }

    /** Records an unknown primitive whose samples are shaded one by one; returns [ONE_BY_ONE]. */
    fun noteOneByOne(index: Int): Int = note(index, ONE_BY_ONE)

    private fun note(index: Int, group: Int): Int {
        owners[index and SLOTS - 1] = index
        groups[index and SLOTS - 1] = group
        return group
    }

    /** The colour of a primitive that was recorded as [CONSTANT]. */
    fun color(index: Int): Int = colors[index and SLOTS - 1]

    /** Adds a run to group number [group]. */
    fun add(group: Int, start: Int, length: Int) {
        if (runCount == starts.size) {
            starts = starts.copyOf(2 * runCount)
            lengths = lengths.copyOf(2 * runCount)
            previous = previous.copyOf(2 * runCount)
        }
        starts[runCount] = start
        lengths[runCount] = length
        previous[runCount] = lasts[group]
        sizes[group] += length
        lasts[group] = runCount++
    }

    /** The primitive's index of group number [group]. */
    fun index(group: Int): Int = indices[group]

    /** Number of samples of group number [group]. */
    fun size(group: Int): Int = sizes[group]

    /** Calls [action] for each run of group number [group]. */
    inline fun forEach(group: Int, action: (start: Int, length: Int) -> Unit) {
        var run = lasts[group]
        while (run != NONE) {
            action(starts[run], lengths[run])
            run = previous[run]
        }
    }

    companion object {
        /** No primitive, or an unknown primitive. */
        const val NONE: Int = -1

        /** Instead of a group number: the primitive has one colour. */
        const val CONSTANT: Int = -2

        /** Instead of a group number: the primitive's samples are shaded one by one. */
        const val ONE_BY_ONE: Int = -3

        /** Bits of a column within a tile; a tile has at most 512 columns. */
        private const val COLUMN_BITS = 9

        /** Returns the place of a sample of a tile. */
        fun place(row: Int, column: Int): Int = row shl COLUMN_BITS or column

        /** The row of a place. */
        fun row(place: Int): Int = place ushr COLUMN_BITS

        /** The column of a place. */
        fun column(place: Int): Int = place and (1 shl COLUMN_BITS) - 1

        private const val CAPACITY = 512

        /** Number of primitives in the look-up table, a power of two. */
        private const val SLOTS = 512
    }
}
