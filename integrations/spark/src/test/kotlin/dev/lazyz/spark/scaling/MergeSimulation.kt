package dev.lazyz.spark.scaling

import dev.lazyz.spark.triangles.jobs.BandKey
import dev.lazyz.spark.triangles.jobs.SortLast

/** What a simulation merges: real runs, raw samples, or sizes that a model expects. */
internal interface Compositing<T> {
    /** Bytes of [piece] on the network. */
    fun bytes(piece: T): Long

    /** Returns the parts of [piece] that [ways] nodes go on with, equal in samples. */
    fun split(piece: T, ways: Int): List<T>

    /** Merges pieces that show the same samples. */
    fun merge(pieces: List<T>): Timed<T>
}

/** A result, and the seconds of one processor that it took. */
internal class Timed<T>(val value: T, val seconds: Double)

/**
 * The network between executors: each sends and receives at the same time.
 *
 * @property bytesPerSecond what an executor can receive, and what it can send
 * @property latency seconds from the end of one round to the first byte of the next
 */
internal class Network(val bytesPerSecond: Double, val latency: Double) {
    /** Seconds until [bytes] are there. */
    fun seconds(bytes: Long): Double = latency + bytes / bytesPerSecond
}

/**
 * What merging took.
 *
 * @property networkSeconds the part of the time in which the last node of each round waited for the network
 * @property mergeSeconds the rest: merging, by the last node of each round
 * @property roundBytes of each round the bytes that the busiest node sends or receives
 * @property totalBytes what all nodes sent in these rounds
 * @property collectedBytes what the driver, or the first node, receives at the end; it is not part of the others
 * @property tasks tasks that merge, including those without work
 * @property pieces the merged picture
 */
internal class Simulated<T>(
    val networkSeconds: Double,
    val mergeSeconds: Double,
    val roundBytes: List<Long>,
    val totalBytes: Long,
    val collectedBytes: Long,
    val tasks: Int,
    val pieces: List<T>,
) {
    val seconds: Double get() = networkSeconds + mergeSeconds
}

/** Merges the pictures of nodes by the rules of an algorithm, and counts bytes and time. */
internal class MergeSimulation<T>(private val compositing: Compositing<T>, private val network: Network) {
    /** The load of a node in a round. */
    private class Load {
        var sent = 0L
        var received = 0L
        var seconds = 0.0
        val busiest: Long get() = maxOf(sent, received)
    }

    /** The rounds so far. */
    private inner class Rounds {
        private var networkSeconds = 0.0
        private var mergeSeconds = 0.0
        private val bytes = ArrayList<Long>()
        private var total = 0L
        private var tasks = 0

        /** Adds a round of [used] tasks that ends when its last node has finished. */
        fun add(loads: Collection<Load>, used: Int) {
            tasks += used
            val last = loads.maxBy { network.seconds(it.busiest) + it.seconds }
            networkSeconds += network.seconds(last.busiest)
            mergeSeconds += last.seconds
            bytes += loads.maxOf { it.busiest }
            total += loads.sumOf { it.sent }
        }

        /** Collects all [pieces] but those that are where they are needed. */
        fun collect(pieces: List<T>, own: Int): Simulated<T> {
            val collected = pieces.drop(own).sumOf { compositing.bytes(it) }
            networkSeconds += network.seconds(collected)
            return Simulated(networkSeconds, mergeSeconds, bytes, total, collected, tasks, pieces)
        }
    }

    /**
     * Spark's aggregation, as the job [SortLast] asks for: [fanIn] parts of a band at a time. A task runs on the node
     * with its number. A stage starts when the one before has ended.
     *
     * @param parts the bands of each node by their number; a band that a node does not reach is missing
     * @param bands number of bands of the picture
     */
    fun tree(parts: List<Map<Int, T>>, bands: Int, fanIn: Int = SortLast.FAN_IN): Simulated<T> {
        val nodes = parts.size
        val rounds = Rounds()
        var held = parts.flatMapIndexed { node, bands -> bands.map { Held(BandKey(it.key, node), node, it.value) } }
        for (groups in SortLast.groups(nodes, fanIn)) {
            held = stage(held, groups, SortLast.tasks(nodes, bands, groups), rounds, fanIn)
        }
        return rounds.collect(held.map { it.piece }, own = 0)
    }

    private inner class Held(val key: BandKey, val node: Int, val piece: T)

    private fun stage(held: List<Held>, groups: Int, tasks: Int, rounds: Rounds, fanIn: Int): List<Held> {
        val loads = HashMap<Int, Load>()
        val merged = held.groupBy { BandKey(it.key.band, it.key.group / fanIn) }.map { (key, all) ->
            val node = SortLast.task(key, groups, tasks)
            val load = loads.getOrPut(node) { Load() }
            for (one in all) {
                // What is merged where it was made crosses no network
                if (one.node == node) continue
                val bytes = compositing.bytes(one.piece)
                loads.getOrPut(one.node) { Load() }.sent += bytes
                load.received += bytes
            }
            val result = compositing.merge(all.map { it.piece })
            load.seconds += result.seconds
            Held(key, node, result.value)
        }
        rounds.add(loads.values, tasks)
        return merged
    }

    /**
     * Radix-k: in each round, groups of k nodes split what they have in k pieces, and each node merges one of them.
     * Binary swap is radix-k with factors of 2.
     *
     * Source: Tom Peterka, David Goodell, Robert Ross, Han-Wei Shen, Rajeev Thakur, "A Configurable Algorithm for
     * Parallel Image-Compositing Applications", SC 2009; Kwan-Liu Ma, James Painter, Charles Hansen, Michael Krogh,
     * "Parallel Volume Rendering Using Binary-Swap Compositing", IEEE Computer Graphics and Applications 14 (1994).
     *
     * @param parts the picture of each node
     * @param factors k of each round; their product is the number of nodes
     */
    fun swap(parts: List<T>, factors: List<Int>): Simulated<T> {
        require(factors.fold(1, Int::times) == parts.size) { "$factors must multiply to ${parts.size} nodes" }
        val rounds = Rounds()
        var pieces = parts
        var stride = 1
        for (k in factors) {
            val split = pieces.map { compositing.split(it, k) }
            val loads = pieces.map { Load() }
            pieces = pieces.indices.map { node ->
                val own = node / stride % k
                val group = (0 until k).map { node + (it - own) * stride }
                for (other in group) if (other != node) loads[node].received += compositing.bytes(split[other][own])
                for (d in 0 until k) if (d != own) loads[node].sent += compositing.bytes(split[node][d])
                val result = compositing.merge(group.map { split[it][own] })
                loads[node].seconds += result.seconds
                result.value
            }
            rounds.add(loads, pieces.size)
            stride *= k
        }
        return rounds.collect(pieces, own = 1)
    }
}
