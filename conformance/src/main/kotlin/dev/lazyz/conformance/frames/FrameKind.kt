package dev.lazyz.conformance.frames

import dev.lazyz.conformance.cases.Confetti

/**
 * A kind of frames that are difficult to render, see [FrameMix].
 *
 * @property isInSpace whether such frames are 3D scenes seen through a camera; the others are in screen space
 */
public enum class FrameKind(public val isInSpace: Boolean = false) {
    /**
     * Three to six vertices anywhere on the 1/256 pixel grid, on and around the raster, with any depths, so rarely
     * flat.
     */
    SCATTERED,

    /** Vertices exactly on samples, so that many samples are exactly on edges. */
    ON_SAMPLES,

    /** Vertices exactly on the corners of pixels. */
    ON_CORNERS,

    /** Triangles a few grid steps wide and of any length, often steep. */
    SLIVERS,

    /** Polygons that cover one or two samples, or none. */
    TINY,

    /** Flat polygons with a notch. */
    CONCAVE,

    /** Flat polygons with a hole, or an island in the hole, with either fill rule. */
    HOLES,

    /** Flat polygons with up to eighty teeth, and as many spans in a row, if the raster is wide enough. */
    COMBS,

    /** Flat polygons whose contour intersects itself: bow ties and pentagrams. */
    SELF_CROSSING,

    /** The same polygon two or three times: ties at all its samples. */
    COINCIDENT,

    /** Polygons at one of five depths, parallel to the screen: ties where they overlap. */
    COPLANAR,

    /** Triangles around a common vertex, each of which shares an edge with the next. */
    SHARED_EDGES,

    /** Two flat polygons that intersect somewhere in the middle. */
    INTERPENETRATING,

    /** Two or three large polygons whose depths differ by a few units, and that intersect. */
    NEARLY_COPLANAR,

    /**
     * A slope, and polygons of constant depth at its nearest or farthest depth, or one unit in front of or behind it.
     */
    TOUCHING,

    /** Two to five polygons that cover the whole raster. */
    LAYERED,

    /** Vertices up to the limit of the guard band, 2^19 pixels away. */
    GIANT,

    /** Polygons that cover nothing: too few vertices, no area, NaN or infinite numbers. */
    DEGENERATE,

    /** [Confetti]: custom primitives, with many spans in a row and no coherence. */
    CONFETTI,

    /** Polygons of three to five vertices in world space, and flat squares with holes. */
    POLYGONS_IN_SPACE(true),

    /** Meshes of up to six triangles. */
    MESHES(true),

    /** Spheres of any size, some around the camera. */
    SPHERES(true),

    /** Triangles that extend from in front of the camera to behind it. */
    NEAR_PLANE(true),

    /** Clouds of points, of less than a pixel to more than a tile. */
    POINTS(true),

    /** Lines, mostly polylines, as wide as the points. */
    LINES(true),
}
