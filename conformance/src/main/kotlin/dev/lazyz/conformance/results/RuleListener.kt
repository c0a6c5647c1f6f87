package dev.lazyz.conformance.results

/** Receives the outcome of each rule as soon as the rule has ended, from `Conformance` or `Supervision`. */
public fun interface RuleListener {
    /**
     * Called when [rule] has ended. Called once for each rule, in the thread that runs or supervises the suite. Must
     * not throw.
     *
     * @param milliseconds duration of the rule
     */
    public fun ended(rule: SuiteRule, outcome: RuleOutcome, milliseconds: Long)
}
