package dev.lazyz.conformance.results

import dev.lazyz.conformance.rules.Level
import dev.lazyz.conformance.rules.Symptom
import kotlin.math.ln

/**
 * Which of the rules that a renderer breaks are most likely about its mistake.
 *
 * One mistake breaks many rules, since most of them compare pictures. Each failure shows [Symptom]s, and each rule says
 * which it is about. A rule is likely to be the cause if the failures of all rules show its symptoms, the more so the
 * less they are to be expected by chance: the ratio of both probabilities, multiplied over the failures, is a naive
 * Bayes classifier. A symptom that a rule makes itself, as a rule about regions makes regions, says nothing when that
 * rule shows it. A rule about no symptom explains its own failure, and no others.
 *
 * Immutable and thread safe.
 */
internal class Diagnosis private constructor(
    /** The likely rules, best first; empty if no rule is broken. */
    val causes: List<Cause>,
) {
    /** One rule that may be about the mistake, and [why], a sentence. */
    class Cause(val rule: SuiteRule, val why: String) {
        override fun toString(): String = "$rule: $why"
    }

    /** A rule that is broken, and what its failure shows; null if that is unknown. */
    class Broken(val rule: SuiteRule, val symptoms: Set<Symptom>?) {
        /** How much it supports that the mistake is about [symptom]: a logarithm, positive if it does. */
        fun support(symptom: Symptom): Double = when {
            symptoms == null -> 0.0
            symptom !in symptoms -> ln(MISSED / (1 - symptom.rate))
            symptom in rule.about -> 0.0
            else -> ln((1 - MISSED) / symptom.rate)
        }
    }

    companion object {
        /** As many causes are named. */
        const val MOST_CAUSES: Int = 3

        /** The probability that a failure does not show the symptom of its cause. */
        private const val MISSED = 0.1

        /** How much another rule's failure speaks against one that explains none but its own. */
        private val UNEXPLAINED = ln(MISSED)

        /** Diagnoses [results], but for what is waived. */
        fun of(results: List<RuleResult>): Diagnosis = ofBroken(
            results.filter { it.outcome != RuleOutcome.WAIVED }
                .mapNotNull { result -> result.failure?.let { Broken(result.rule, it.symptoms) } },
        )

        /** Diagnoses rules that are [broken]. */
        fun ofBroken(broken: List<Broken>): Diagnosis {
            val scored = broken.map { it to score(it.rule, broken) }
            val best = scored.sortedByDescending { (_, score) -> score }.take(MOST_CAUSES)
            return Diagnosis(best.map { (it, _) -> Cause(it.rule, why(it.rule, broken)) })
        }

        private fun score(rule: SuiteRule, broken: List<Broken>): Double {
            val chance = if (rule.level == Level.MUST) 0.0 else UNEXPLAINED
            val symptom = symptom(rule, broken) ?: return chance + (broken.size - 1) * UNEXPLAINED
            return chance + broken.sumOf { it.support(symptom) }
        }

        /** Of the symptoms that [rule] is about the one that the failures support most. */
        private fun symptom(rule: SuiteRule, broken: List<Broken>): Symptom? =
            rule.about.maxByOrNull { symptom -> broken.sumOf { it.support(symptom) } }

        private fun why(rule: SuiteRule, broken: List<Broken>): String {
            val symptom = symptom(rule, broken)
            val known = broken.filter { it.symptoms != null }
            val showing = known.count { symptom in it.symptoms.orEmpty() }
            return when {
                broken.size == 1 -> "it is the only rule that is broken"
                symptom == null -> "it fails for a reason of its own, or follows from the others"
                else -> "in $showing of ${known.size} failures ${symptom.words}"
            }
        }
    }
}
