package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.rules.AllRules
import dev.lazyz.conformance.rules.ChangeRules
import dev.lazyz.conformance.rules.CombinationRules
import dev.lazyz.conformance.rules.CounterRules
import dev.lazyz.conformance.rules.PictureRules
import dev.lazyz.conformance.rules.PointRules
import dev.lazyz.conformance.rules.PromiseRules
import dev.lazyz.conformance.rules.Rule
import dev.lazyz.conformance.rules.SelectionRules
import dev.lazyz.conformance.rules.ShadingRules
import dev.lazyz.conformance.rules.SizeRules
import dev.lazyz.conformance.rules.StreamingRules
import dev.lazyz.conformance.rules.ThreadRules
import dev.lazyz.conformance.rules.TidyRules
import dev.lazyz.conformance.rules.UseRules
import dev.lazyz.conformance.rules.WorkerRules
import dev.lazyz.conformance.run.Effort
import dev.lazyz.conformance.run.SuiteProperties
import net.jqwik.api.lifecycle.AddLifecycleHook
import net.jqwik.api.lifecycle.PropagationMode

/**
 * The conformance suite as a test class: extend it, return your renderer, and run it with jqwik.
 *
 * Each test is a rule of `docs/contract.md` and carries its number. [Rule] contains how binding it is, why it exists,
 * and where to look when it fails. Frames are random but the same in every run. A frame that fails is shrunk, and
 * printed as the code that creates it, with the first sample that differs and both values. It is also saved as code, as
 * a scene file if that format can express it, and as pictures. The system property [OUTPUT] names the folder; the
 * default is `lazyz-conformance` in `target`, `build`, or the folder for temporary files.
 *
 * The system property [TRIES] multiplies the number of frames (`-Dlazyz.conformance.tries=100` for a run over night,
 * `0.1` while debugging), and [SEED] chooses other frames. Cost: ten to thirty seconds; most rules use one thread.
 *
 * The rules are grouped by topic: [PictureRules], [PointRules], [ShadingRules], [SizeRules], [CombinationRules],
 * [ChangeRules], [UseRules], [ThreadRules], [WorkerRules], [CounterRules], [PromiseRules], [SelectionRules],
 * [StreamingRules] and [TidyRules]. Extend this class, not those.
 */
@AddLifecycleHook(value = Effort::class, propagateTo = PropagationMode.ALL_DESCENDANTS)
public abstract class RendererConformance : AllRules() {
    /**
     * Returns the renderer to test: either a new instance or always the same one. Called once for each try of each
     * rule.
     */
    public abstract override fun renderer(): Renderer

    /**
     * Returns your own frames to test, in addition to those of the folder that [FRAMES] names; by default none. Each
     * frame is rendered as a whole and in part, and must be correct. Called once.
     */
    public override fun frames(): List<FrameCase> = emptyList()

    public companion object {
        /** System property: a positive decimal number that multiplies the number of frames of each rule. */
        public const val TRIES: String = SuiteProperties.TRIES

        /** System property: a whole number that replaces the suite's fixed seed. */
        public const val SEED: String = SuiteProperties.SEED

        /**
         * System property: deadline of a rendering in seconds of processor time, a positive decimal number; by default
         * 20. A rule with a rendering that takes longer has timed out, and the next rule is run. If ten times as long
         * passes on the clock on the wall, the rule is inconclusive, which is an error, not a failure.
         */
        public const val DEADLINE: String = SuiteProperties.DEADLINE

        /**
         * System property: a folder of scene files and meshes that the suite also tests, and to which it adds the
         * frames on which rules fail. The folder is created if it does not exist.
         */
        public const val FRAMES: String = SuiteProperties.FRAMES

        /**
         * System property: the folder in which frames that fail are saved, in a subfolder with the name of the test
         * class.
         */
        public const val OUTPUT: String = SuiteProperties.OUTPUT
    }
}
