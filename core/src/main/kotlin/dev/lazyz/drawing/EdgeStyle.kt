package dev.lazyz.drawing

import dev.lazyz.Rgba
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Points

/**
 * How the edges of a scene are drawn. Immutable and thread safe.
 *
 * ```
 * val drawing = EdgeStyle().withWidth(1.5).drawnOn(scene)
 * ```
 *
 * @property edges which edges
 * @property creaseAngle see [FeatureEdges]; degrees, 0..180
 * @property width width of visible lines, pixels, above 0 and at most [Points.MAX_SIZE]; widths below one sample count
 *   as one sample. Hidden lines have [HIDDEN_SHARE] of this width
 * @property color colour of visible lines; must be opaque
 * @property hidden what happens to hidden lines
 * @property hiddenColor colour of hidden lines; must be opaque. Default: [HIDDEN_GREY]
 * @property hiddenBehind hidden lines are drawn where at most this many faces hide them, at least 1; by default any
 *   number. A solid before a line hides it by two faces, the front and the back, unless its material has only fronts.
 *   The number is the quantitative invisibility of Arthur Appel, "The notion of quantitative invisibility and the
 *   machine rendering of solids", ACM National Conference (1967)
 * @throws IllegalArgumentException if [creaseAngle], [width] or [hiddenBehind] is out of range, or the alpha of a
 *   colour is not 1
 */
public class EdgeStyle @JvmOverloads constructor(
    public val edges: EdgeSet = EdgeSet.FEATURES,
    public val creaseAngle: Double = FeatureEdges.DEFAULT_CREASE_ANGLE,
    public val width: Double = 1.0,
    public val color: Rgba = Rgba.BLACK,
    public val hidden: HiddenLines = HiddenLines.NONE,
    public val hiddenColor: Rgba = HIDDEN_GREY,
    public val hiddenBehind: Int = Int.MAX_VALUE,
) {
    init {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
        require(width > 0.0 && width <= Points.MAX_SIZE) {
            "width must be above 0 and at most ${Points.MAX_SIZE} pixels: $width"
        }
        require(color.alpha == 1f) { "color must be opaque: $color" }
        require(hiddenColor.alpha == 1f) { "hiddenColor must be opaque: $hiddenColor" }
        require(hiddenBehind >= 1) { "hiddenBehind must be at least 1: $hiddenBehind" }
    }

    /** Returns this style for other [edges]. */
    public fun withEdges(edges: EdgeSet): EdgeStyle = copy(edges = edges)

    /** Returns this style with another angle of creases, degrees, 0..180. */
    public fun withCreaseAngle(creaseAngle: Double): EdgeStyle = copy(creaseAngle = creaseAngle)

    /** Returns this style with another width, pixels. */
    public fun withWidth(width: Double): EdgeStyle = copy(width = width)

    /** Returns this style with another colour of visible lines, which must be opaque. */
    public fun withColor(color: Rgba): EdgeStyle = copy(color = color)

    /** Returns this style with other [hidden] lines. */
    public fun withHidden(hidden: HiddenLines): EdgeStyle = copy(hidden = hidden)

    /** Returns this style with another colour of [hidden] lines, which must be opaque. */
    public fun withHiddenColor(hiddenColor: Rgba): EdgeStyle = copy(hiddenColor = hiddenColor)

    /** Returns this style with [hidden] lines only where at most this many faces hide them, at least 1. */
    public fun withHiddenBehind(hiddenBehind: Int): EdgeStyle = copy(hiddenBehind = hiddenBehind)

    private fun copy(
        edges: EdgeSet = this.edges,
        creaseAngle: Double = this.creaseAngle,
        width: Double = this.width,
        color: Rgba = this.color,
        hidden: HiddenLines = this.hidden,
        hiddenColor: Rgba = this.hiddenColor,
        hiddenBehind: Int = this.hiddenBehind,
    ): EdgeStyle = EdgeStyle(edges, creaseAngle, width, color, hidden, hiddenColor, hiddenBehind)

    /** Returns [scene] with its edges drawn: the same scene and, as its last surface, an [EdgeDrawing]. */
    public fun drawnOn(scene: Scene): Scene =
        scene.withSurfaces(scene.surfaces + EdgeDrawing(scene.surfaces, this))

    override fun toString(): String = "EdgeStyle($edges, creases from $creaseAngle degrees, $width pixels, $hidden)"

    /** Which edges of meshes are drawn. */
    public enum class EdgeSet {
        /** Silhouettes, creases and boundaries, see [FeatureEdges]. */
        FEATURES,

        /** All edges of all triangles. */
        ALL,
    }

    /** What happens to the parts of edges that a surface hides. `HiddenParts` finds these parts. */
    public enum class HiddenLines {
        /** They are not drawn. */
        NONE,

        /** They are drawn dashed, thinner than the visible parts. */
        DASHED,

        /** They are drawn solid, thinner than the visible parts. */
        SOLID,
    }

    public companion object {
        /** Width of hidden lines, as a part of the width of visible lines. */
        public const val HIDDEN_SHARE: Double = 0.6

        /** The colour of hidden lines if the caller does not choose: grey, sRGB `#a0a0a0`. */
        @JvmField
        public val HIDDEN_GREY: Rgba = Rgba.ofRgb(0xA0A0A0)
    }
}
