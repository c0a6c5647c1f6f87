package dev.lazyz.conformance.census

/** What a frame may have that makes it worth trying, for [Distribution]. */
public enum class FrameTrait(internal val words: String) {
    /** There are no primitives. */
    NO_PRIMITIVES("no primitives"),

    /** Every sample shows the background. */
    NOTHING_VISIBLE("nothing is visible"),

    /** Two primitives or more are visible. */
    SEVERAL_VISIBLE("several primitives are visible"),

    /** At some sample two primitives have the same, winning depth. */
    TIE("a tie at the winning depth"),

    /** At some sample a primitive is hidden by another or by the background. */
    HIDDEN("something is hidden"),

    /** Of two primitives each is before the other somewhere. */
    CROSSING("two primitives cross"),

    /** In some row a primitive begins where another ends, as on a shared edge. */
    MEETING("two primitives meet"),

    /** Some sample is covered by more than eight primitives. */
    DEEP("more than 8 primitives at a sample"),

    /** Some primitive has more than six spans in a row. */
    MANY_SPANS("more than 6 spans in a row"),

    /** Only a part of the raster is asked for. */
    REGION("a region"),

    /** More than 64 columns or rows are asked for. */
    SEVERAL_TILES("more than 64 columns or rows"),

    /** Some primitive is translucent. */
    TRANSLUCENT("translucency"),

    /** Some primitive's depth is no linear form. */
    FORMLESS("depth without a linear form"),

    /** The raster has one row or one column. */
    NARROW("one row or one column"),

    /** The depth test is `LESS`. */
    LESS("the depth test LESS"),

    /** The depth test is `LESS_OR_EQUAL`. */
    LESS_OR_EQUAL("the depth test LESS_OR_EQUAL"),

    /** The depth test is `GREATER`. */
    GREATER("the depth test GREATER"),

    /** The depth test is `GREATER_OR_EQUAL`. */
    GREATER_OR_EQUAL("the depth test GREATER_OR_EQUAL"),

    /** The convention is `SMALLER_IS_NEARER`. */
    SMALLER_IS_NEARER("smaller depth is nearer"),

    /** The convention is `LARGER_IS_NEARER`. */
    LARGER_IS_NEARER("larger depth is nearer"),

    /** The background is not behind everything. */
    BACKGROUND_DEPTH("a background that is not behind everything"),

    /** A mesh of a scene. */
    MESH("a mesh"),

    /** A sphere of a scene. */
    SPHERE("a sphere"),

    /** A scene with lights of its own. */
    LIT("lights"),

    /** A texture on a surface of a scene. */
    TEXTURED("a texture"),

    /** A mask on a surface of a scene. */
    MASKED("a mask"),

    /** A polygon or triangle of a scene has vertices on both sides of the near plane. */
    NEAR_PLANE("something across the near plane"),

    /** The renderer has been given options or a selector, or is used in another special way. */
    CONFIGURED("a renderer with options"),
}
