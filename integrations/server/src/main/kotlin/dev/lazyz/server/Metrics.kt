package dev.lazyz.server

import java.util.concurrent.ConcurrentSkipListMap
import java.util.concurrent.atomic.LongAdder

/** The numbers of a server, in the text format of Prometheus (version 0.0.4). Thread safe. */
internal class Metrics {
    private class Family(val type: String, val help: String) {
        private val samples = LinkedHashMap<String, () -> Number>()

        /** Adds a number, after those before. */
        fun add(sample: String, read: () -> Number) = synchronized(samples) { samples[sample] = read }

        /** Returns all numbers, in the order in which they were added. */
        fun all(): Map<String, () -> Number> = synchronized(samples) { LinkedHashMap(samples) }
    }

    /** A number that only grows. */
    class Counter {
        private val sum = LongAdder()

        fun add(count: Long = 1) = sum.add(count)

        val value: Long get() = sum.sum()
    }

    /** Counts durations by upper bounds. */
    inner class Histogram(name: String, help: String) {
        private val counts = BOUNDS.map { Counter() }
        private val all = Counter()
        private val nanoseconds = Counter()

        init {
            val family = family(name, "histogram", help)
            BOUNDS.forEachIndexed { i, bound ->
                family.add("${name}_bucket{le=\"$bound\"}") { counts.take(i + 1).sumOf { it.value } }
            }
            family.add("${name}_bucket{le=\"+Inf\"}") { all.value }
            family.add("${name}_count") { all.value }
            family.add("${name}_sum") { nanoseconds.value / 1e9 }
        }

        fun add(duration: Long) {
            val seconds = duration / 1e9
            BOUNDS.indexOfFirst { seconds <= it }.let { if (it >= 0) counts[it].add() }
            all.add()
            nanoseconds.add(duration)
        }
    }

    private val families = ConcurrentSkipListMap<String, Family>()
    private val counters = ConcurrentSkipListMap<String, Counter>()

    /** Returns the counter called [name] with the [labels], such as `status="200"`. */
    fun counter(name: String, help: String, labels: String = ""): Counter {
        val sample = if (labels.isEmpty()) name else "$name{$labels}"
        return counters.computeIfAbsent(sample) {
            Counter().also { counter -> family(name, "counter", help).add(sample) { counter.value } }
        }
    }

    /** Adds a number that is read when it is asked for. */
    fun gauge(name: String, help: String, read: () -> Number) {
        family(name, "gauge", help).add(name, read)
    }

    /** Returns all numbers. */
    fun text(): String = buildString {
        for ((name, family) in families) {
            append("# HELP ").append(name).append(' ').append(family.help).append('\n')
            append("# TYPE ").append(name).append(' ').append(family.type).append('\n')
            for ((sample, read) in family.all()) append(sample).append(' ').append(read()).append('\n')
        }
    }

    private fun family(name: String, type: String, help: String): Family =
        families.computeIfAbsent(name) { Family(type, help) }

    private companion object {
        /** Seconds. */
        val BOUNDS = listOf(0.01, 0.03, 0.1, 0.3, 1.0, 3.0, 10.0, 30.0)
    }
}
