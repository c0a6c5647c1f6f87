package dev.lazyz.strategies.hybrid

import dev.lazyz.Primitive
import dev.lazyz.setup.planar.sharedVertices
import dev.lazyz.shading.Vertices

/** Whether keeping a primitive costs memory. */
internal enum class PrimitiveCost {
    /** A frame keeps all primitives anyway. */
    NONE,

    /** What is not kept here is garbage. */
    HELD,
}

/**
 * The records of all primitives with suspended colours, and an account of their bytes.
 *
 * Every array and object that grows with the suspensions is entered in the account before it is allocated, and taken out
 * when it is dropped; while an array is replaced by a longer one, both are in it. Objects are counted with headers of 16
 * bytes and references of 8, as large as a JVM makes them.
 *
 * @param budget most bytes, at any time
 * @param bytes bytes in use from the start
 */
internal class Suspensions(private val budget: Long, private var bytes: Long, private val cost: PrimitiveCost) {
    private val reserved = bytes

    /** Records by slot, and the slots that are free. Null as long as there are no records. */
    private var records: Array<Record?>? = null
    private var free = IntArray(0)
    private var freeCount = 0

    /** Vertices that records keep alive, with the number of records. Null as long as there are none. */
    private var shared: HashMap<Vertices, IntArray>? = null

    private var alive = 0L

    /** Most suspended colours at one time. */
    var peakAlive: Long = 0
        private set

    /** Most bytes at one time. */
    var peakBytes: Long = bytes
        private set

    /** Whether the budget has room for a record of [primitive] if there is no other. */
    fun couldOpen(primitive: Primitive): Boolean {
        val vertices = vertices(primitive)
        val sharedPrice = if (vertices != null) sharedBytes(vertices) else 0
        return tableBytes(FIRST_SLOTS) + price(primitive) + sharedPrice <= budget - reserved
    }

    /** Returns a new record with room for a run, or null if the budget has no room for it. */
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

    /** Makes room for one run more in [record]; returns false if the budget has none. */
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

    /** Notes that one sample more is suspended for [record]. */
    fun suspend(record: Record) {
        record.alive++
        if (++alive > peakAlive) peakAlive = alive
    }

    /** Notes that a sample suspended for the record in [slot] has been hidden; the last one frees the record. */
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

    /** Drops all records and the memory that they were kept in. */
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
        return RECORD_BYTES + intArrayBytes(2 * FIRST_RUNS) + held
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

    /** Enters [more] bytes in the account, if the budget allows it. */
    private fun reserve(more: Long): Boolean {
        if (more > budget - bytes) return false
        bytes += more
        peakBytes = maxOf(peakBytes, bytes)
        return true
    }

    private companion object {
        const val FIRST_RUNS = 4
        const val FIRST_SLOTS = 16

        /** A [Record] without its runs: a header, three references, a long and four ints, rounded up. */
        const val RECORD_BYTES = 72L

        fun intArrayBytes(size: Int): Long = 16L + Int.SIZE_BYTES * size

        /** Two arrays, one of references and one of ints. */
        fun tableBytes(size: Int): Long = 32L + 12L * size

        /**
         * Vertices, and what a hash map takes for them: an entry of 48 bytes, a counter of 24, and 208 for the map and
         * its first table, which is more than the share of later tables, old and new one together while it grows.
         */
        fun sharedBytes(vertices: Vertices): Long = 32L + 8L * vertices.data.size + 48L + 24L + 208L
    }
}

/**
 * The suspended colours of one primitive: where it was visible when it was drawn. Some of it may have been hidden since;
 * the samples know.
 *
 * @property slot number by which samples refer to this record
 * @property vertices vertices that are kept alive with the primitive, or null if that is of no concern
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

    /** Adds a run of samples; there is room. */
    fun add(start: Int, length: Int) {
        runs[2 * runCount] = start
        runs[2 * runCount + 1] = length
        runCount++
    }
}
