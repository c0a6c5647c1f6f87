package dev.lazyz.scenes.fuzz

import java.nio.file.Path
import java.util.Random

/**
 * Changes inputs and keeps those that reach code which none reached before, to change them further. The order of inputs is
 * that of the seed; only how far it goes depends on time. Not thread safe.
 */
internal class Fuzzer(private val target: FuzzTarget, private val settings: FuzzSettings, folder: Path) {
    private val random = Random(settings.seed xor target.id.hashCode().toLong())
    private val coverage = Coverage()
    private val runner =
        CaseRunner(coverage.create(LoadAndDraw::class.java.name, target.id, folder) as SceneCase)
    private val kept = ArrayList<ByteArray>()
    private val kinds = HashSet<String>()
    private val statistics = FuzzStatistics()

    /** One line for each finding. */
    val findings = ArrayList<String>()

    /** Goes on for so many seconds after the seeds, or until an input hangs; returns what was done. */
    fun run(seconds: Double): String {
        var start = 0L
        runner.use {
            for (seed in target.seeds + settings.seeds?.let { target.seeds(it) }.orEmpty()) {
                kept.add(seed)
                statistics.seed(probe(seed).first)
            }
            start = System.nanoTime()
            while (!runner.hangs && System.nanoTime() - start < seconds * NANOS) {
                val input = mutant()
                val (reach, outcome) = probe(input)
                statistics.count(reach, outcome.isScene)
                if (reach.newProbes > 0 && !runner.hangs) kept.add(input)
            }
        }
        val taken = (System.nanoTime() - start) / NANOS
        return "$target: ${statistics.text(taken)}, ${kept.size} kept, ${coverage.reached} probes, " +
            "${findings.size} findings"
    }

    private fun probe(input: ByteArray): Pair<Coverage.Reach, CaseRunner.Outcome> {
        val outcome = runner.run(input)
        if (outcome.fault != null && kinds.add(outcome.kind)) {
            findings.add(Finding(target, settings, statistics.inputs, input, outcome).write())
        }
        return coverage.take() to outcome
    }

    private fun mutant(): ByteArray {
        var input = pick()
        do {
            val mutations = target.mutations[random.nextInt(target.mutations.size)]
            input = mutations.mutate(input, pick(), random) ?: input
        } while (random.nextInt(3) != 0)
        return if (input.size > MOST_BYTES) input.copyOf(MOST_BYTES) else input
    }

    /** An input that was kept, rather a new one. */
    private fun pick(): ByteArray {
        val newest = if (random.nextBoolean()) minOf(kept.size, NEWEST) else kept.size
        return kept[kept.size - 1 - random.nextInt(newest)]
    }

    private companion object {
        const val NANOS = 1e9
        const val MOST_BYTES = 98_304
        const val NEWEST = 16
    }
}
