package dev.lazyz.conformance.rules

import dev.lazyz.Capability
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.judgement.requireDeclared
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.Property

/** How binding a rule is, as in RFC 2119. */
public enum class Level {
    /** A renderer that breaks the rule does not conform: pictures, memory or declared capabilities are wrong. */
    MUST,

    /** A renderer that breaks the rule renders correct pictures, but at a cost or in a way that users do not expect. */
    SHOULD,
}

/**
 * Marks a test of the suite, which is a property of jqwik, as a rule of the contract. The method's name begins with the
 * rule's number, `rule_5_2_`.
 *
 * @property level how binding the rule is
 * @property intent why the rule exists, in one sentence
 * @property look where to look in the renderer when the rule fails, in one sentence
 * @property about symptoms of the mistakes that this rule tests for, as seen in failures of any rule; empty if such a
 *   mistake shows only in what this rule does, for example when it calls a renderer from several threads
 * @property isSpecial whether the rule tests what is rare, such as extreme values or threads, or many things at once;
 *   where another rule is as likely the cause, that one is named first
 * @property tries how often it is tried by default, each time with other parameters; once if it has none
 */
@Property(seed = FIXED, edgeCases = EdgeCasesMode.NONE)
@Target(AnnotationTarget.FUNCTION)
@Retention(AnnotationRetention.RUNTIME)
@MustBeDocumented
public annotation class Rule(
    val level: Level = Level.MUST,
    val intent: String,
    val look: String,
    val about: Array<Symptom> = [],
    val isSpecial: Boolean = false,
    val tries: Int = 100,
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

/** Returns the renderer to test; if it does not declare all of [needs], ends the rule, as not applicable. */
internal fun RulesForOne.renderer(vararg needs: Capability): Renderer =
    renderer().also { for (need in needs) requireDeclared(it, need) }

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

/**
 * What a failure looks like. [Rule.about] lists the symptoms that a rule tests for. `Diagnosis` uses them to find which
 * of the failing rules to look at first.
 */
public enum class Symptom(
    /** The symptom in words, as reported. */
    internal val words: String,
    /** Estimated share of failures, from mistakes of any kind, that show this symptom by chance. */
    internal val rate: Double,
) {
    /** The renderer renders a wrong picture, or throws an exception that is no error when it renders. */
    PICTURE("the picture itself is wrong", 0.9),

    /** The renderer throws. */
    EXCEPTION("the renderer throws", 0.1),

    /** Rows are missing, come twice or in another order. */
    ROWS("rows are missing or not in order", 0.05),

    /** The picture is correct, but something else is not. */
    COUNTERS("the picture is correct, but something else is wrong", 0.1),

    /**
     * A primitive is visible where it covers nothing, or the background is visible where a primitive passes the depth
     * test.
     */
    COVERAGE("the wrong samples are covered", 0.4),

    /** Two primitives cover the sample at different depths, and the wrong one is visible. */
    ORDER("the wrong one of two different depths wins", 0.2),

    /** At the sample that differs, two primitives have the winning depth. */
    TIE("two primitives have the same depth where the picture is wrong", 0.15),

    /** The background has a depth of its own or the same depth as a primitive, and the wrong one of the two wins. */
    BACKGROUND("the background's depth decides where the picture is wrong", 0.1),

    /** The correct primitive is visible, but its depth is wrong. */
    DEPTH("the correct primitive has a wrong depth", 0.2),

    /** Primitives and depths are correct, but colours are wrong. */
    COLOR("only colours are wrong", 0.15),

    /** The raster requests a depth test other than the default one of its convention. */
    DEPTH_TEST("the depth test is not the default one", 0.25),

    /** The convention says that smaller depths are nearer, and the greatest depth wins, or the other way round. */
    AGAINST_CONVENTION("the depth test contradicts the convention", 0.1),

    /** The greatest depth wins. */
    GREATEST_WINS("the greatest depth wins", 0.5),

    /** Only a part of the raster is requested. */
    REGION("only a region of the raster is rendered", 0.1),

    /** At least one primitive is translucent. */
    TRANSLUCENT("a primitive is translucent", 0.1),

    /** The frame has custom primitives, with many spans in a row or without a linear form. */
    OWN_PRIMITIVE("the frame has custom primitives", 0.3),

    /** The frame is a 3D scene seen through a camera. */
    IN_SPACE("the frame is a 3D scene seen through a camera", 0.25),

    /** The frame has no primitives. */
    NO_PRIMITIVES("the frame has no primitives", 0.1),

    /** At least one primitive covers nothing. */
    EMPTY_PRIMITIVE("a primitive covers nothing", 0.45),

    /** There are more primitives than a 16-bit index can number. */
    MANY_PRIMITIVES("the frame has tens of thousands of primitives", 0.03),

    /** The raster has one row or one column. */
    NARROW("the raster has one row or one column", 0.15),

    /** The renderer is configured with options. */
    OPTIONS("the renderer is configured with options", 0.1),

    /** The same renderer instance has already rendered another frame in the same try. */
    AGAIN("the renderer has rendered another frame before", 0.3),
}
