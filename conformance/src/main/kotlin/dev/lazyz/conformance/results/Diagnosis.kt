package dev.lazyz.conformance.results

import dev.lazyz.conformance.rules.Level
import dev.lazyz.conformance.rules.Symptom
import kotlin.math.ln

/**
 * Finds the broken rules that are most likely related to the renderer's mistake.
 *
 * One mistake breaks many rules, since most of them compare pictures. Each failure shows [Symptom]s, and each rule
 * declares the symptoms that it tests for. A rule is a likely cause if the failures of all rules show its symptoms, and
 * the more so the rarer these symptoms are by chance. The score is the ratio of both probabilities, multiplied over the
 * failures: a naive Bayes classifier. A symptom that a rule produces itself, as a rule about regions produces regions,
 * has no weight in that rule's own failure. A rule without symptoms explains only its own failure.
 *
 * Two kinds of failures need no statistics: those that say their whole cause, and crashes. They are named first.
 *
 * Immutable and thread safe.
 */
internal class Diagnosis private constructor(
    /** The likely causes, best first; empty if no rule is broken. */
    val causes: List<Cause>,
) {
    /** A rule that is likely related to the mistake, the reason [why], a clause, and where to [look]. */
    class Cause(val rule: SuiteRule, val why: String, val look: String) {
        override fun toString(): String = "$rule: $why"
    }

    /**
     * A broken rule, the symptoms of its failure, which are null if they are unknown, and where to [look].
     *
     * @property crash what the renderer does, as a verb and its object, if it crashes; otherwise null
     * @property isPlain whether the failure says its whole cause
     */
    class Broken(
        val rule: SuiteRule,
        val symptoms: Set<Symptom>?,
        val look: String = rule.look,
        val crash: String? = null,
        val isPlain: Boolean = false,
    ) {
        /**
         * How strongly this failure supports a mistake related to [symptom]: a log-likelihood ratio, positive if it
         * does.
         */
        fun support(symptom: Symptom): Double = when {
            symptoms == null -> 0.0
            symptom !in symptoms -> ln(MISSED / (1 - symptom.rate))
            symptom in rule.about -> 0.0
            else -> ln((1 - MISSED) / symptom.rate)
        }
    }

    companion object {
        /** Greatest number of causes. */
        const val MOST_CAUSES: Int = 3

        /** The probability that a failure does not show the symptom of its cause. */
        private const val MISSED = 0.1

        /** What can be wrong at a sample. */
        private val MISTAKES =
            listOf(Symptom.ORDER, Symptom.COVERAGE, Symptom.DEPTH, Symptom.COLOR, Symptom.TIE, Symptom.EXCEPTION)

        /** Weight of another rule's failure against a rule that explains only its own failure. */
        private val UNEXPLAINED = ln(MISSED)

        /** Diagnoses [results], except waived ones. */
        fun of(results: List<RuleResult>): Diagnosis = ofBroken(
            results.filter { it.outcome != RuleOutcome.WAIVED }.mapNotNull { result ->
                result.failure?.let { Broken(result.rule, it.symptoms, result.look, it.crash, it.isPlain) }
            },
        )

        /** Diagnoses the [broken] rules. */
        fun ofBroken(broken: List<Broken>): Diagnosis {
            val scores = broken.associateWith { score(it.rule, broken) }
            val ordered = broken.sortedWith(compareBy({ -scores.getValue(it) }, { it.rule.isSpecial }))

            // One crash of each kind is enough, and crashes of most rules are the mistake
            val crashed = broken.filter { it.crash != null }.takeIf { 2 * it.size >= broken.size }.orEmpty()
            val first = ordered.filter { it.isPlain } + crashed.sortedBy { it.rule.isSpecial }.distinctBy { it.crash }
            val best = (first + (ordered - first.toSet() - crashed.toSet())).take(MOST_CAUSES)

            // That the picture is wrong says little, unless nothing else explains the failures
            val (vague, clear) = best.drop(1).partition { symptom(it.rule, broken) == Symptom.PICTURE }
            return Diagnosis((best.take(1) + clear + vague).map { Cause(it.rule, why(it, broken), it.look) })
        }

        private fun score(rule: SuiteRule, broken: List<Broken>): Double {
            val chance = if (rule.level == Level.MUST) 0.0 else UNEXPLAINED
            val symptom = symptom(rule, broken) ?: return chance + (broken.size - 1) * UNEXPLAINED
            return chance + broken.sumOf { it.support(symptom) }
        }

        /** Returns the symptom of [rule] that the failures support most. */
        private fun symptom(rule: SuiteRule, broken: List<Broken>): Symptom? =
            rule.about.maxByOrNull { symptom -> broken.sumOf { it.support(symptom) } }

        private fun why(cause: Broken, broken: List<Broken>): String {
            val known = broken.filter { it.symptoms != null }
            fun showing(symptom: Symptom?) = known.count { symptom in it.symptoms.orEmpty() }
            val usual = symptom(cause.rule, broken)

            // Of a picture that is wrong, say how most often
            val isThrown = usual != null && Symptom.EXCEPTION in cause.symptoms.orEmpty()
            val symptom = when {
                usual == Symptom.PICTURE -> MISTAKES.maxBy { showing(it) }
                isThrown && showing(Symptom.EXCEPTION) > showing(usual) -> Symptom.EXCEPTION
                else -> usual
            }
            val showing = showing(symptom)
            val crashing = broken.count { it.crash == cause.crash }
            return when {
                broken.size == 1 -> "it is the only broken rule"
                cause.isPlain -> "its failure says the whole cause"
                cause.crash != null -> "in $crashing of ${broken.size} failures the renderer ${cause.crash}"
                symptom == null || showing == 0 -> "the failures of the other rules do not explain this one"
                else -> "in $showing of ${known.size} failures ${symptom.words}"
            }
        }
    }
}
