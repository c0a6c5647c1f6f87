package dev.lazyz.conformance.rules

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase

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

/**
 * All rules of the suite, grouped into parts. Extend `RendererConformance` to run them, not this class.
 *
 * To add a part, add its name to this list. Parts do not depend on each other.
 */
public abstract class AllRules internal constructor() :
    PictureRules,
    PointRules,
    ShadingRules,
    SizeRules,
    CombinationRules,
    ChangeRules,
    UseRules,
    ThreadRules,
    WorkerRules,
    CounterRules,
    PromiseRules,
    SelectionRules,
    StreamingRules,
    TidyRules

/** The suite's default seed. Each rule's own seed is computed from this seed and the rule's name. */
internal const val FIXED: String = "1995"

/** A part of the suite's rules for one renderer. [AllRules] combines all parts. */
public sealed interface RulesForOne {
    /**
     * Returns the renderer to test: either a new instance or always the same one. Called once for each try of each
     * rule.
     */
    public fun renderer(): Renderer

    /** Returns the user's own frames, in addition to those of the suite. */
    public fun frames(): List<FrameCase>
}
