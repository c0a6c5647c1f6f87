package dev.lazyz.scenes.fuzz

import dev.lazyz.scenes.fuzz.mutations.ByteMutations
import java.nio.file.Path
import java.util.Random
import java.util.concurrent.CopyOnWriteArrayList
import java.util.concurrent.FutureTask
import kotlin.concurrent.thread

/**
 * Changes inputs and keeps those that reach code which none reached before, to change them further. The order of inputs
 * is that of the seed; only how far it goes depends on time. Not thread safe.
 */
internal class Fuzzer(private val target: FuzzTarget, private val settings: FuzzSettings, folder: Path) {
    private val random = Random(settings.seed xor target.id.hashCode().toLong())
    private val coverage = Coverage()
    private val runner = CaseRunner(coverage.create(LoadAndDraw::class.java.name, target.id, folder) as SceneCase)
    private val kept = ArrayList<Kept>()
    private val kinds = HashSet<String>()
    private val statistics = FuzzStatistics()

    /** An input, and whether it was loaded. */
    private class Kept(val input: ByteArray, val isScene: Boolean)

    @Volatile
    private var hangs = false

    @Volatile
    private var taken = 0.0

    /** One line for each finding. */
    val findings: MutableList<String> = CopyOnWriteArrayList()

    /**
     * Goes on for so many seconds after the seeds; returns what was done. An input that hangs is the end: it keeps the
     * thread that all run on.
     */
    fun run(seconds: Double): String {
        val work = FutureTask { work(seconds) }
        val worker = thread(isDaemon = true, name = "fuzz") { work.run() }
        while (worker.isAlive && !hangs) {
            worker.join(WATCH_MILLIS)
            runner.hang(worker)?.let { (input, outcome) ->
                hangs = true
                findings.add(Finding(target, settings, statistics.inputs, input, outcome).write())
            }
        }
        if (!hangs) work.get()
        return "$target: ${statistics.text(taken)}, ${kept.size} kept, ${coverage.reached} probes, " +
            "${findings.size} findings"
    }

    private fun work(seconds: Double) {
        for (seed in target.seeds + settings.seeds?.let { target.seeds(it) }.orEmpty()) {
            val (reach, outcome) = probe(seed)
            statistics.seed(reach)
            kept.add(Kept(seed, outcome.isScene))
        }
        val start = System.nanoTime()
        while (!hangs && taken < seconds) {
            val input = mutant()
            val (reach, outcome) = probe(input)
            statistics.count(reach, outcome.isScene)
            if (reach.newProbes > 0) kept.add(Kept(input, outcome.isScene))
            taken = (System.nanoTime() - start) / 1e9
        }
    }

    private fun probe(input: ByteArray): Pair<Coverage.Reach, CaseRunner.Outcome> {
        val outcome = runner.run(input)
        if (outcome.fault != null && !hangs && kinds.add(outcome.kind)) {
            findings.add(Finding(target, settings, statistics.inputs, input, outcome).write())
        }
        return coverage.take() to outcome
    }

    private fun mutant(): ByteArray {
        val mutations = target.mutations[random.nextInt(target.mutations.size)]
        var input = pick()
        do {
            input = mutations.mutate(input, pick(), random) ?: ByteMutations.mutate(input, pick(), random)
        } while (random.nextInt(2) == 0)
        return if (input.size > MOST_BYTES) input.copyOf(MOST_BYTES) else input
    }

    /** An input that was kept, rather a new one, and rather one that was loaded. */
    private fun pick(): ByteArray {
        val newest = if (random.nextBoolean()) minOf(kept.size, NEWEST) else kept.size
        var pick = kept[kept.size - 1 - random.nextInt(newest)]
        repeat(TRIES) { if (!pick.isScene) pick = kept[kept.size - 1 - random.nextInt(newest)] }
        return pick.input
    }

    private companion object {
        const val MOST_BYTES = 98_304
        const val WATCH_MILLIS = 200L
        const val NEWEST = 32
        const val TRIES = 2
    }
}
