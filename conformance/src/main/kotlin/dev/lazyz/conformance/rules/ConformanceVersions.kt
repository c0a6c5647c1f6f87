package dev.lazyz.conformance.rules

/**
 * Versions of the contract and the suite.
 *
 * A renderer conforms to a version of the suite; later versions may have more rules. `docs/conformance.md`
 * lists the rules of each version.
 */
public object ConformanceVersions {
    /** Version of `docs/contract.md`. It changes when a rule is changed or added. */
    public const val CONTRACT: String = "0.1"

    /** Version of the suite. It changes when the test of a rule is added, renamed or removed. */
    public const val SUITE: String = "0.2"
}
