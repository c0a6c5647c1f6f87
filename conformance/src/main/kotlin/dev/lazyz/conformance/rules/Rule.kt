package dev.lazyz.conformance.rules

/** How binding a rule is, as in RFC 2119. */
public enum class Level {
    /** A renderer that breaks the rule does not conform: pictures, memory or declared capabilities are wrong. */
    MUST,

    /** A renderer that breaks the rule renders correct pictures, but at a cost or in a way that users do not expect. */
    SHOULD,
}

/**
 * Marks a test of the suite as a rule of the contract. The method's name begins with the rule's number, `rule_5_2_`.
 * @property level how binding the rule is
 * @property intent why the rule exists, in one sentence
 * @property look where to look in the renderer when the rule fails, in one sentence
 * @property about symptoms of the mistakes that this rule tests for, as seen in failures of any rule; empty if such a
 *   mistake shows only in what this rule does, for example when it calls a renderer from several threads
 * @property isSpecial whether the rule tests what is rare, such as extreme values or threads, or many things at once;
 *   where another rule is as likely the cause, that one is named first
 */
@Target(AnnotationTarget.FUNCTION)
@Retention(AnnotationRetention.RUNTIME)
@MustBeDocumented
public annotation class Rule(
    val level: Level = Level.MUST,
    val intent: String,
    val look: String,
    val about: Array<Symptom> = [],
    val isSpecial: Boolean = false,
)
