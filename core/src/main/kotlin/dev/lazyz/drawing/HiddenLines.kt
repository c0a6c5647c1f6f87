package dev.lazyz.drawing

/** What happens to the parts of edges that a surface hides. `HiddenParts` finds these parts. */
public enum class HiddenLines {
    /** They are not drawn. */
    NONE,

    /** They are drawn dashed, thinner than the visible parts. */
    DASHED,

    /** They are drawn solid, thinner than the visible parts. */
    SOLID,
}
