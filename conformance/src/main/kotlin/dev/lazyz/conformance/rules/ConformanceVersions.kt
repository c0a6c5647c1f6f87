package dev.lazyz.conformance.rules

/**
 * Versions of what renderers are held to.
 *
 * A renderer conforms to a version of the suite: later versions may have more rules. `docs/conformance-versions.md`
 * lists the rules of each.
 */
public object ConformanceVersions {
    /** Version of `docs/contract.md`: it changes when a rule does, or there is a new one. */
    public const val CONTRACT: String = "0.1"

    /** Version of the suite: it changes when a rule's test is added, renamed or removed. */
    public const val SUITE: String = "0.1"
}
