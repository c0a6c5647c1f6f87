package dev.lazyz.conformance.probes.memory

import com.sun.management.HotSpotDiagnosticMXBean
import dev.lazyz.conformance.judgement.TryUnderWay
import dev.lazyz.conformance.judgement.notMeasured
import java.lang.management.ManagementFactory
import java.lang.ref.Reference
import java.lang.ref.WeakReference
import javax.management.ObjectName
import kotlin.math.abs
import kotlin.math.max
import kotlin.math.min

/** Measures the heap after garbage collection. */
internal object Heap {
    private const val ATTEMPTS = 5

    /** Number of the attempt after which a clear result counts. */
    private const val ENOUGH = 2

    /** How many collections contain one that compacts the whole heap. Other JVMs than HotSpot do not say. */
    private val collections by lazy {
        val stated = runCatching {
            val hotSpot = ManagementFactory.getPlatformMXBean(HotSpotDiagnosticMXBean::class.java)
            hotSpot.getVMOption("MarkSweepAlwaysCompactCount").value.toInt()
        }
        stated.getOrDefault(USUAL_COLLECTIONS).coerceIn(1, MOST_COLLECTIONS)
    }

    /** The default of HotSpot. */
    private const val USUAL_COLLECTIONS = 4
    private const val MOST_COLLECTIONS = 16
    private const val BLOCK = 1024
    private const val HEADER = 16

    /** A measurement above this multiple of the limit is not noise, such as a block of rows that is not yet garbage. */
    private const val CLEAR = 8

    /** A quarter of the smallest allowance of a rule. */
    private const val TOLERANCE = 32 * BLOCK

    /**
     * Sizes with which the measurement is tested. Collectors that count in regions get some of them right by chance,
     * but not all.
     */
    private val KNOWN = listOf(128 * BLOCK, 512 * BLOCK, 1024 * BLOCK)

    @Volatile
    private var isKnownToBeExact = false

    /** Ends the rule, as not applicable, if System.gc() has no effect. */
    fun requireCollection() {
        val garbage = WeakReference(ByteArray(1))
        if (!isSoon { garbage.get() == null }) notMeasured("this JVM ignores System.gc()")
    }

    /** Ends the rule, as not applicable, if this JVM does not count live objects, or counts known sizes wrong. */
    private fun requireMeasurable() {
        if (!isExact()) notMeasured("this JVM does not count the bytes of live objects")
    }

    /** Returns whether what is allocated is found on the heap, to the byte or nearly so. */
    fun isExact(): Boolean {
        if (!isKnownToBeExact) isKnownToBeExact = HeapContent.measured() != null && KNOWN.all { isExact(it) }
        return isKnownToBeExact
    }

    private fun isExact(bytes: Int): Boolean {
        repeat(ATTEMPTS) {
            val held = most { measure ->
                val blocks = List(bytes / BLOCK) { ByteArray(BLOCK - HEADER) }
                measure()
                Reference.reachabilityFence(blocks)
            }
            if (abs(held.total - bytes) <= TOLERANCE) return true
        }
        return false
    }

    /** Returns whether [isSo] becomes true after some collections. */
    fun isSoon(isSo: () -> Boolean): Boolean {
        repeat(2 * ATTEMPTS) {
            System.gc()
            if (isSo()) return true

            // Threads that have just ended may take a moment to release their memory
            Thread.sleep(it.toLong())
        }
        return false
    }

    /**
     * Returns the most that is held, in addition to what is held before, at the calls of the function that [work] gets.
     */
    fun most(work: (measure: () -> Unit) -> Unit): HeapContent {
        val before = settled()
        var most = HeapContent.EMPTY
        work {
            synchronized(this) {
                val more = held().growthSince(before)
                if (more.total > most.total) most = more
            }
        }
        return most
    }

    /**
     * Returns the growth of each class that each of several calls of [work] causes, at least. Ends the rule, as not
     * applicable, if this JVM does not count live objects.
     */
    fun leastGrowth(work: () -> Unit): HeapContent {
        if (HeapContent.measured() == null) notMeasured("this JVM does not count the bytes of live objects")
        var before = held()
        var least: HeapContent? = null
        repeat(PERIODS) {
            work()
            val after = held()
            val growth = after.growthSince(before)
            least = least?.atMost(growth) ?: growth
            before = after
        }
        return checkNotNull(least)
    }

    /** How often [leastGrowth] calls its argument. What it keeps itself no longer grows from the third call on. */
    const val PERIODS: Int = 4

