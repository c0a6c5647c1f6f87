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
 * @property color colour of the lines; must be opaque
 * @property hidden what happens to hidden lines
 * @throws IllegalArgumentException if [creaseAngle] or [width] is out of range, or the alpha of [color] is not 1
 */
public class EdgeStyle @JvmOverloads constructor(
    public val edges: EdgeSet = EdgeSet.FEATURES,
    public val creaseAngle: Double = FeatureEdges.DEFAULT_CREASE_ANGLE,
    public val width: Double = 1.0,
    public val color: Rgba = Rgba.BLACK,
    public val hidden: HiddenLines = HiddenLines.NONE,
) {
    init {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
        require(width > 0.0 && width <= Points.MAX_SIZE) {
            "width must be above 0 and at most ${Points.MAX_SIZE} pixels: $width"
        }
        require(color.alpha == 1f) { "color must be opaque: $color" }
    }

    /** Returns this style for other [edges]. */
    public fun withEdges(edges: EdgeSet): EdgeStyle = EdgeStyle(edges, creaseAngle, width, color, hidden)

    /** Returns this style with another angle of creases, degrees, 0..180. */
    public fun withCreaseAngle(creaseAngle: Double): EdgeStyle = EdgeStyle(edges, creaseAngle, width, color, hidden)

    /** Returns this style with another width, pixels. */
    public fun withWidth(width: Double): EdgeStyle = EdgeStyle(edges, creaseAngle, width, color, hidden)

    /** Returns this style with another colour, which must be opaque. */
    public fun withColor(color: Rgba): EdgeStyle = EdgeStyle(edges, creaseAngle, width, color, hidden)

    /** Returns this style with other [hidden] lines. */
    public fun withHidden(hidden: HiddenLines): EdgeStyle = EdgeStyle(edges, creaseAngle, width, color, hidden)

    /** Returns [scene] with its edges drawn: the same scene and, as its last surface, an [EdgeDrawing]. */
    public fun drawnOn(scene: Scene): Scene =
        scene.withSurfaces(scene.surfaces + EdgeDrawing(scene.surfaces, this))

    override fun toString(): String = "EdgeStyle($edges, creases from $creaseAngle degrees, $width pixels, $hidden)"

    public companion object {
        /** Width of hidden lines, as a part of the width of visible lines. */
        public const val HIDDEN_SHARE: Double = 0.6
    }
}
