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
import dev.lazyz.conformance.rules.ShadingRules
import dev.lazyz.conformance.rules.SizeRules
import dev.lazyz.conformance.rules.ThreadRules
import dev.lazyz.conformance.rules.TidyRules
import dev.lazyz.conformance.rules.UseRules
import dev.lazyz.conformance.rules.WorkerRules
import dev.lazyz.conformance.run.Effort
import dev.lazyz.conformance.run.SuiteProperties
import net.jqwik.api.lifecycle.AddLifecycleHook
import net.jqwik.api.lifecycle.PropagationMode

/**
 * The suite that every renderer must pass: extend it in a test, say which renderer, and run it with jqwik.
 *
 * Every test is a rule of `docs/contract.md` and carries its number; [Rule] says how binding it is, why there is such a
 * rule, and what to look at when it fails. Frames are random but the same at every run; one that fails is shrunk, and
 * printed as the code that makes it, with the first sample that differs and both answers. It is kept besides, as code, as
 * a scene file where there are words for it, and as pictures: in the folder that the system property [OUTPUT] names, by
 * default `lazyz-conformance` in `target`, `build`, or the folder for temporary files.
 *
 * The system property [TRIES] multiplies the number of frames (`-Dlazyz.conformance.tries=100` for a night, `0.1` while
 * debugging), and [SEED] chooses others. Cost: a few seconds for a renderer, in one thread but for few rules.
 *
 * The rules are by theme: [PictureRules], [PointRules], [ShadingRules], [SizeRules], [CombinationRules], [ChangeRules],
 * [UseRules], [ThreadRules], [WorkerRules], [CounterRules], [PromiseRules] and [TidyRules]. Extend this class, not those.
 */
@AddLifecycleHook(value = Effort::class, propagateTo = PropagationMode.ALL_DESCENDANTS)
public abstract class RendererConformance : AllRules() {
    /** Returns the renderer to judge, a new one or always the same. Called once for each try of each rule. */
    public abstract override fun renderer(): Renderer

    /**
     * Returns frames of one's own to try besides those of the folder that [FRAMES] names, none unless overridden: each
     * must come out right, as a whole and in part. Called once.
     */
    public override fun frames(): List<FrameCase> = emptyList()

    public companion object {
        /** System property: a positive decimal number that multiplies the number of frames each rule is tried on. */
        public const val TRIES: String = SuiteProperties.TRIES

        /** System property: a whole number that replaces the suite's fixed seed. */
        public const val SEED: String = SuiteProperties.SEED

        /**
         * System property: a positive decimal number, the seconds after which a try counts as hanging; by default 20. The
         * rule has timed out then, and the next one is tried.
         */
        public const val DEADLINE: String = SuiteProperties.DEADLINE

        /**
         * System property: a folder of scene files and meshes that the suite tries too, and to which it adds the frames
         * that rules fail on. It is made if it is not there.
         */
        public const val FRAMES: String = SuiteProperties.FRAMES

        /** System property: the folder in which frames that fail are kept, in a folder of the test class's name. */
        public const val OUTPUT: String = SuiteProperties.OUTPUT
    }
}
