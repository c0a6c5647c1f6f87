package dev.lazyz.conformance.rules

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
