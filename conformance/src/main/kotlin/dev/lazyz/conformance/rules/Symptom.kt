package dev.lazyz.conformance.rules

/**
 * What a failure looks like. [Rule.about] says which symptoms a rule is about, and `Diagnosis` finds by them which of
 * the rules that fail is the one to look at first.
 */
public enum class Symptom(
    /** What it says of a failure, in words. */
    internal val words: String,
    /** The share of failures, of mistakes of any kind, that show it by chance: an estimate. */
    internal val rate: Double,
) {
    /** The renderer gives a wrong picture, or throws, when it is asked for a picture. */
    PICTURE("the picture itself is wrong", 0.9),

    /** The renderer throws. */
    EXCEPTION("the renderer throws", 0.1),

    /** Rows are missing. */
    ROWS("rows are missing", 0.05),

    /** The picture is right, and something else is not. */
    COUNTERS("the picture is right, and something besides it is not", 0.1),

    /** A primitive is shown where it covers nothing, or the background where a primitive passes the depth test. */
    COVERAGE("it is about which samples are covered", 0.4),

    /** Of two primitives that cover the sample, the wrong one is shown, and their depths differ. */
    ORDER("of two depths that differ the wrong one wins", 0.2),

    /** At the sample that differs, two primitives have the depth that wins. */
    TIE("two primitives have the same depth where the picture is wrong", 0.15),

    /** The background competes with a depth of its own, or with the same depth, and the wrong one wins. */
    BACKGROUND("the background's depth decides where the picture is wrong", 0.1),

    /** The right primitive is shown, at a wrong depth. */
    DEPTH("the right primitive has a wrong depth", 0.2),

    /** Primitives and depths are right, and colours are not. */
    COLOR("only colours are wrong", 0.15),

    /** The raster asks for another depth test than the usual one of its convention. */
    DEPTH_TEST("the depth test is not the usual one", 0.25),

    /** The greatest depth wins. */
    GREATEST_WINS("the depth test is one by which the greatest depth wins", 0.5),

    /** Only a part of the raster is asked for. */
    REGION("only a part of the raster is asked for", 0.1),

    /** Some primitive is translucent. */
    TRANSLUCENT("some primitive is translucent", 0.1),

    /** The frame has primitives of one's own, with many spans a row or without a linear form. */
    OWN_PRIMITIVE("the frame has primitives of one's own", 0.3),

    /** The frame is a scene before a camera. */
    IN_SPACE("the frame is a scene before a camera", 0.25),

    /** The frame has no primitives. */
    NO_PRIMITIVES("the frame has no primitives", 0.1),

    /** Some primitive covers nothing. */
    EMPTY_PRIMITIVE("some primitive covers nothing", 0.45),

    /** There are more primitives than 16 bits can number. */
    MANY_PRIMITIVES("the frame has tens of thousands of primitives", 0.03),

    /** The raster has one row or one column. */
    NARROW("the raster has one row or one column", 0.15),

    /** The renderer is configured with options. */
    OPTIONS("the renderer is configured with options", 0.1),

    /** The same renderer has rendered another frame before, in the same try. */
    AGAIN("the renderer has rendered something before", 0.3),
}