    /**
     * Calls [fail] with the least of several [measurements], unless one of them is at most [limit], since noise only
     * adds. Three measurements are enough if the result is clearly above the limit.
     */
    fun requireAtMost(limit: Long, measurements: () -> HeapContent, fail: (least: HeapContent) -> Nothing) {
        requireMeasurable()
        var least = measurements()
        repeat(ATTEMPTS - 1) { attempt ->
            if (least.total <= limit) return
            if (attempt >= ENOUGH && least.total > CLEAR * limit) fail(least)
            least = minOf(least, measurements(), compareBy { it.total })
        }
        if (least.total > limit) fail(least)
    }

    /**
     * Returns what is held, once it no longer decreases. The result counts the content before it, which takes as much
     * memory as the result itself does at the next measurement.
     */
    private fun settled(): HeapContent {
        var least = held()
        repeat(ATTEMPTS) {
            Thread.sleep(1)
            val now = held()
            if (now.total >= least.total) return now
            least = now
        }
        return least
    }

    /**
     * Returns what is held. Some collectors leave dead objects where they are, if they take only a few per cent of the
     * heap, and count them as live. One of a few collections removes them all, see [collections].
     */
    private fun held(): HeapContent {
        // Counting is no work of the renderer
        TryUnderWay.current?.goesOn()
        val all = List(collections) {
            checkNotNull(HeapContent.measured()) { "this JVM counted live objects before, but does not now" }
        }
        TryUnderWay.current?.goesOn()
        return all.minBy { it.total }
    }
}

/**
 * The bytes of live objects on the heap by class, or the difference of two such contents. Objects are counted one by
 * one, because the used part of the heap also contains the buffers from which threads allocate, up to some megabytes
 * each.
 *
 * @property bytes bytes by the number of the class: a content takes eight bytes for each class that the JVM has loaded
 */
internal class HeapContent private constructor(private val bytes: LongArray) {
    val total: Long = bytes.sum()

    /** Returns the difference, class by class. */
    operator fun minus(other: HeapContent): HeapContent =
        HeapContent(LongArray(max(bytes.size, other.bytes.size)) { of(it) - other.of(it) })

    /**
     * Returns the growth since [before], class by class, and zero for a class of which there is less: what others have
     * released meanwhile does not hide what is held.
     */
    fun growthSince(before: HeapContent): HeapContent =
        HeapContent((this - before).bytes.apply { forEachIndexed { of, grown -> this[of] = max(grown, 0) } })

    /** Returns the lesser of both, class by class. */
    fun atMost(other: HeapContent): HeapContent =
        HeapContent(LongArray(max(bytes.size, other.bytes.size)) { min(of(it), other.of(it)) })

    private fun of(number: Int): Long = bytes.getOrElse(number) { 0L }

    /** Returns such as `1113496 bytes more on the heap (1048592 in int[])`: the total, and the largest class. */
    override fun toString(): String {
        val largest = bytes.indices.maxByOrNull { bytes[it] } ?: return "0 bytes more on the heap"
        return "$total bytes more on the heap (${bytes[largest]} in ${Classes.readable(largest)})"
    }

    /** Numbers of classes, in the order in which they were first seen. */
    private object Classes {
        private val numbers = LinkedHashMap<String, Int>()

        @Synchronized
        fun number(name: String): Int = numbers.getOrPut(name) { numbers.size }

        /** The JVM prints `[I` for `int[]`. */
        @Synchronized
        fun readable(number: Int): String {
            val name = numbers.keys.elementAt(number)
            val known = runCatching { Class.forName(name, false, HeapContent::class.java.classLoader) }
            return known.getOrNull()?.typeName ?: name
        }
    }

    companion object {
        val EMPTY: HeapContent = HeapContent(LongArray(0))

        private val commands = ObjectName("com.sun.management:type=DiagnosticCommand")

        /**
         * Collects garbage and counts, with all threads stopped. Takes some tens of milliseconds for each 100 MB.
         * Returns null if this JVM cannot do that.
         */
        fun measured(): HeapContent? {
            val histogram = runCatching {
                val options = arrayOf<Any>(emptyArray<String>())
                val types = arrayOf(Array<String>::class.java.name)
                ManagementFactory.getPlatformMBeanServer().invoke(commands, "gcClassHistogram", options, types)
            }
            val lines = (histogram.getOrNull() as? String ?: return null).lineSequence()
            val counts = lines.mapNotNull(::count).toList()
            if (counts.isEmpty()) return null
            val bytes = LongArray(counts.maxOf { (number, _) -> number } + 1)

            // Classes of several loaders can share a name
            for ((number, held) in counts) bytes[number] += held
            return HeapContent(bytes)
        }

        /** Parses such as `   1:    12345     678901  [B (java.base@17)`: place, instances, bytes, class. */
        private fun count(line: String): Pair<Int, Long>? {
            val words = line.split(' ').filter { it.isNotEmpty() }
            if (words.size < 4 || !words[0].endsWith(':')) return null
            return words[2].toLongOrNull()?.let { Classes.number(words[3]) to it }
        }
    }
}
