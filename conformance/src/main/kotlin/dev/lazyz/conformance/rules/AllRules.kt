package dev.lazyz.conformance.rules

/**
 * All rules of the suite, part by part. Extend `RendererConformance` to try them, not this class.
 *
 * A new part is one more name in this list; no part knows another.
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
    TidyRules
