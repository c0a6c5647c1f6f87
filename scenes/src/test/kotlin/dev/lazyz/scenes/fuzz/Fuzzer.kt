package dev.lazyz.scenes.fuzz

import dev.lazyz.scenes.fuzz.mutations.ByteMutations
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
    private val kept = ArrayList<Kept>()
    private val kinds = HashSet<String>()
    private val statistics = FuzzStatistics()

    /** An input, and whether it was loaded. */
    private class Kept(val input: ByteArray, val isScene: Boolean)

    /** One line for each finding. */
    val findings = ArrayList<String>()

    /** Goes on for so many seconds after the seeds, or until an input hangs; returns what was done. */
    fun run(seconds: Double): String {
        var start = 0L
        runner.use {
            for (seed in target.seeds + settings.seeds?.let { target.seeds(it) }.orEmpty()) {
                val (reach, outcome) = probe(seed)
                statistics.seed(reach)
                kept.add(Kept(seed, outcome.isScene))
            }
            start = System.nanoTime()
            while (!runner.hangs && System.nanoTime() - start < seconds * NANOS) {
                val input = mutant()
                val (reach, outcome) = probe(input)
                statistics.count(reach, outcome.isScene)
                if (reach.newProbes > 0 && !runner.hangs) kept.add(Kept(input, outcome.isScene))
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
        const val NANOS = 1e9
        const val MOST_BYTES = 98_304
        const val NEWEST = 32
        const val TRIES = 2
    }
}
