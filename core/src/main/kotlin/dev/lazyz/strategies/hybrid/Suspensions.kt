package dev.lazyz.strategies.hybrid

import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.bytes
import dev.lazyz.setup.sharedVertices
import dev.lazyz.shading.Vertices

/** Whether keeping a primitive costs memory. */
internal enum class PrimitiveCost {
    /** No: the frame keeps all primitives anyway. */
    NONE,

    /** Yes: a primitive that is not kept here becomes garbage. */
    HELD,
}

/**
 * The records of all primitives with suspended colours, with accounting of their bytes.
 *
 * Every array and object that grows with the suspensions is counted before it is allocated, and no longer counted once
 * it is dropped. While an array is replaced with a longer one, both are counted.
 *
 * @param budget most bytes at any time
 * @param bytes bytes in use from the start
 */
internal class Suspensions(private val budget: Long, private var bytes: Long, private val cost: PrimitiveCost) {
    private val reserved = bytes

    /** Records by slot. Null as long as there are no records. [free] lists the free slots. */
    private var records: Array<Record?>? = null
    private var free = IntArray(0)
    private var freeCount = 0

    /** Vertices kept alive by records, each with the number of those records. Null as long as there are none. */
    private var shared: HashMap<Vertices, IntArray>? = null

    private var alive = 0L

    /** Peak number of suspended colours. */
    var peakAlive: Long = 0
        private set

    /** Peak number of bytes. */
    var peakBytes: Long = bytes
        private set

    /** Whether the budget has room for a record of [primitive] if there are no other records. */
    fun couldOpen(primitive: Primitive): Boolean {
        val vertices = vertices(primitive)
        val sharedPrice = if (vertices != null) sharedBytes(vertices) else 0
        return tableBytes(FIRST_SLOTS) + price(primitive) + sharedPrice <= budget - reserved
    }

    /** Returns a new record with room for at least one run, or null if the budget has no room for it. */
    fun open(primitive: Primitive, index: Int): Record? {
        if (freeCount == 0 && !growTable()) return null
        val price = price(primitive)
        val vertices = vertices(primitive)
        val isFirst = vertices != null && shared?.containsKey(vertices) != true
        val sharedPrice = if (isFirst) sharedBytes(checkNotNull(vertices)) else 0
        if (!reserve(price + sharedPrice)) return null

        val record = Record(primitive, index, free[--freeCount], vertices, price, IntArray(2 * FIRST_RUNS))
        checkNotNull(records)[record.slot] = record
        if (vertices != null) {
            val map = shared ?: HashMap<Vertices, IntArray>().also { shared = it }
            map.getOrPut(vertices) { IntArray(1) }[0]++
        }
        return record
    }

    /** Makes room for one more run in [record]; returns false if the budget has no room for it. */
    fun makeRoom(record: Record): Boolean {
        if (record.hasRoom) return true
        val old = intArrayBytes(record.runs.size)
        val new = intArrayBytes(2 * record.runs.size)
        if (!reserve(new)) return false
        record.runs = record.runs.copyOf(2 * record.runs.size)
        record.bytes += new - old
        bytes -= old
        return true
    }

    /** Records that one more sample is suspended for [record]. */
    fun suspend(record: Record) {
        record.alive++
        if (++alive > peakAlive) peakAlive = alive
    }

    /**
     * Records that a sample suspended for the record in [slot] was hidden. After the last such sample, frees the
     * record.
     */
    fun drop(slot: Int) {
        val table = checkNotNull(records)
        val record = checkNotNull(table[slot])
        alive--
        if (--record.alive > 0) return
        table[slot] = null
        free[freeCount++] = slot
        bytes -= record.bytes
        release(record.vertices ?: return)
    }

    private fun release(vertices: Vertices) {
        val map = checkNotNull(shared)
        val holders = map.getValue(vertices)
        if (--holders[0] > 0) return
        map.remove(vertices)
        bytes -= sharedBytes(vertices)
    }

    inline fun forEach(action: (Record) -> Unit) {
        for (record in records ?: return) if (record != null) action(record)
    }

    /** Drops all records and their memory. */
    fun clear() {
        records = null
        free = IntArray(0)
        freeCount = 0
        shared = null
        alive = 0
        bytes = reserved
    }

    private fun price(primitive: Primitive): Long {
        val held = if (cost == PrimitiveCost.HELD) primitive.heldBytes else 0
        return HeapLayout.RECORD + intArrayBytes(2 * FIRST_RUNS) + held
    }

    private fun vertices(primitive: Primitive): Vertices? =
        if (cost == PrimitiveCost.HELD) primitive.sharedVertices() else null

    private fun growTable(): Boolean {
        val table = records
        val size = table?.size ?: 0
        val newSize = maxOf(2 * size, FIRST_SLOTS)
        if (!reserve(tableBytes(newSize))) return false
        records = table?.copyOf(newSize) ?: arrayOfNulls(newSize)
        free = IntArray(newSize)
        for (slot in newSize - 1 downTo size) free[freeCount++] = slot
        if (table != null) bytes -= tableBytes(size)
        return true
    }

    /** Counts [more] bytes and returns true, or returns false if the budget does not allow it. */
    private fun reserve(more: Long): Boolean {
        if (more > budget - bytes) return false
        bytes += more
        peakBytes = maxOf(peakBytes, bytes)
        return true
    }

    private companion object {
        const val FIRST_RUNS = 4
        const val FIRST_SLOTS = 16

        fun intArrayBytes(size: Int): Long = HeapLayout.HEADER + Int.SIZE_BYTES * size

        /** Two arrays, one of references and one of ints. */
        fun tableBytes(size: Int): Long = intArrayBytes(size) + HeapLayout.HEADER + HeapLayout.REFERENCE * size

        fun sharedBytes(vertices: Vertices): Long = HeapLayout.SHARED_VERTICES + vertices.data.bytes
    }
}

/**
 * The suspended colours of one primitive: where it was visible when it was drawn. Some of these samples may have been
 * hidden since; the samples hold that information.
 *
 * @property slot number by which samples refer to this record
 * @property vertices vertices kept alive by the primitive, or null if their memory need not be counted
 */
internal class Record(
    val primitive: Primitive,
    val index: Int,
    val slot: Int,
    val vertices: Vertices?,
    var bytes: Long,
    var runs: IntArray,
) {
    /** Number of samples that are still suspended. */
    var alive: Int = 0

    var runCount: Int = 0
        private set

    val hasRoom: Boolean get() = 2 * runCount < runs.size

    fun runStart(run: Int): Int = runs[2 * run]

    fun runLength(run: Int): Int = runs[2 * run + 1]

    /** Adds a run of samples; the caller has ensured that there is room. */
    fun add(start: Int, length: Int) {
        runs[2 * runCount] = start
        runs[2 * runCount + 1] = length
        runCount++
    }
}
