package dev.lazyz.conformance.strangers

import dev.lazyz.conformance.Conformance
import kotlin.system.exitProcess

/**
 * Runs the suite on wrong renderers, one after the other, and prints a line each: whether it notices, how long it
 * takes, and which rules the report names as likely causes; at the end the sums.
 *
 * Arguments: the name of the gallery, `first` and so on; the seed; `shrinking` or `quick`, which leaves frames as they
 * are; then ids, by default all.
 */
internal object GalleryRun {
    @JvmStatic
    fun main(args: Array<String>) {
        val gallery = Galleries.byName.getValue(args[0])
        val ids = args.drop(3)
        val chosen = gallery.filter { ids.isEmpty() || it.id in ids }
        val verdicts = chosen.map { judge(it, seed = args[1].toLong(), isQuick = args[2] == "quick") }
        val sums = verdicts.groupingBy { it }.eachCount()
        println("${chosen.size} wrong renderers: $sums")

        // A renderer may have left threads
        exitProcess(0)
    }

    /** Returns `missed`, `noticed`, or `named` where a rule that the mistake is about is among the likely causes. */
    private fun judge(stranger: Stranger, seed: Long, isQuick: Boolean): String {
        val conformance = Conformance { stranger.make() }.seed(seed)
        val report = (if (isQuick) conformance.withoutShrinking() else conformance).run()
        val causes = report.diagnosis.causes.map { it.rule }
        val verdict = when {
            report.isConformant -> "missed"
            causes.any { it.number in stranger.chapters } -> "named"
            else -> "noticed"
        }
        val broken = report.results.count { it.outcome.isFailure }
        println(
            "%-7s %-34s %5.1f s, %2d broken, about %s: %s".format(
                verdict, stranger.id, report.milliseconds / 1000.0, broken, stranger.chapters,
                causes.joinToString {
                    it.name
                },
            ),
        )
        return verdict
    }
}
