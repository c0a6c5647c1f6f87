package dev.lazyz.conformance.probes.memory

import java.lang.management.ManagementFactory
import javax.management.ObjectName
import kotlin.math.max
import kotlin.math.min

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
