package dev.lazyz.strategies.tiled.resolve

/**
 * The runs of a tile's visible samples, primitive by primitive: neighbours on a row that show the same primitive are a run.
 *
 * Primitives are told apart by the lower bits of their indices, and a primitive that another one has driven out begins again:
 * so it may come more than once. Belongs to one thread; used for tile after tile.
 */
internal class PrimitiveRuns {
    /** By the lower bits of their indices: the primitives lately met, and what stands for each, see [find]. */
    private val owners = IntArray(SLOTS)
    private val groups = IntArray(SLOTS)
    private val colors = IntArray(SLOTS)

    /** Of each primitive its index, number of samples, and last run. */
    private var indices = IntArray(CAPACITY)
    private var sizes = IntArray(CAPACITY)
    private var lasts = IntArray(CAPACITY)

    /** Number of primitives that have runs. */
    var count: Int = 0
        private set

    /** Runs: place of the first sample, see [place], length, and the same primitive's run before it or [NONE]. */
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

    /** Returns the number of a primitive, [CONSTANT] or [APART] if it was noted as that, or [NONE] if it is not known. */
    fun find(index: Int): Int {
        val slot = index and SLOTS - 1
        return if (owners[slot] == index) groups[slot] else NONE
    }

    /** Notes a primitive that is not known, whose samples are to be gathered, and returns its number. */
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

    /** Notes a primitive that is not known, all of whose samples have the colour [argb]; returns [CONSTANT]. */
    fun noteConstant(index: Int, argb: Int): Int {
        colors[index and SLOTS - 1] = argb
        return note(index, CONSTANT)
    }

    /** Notes a primitive that is not known, whose samples are to be coloured one by one; returns [APART]. */
    fun noteApart(index: Int): Int = note(index, APART)

    private fun note(index: Int, group: Int): Int {
        owners[index and SLOTS - 1] = index
        groups[index and SLOTS - 1] = group
        return group
    }

    /** The colour of a primitive that was noted as [CONSTANT]. */
    fun color(index: Int): Int = colors[index and SLOTS - 1]

    /** Adds a run of primitive number [group]. */
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

    /** The index of primitive number [group]. */
    fun index(group: Int): Int = indices[group]

    /** Number of samples of primitive number [group]. */
    fun size(group: Int): Int = sizes[group]

    /** Calls [action] for each run of primitive number [group]. */
    inline fun forEach(group: Int, action: (start: Int, length: Int) -> Unit) {
        var run = lasts[group]
        while (run != NONE) {
            action(starts[run], lengths[run])
            run = previous[run]
        }
    }

    companion object {
        /** No primitive, or none that is known. */
        const val NONE: Int = -1

        /** In place of the number of a primitive that has one colour. */
        const val CONSTANT: Int = -2

        /** In place of the number of a primitive whose samples are coloured one by one. */
        const val APART: Int = -3

        /** Bits of a column in a tile, which is at most 512. */
        private const val COLUMN_BITS = 9

        /** Returns the place of a sample of a tile. */
        fun place(row: Int, column: Int): Int = row shl COLUMN_BITS or column

        /** The row of a place. */
        fun row(place: Int): Int = place ushr COLUMN_BITS

        /** The column of a place. */
        fun column(place: Int): Int = place and (1 shl COLUMN_BITS) - 1

        private const val CAPACITY = 512

        /** Primitives that are told apart, a power of two. */
        private const val SLOTS = 512
    }
}
