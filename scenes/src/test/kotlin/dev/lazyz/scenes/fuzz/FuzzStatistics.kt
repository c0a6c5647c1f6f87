package dev.lazyz.scenes.fuzz

import java.util.Locale

/** Counts what became of inputs. Not thread safe. */
internal class FuzzStatistics {
    private var seeds = 0
    private var seedProbes = 0L
    private var scenes = 0L
    private var early = 0L

    /** Inputs made so far, without the seeds. */
    var inputs = 0L
        private set

    fun seed(reach: Coverage.Reach) {
        seeds++
        seedProbes += reach.probes
    }

    /** Counts an input; one is refused early if it reaches less than half of what seeds do on the average. */
    fun count(reach: Coverage.Reach, isScene: Boolean) {
        inputs++
        if (isScene) scenes++
        if (!isScene && reach.probes * 2L * seeds < seedProbes) early++
    }

    fun text(seconds: Double): String = String.format(
        Locale.ROOT,
        "%d seeds, %d inputs in %.1f s, %.0f a second, %.0f %% loaded, %.0f %% refused early, %.0f %% late",
        seeds,
        inputs,
        seconds,
        inputs / seconds,
        share(scenes),
        share(early),
        share(inputs - scenes - early),
    )

    private fun share(count: Long): Double = 100.0 * count / maxOf(inputs, 1)
}
