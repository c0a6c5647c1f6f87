package dev.lazyz.conformance.results

/** Learns what came of each rule as soon as it has been tried: of `Conformance` or `Supervision`. */
public fun interface RuleListener {
    /**
     * [rule] has come to its end. Called once for each rule, in the thread that runs the suite or waits for it. Throws
     * nothing.
     *
     * @param milliseconds how long it took
     */
    public fun ended(rule: SuiteRule, outcome: RuleOutcome, milliseconds: Long)
}
