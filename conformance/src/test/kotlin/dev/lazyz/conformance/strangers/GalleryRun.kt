package dev.lazyz.conformance.strangers

import dev.lazyz.conformance.Conformance
import java.time.Duration

/**
 * Runs the suite on every mistake of [StrangersGallery], one after the other, and prints a line each: who noticed, which rules
 * the report names as likely causes, and how long it took. Arguments: the seed, then ids (all by default).
 */
internal object GalleryRun {
    @JvmStatic
    fun main(args: Array<String>) {
        val seed = args.firstOrNull()?.toLong() ?: 1995L
        val ids = args.drop(1)
        var noticed = 0
        var named = 0
        val chosen = StrangersGallery.all.filter { ids.isEmpty() || it.id in ids }
        for (stranger in chosen) {
            val start = System.nanoTime()
            val report = Conformance { stranger.make() }.seed(seed).deadline(Duration.ofSeconds(10)).run()
            val seconds = (System.nanoTime() - start) / 1e9
            val causes = report.diagnosis.causes.map { it.rule }
            val isNamed = causes.any { it.number in stranger.chapters }
            if (!report.isConformant) noticed++
            if (isNamed) named++
            val verdict = if (report.isConformant) {
                "MISSED"
            } else if (isNamed) {
                "named"
            } else {
                "noticed"
            }
            val broken = report.results.filter { it.outcome.isFailure }.size
            println(
                "%-8s %-34s %5.1f s %2d broken, about %s, named %s".format(
                    verdict, stranger.id, seconds, broken, stranger.chapters, causes.joinToString { it.name },
                ),
            )
        }
        println("$noticed of ${chosen.size} noticed, $named named among the first three")
        System.exit(0)
    }
}
