package dev.lazyz.conformance.rules

/** How binding a rule is, as in RFC 2119. */
public enum class Level {
    /** Who breaks it is no renderer: pictures, memory or promises are wrong. */
    MUST,

    /** Who breaks it gives right pictures, at a cost or in a way that users do not expect. */
    SHOULD,
}

/**
 * A rule of the contract as a test of the suite. The method's name begins with the rule's number, `rule_5_2_`.
 *
 * @property level how binding it is
 * @property intent why there is such a rule, one sentence
 * @property look what to look at in one's renderer when it fails, one sentence
 * @property about symptoms of mistakes that the rule is about, in failures of whichever rule; none if such a mistake shows
 *   only by what this rule does, as when it calls a renderer from several threads
 */
@Target(AnnotationTarget.FUNCTION)
@Retention(AnnotationRetention.RUNTIME)
@MustBeDocumented
public annotation class Rule(
    val level: Level = Level.MUST,
    val intent: String,
    val look: String,
    val about: Array<Symptom> = [],
)
