package dev.lazyz.conformance.frames

import dev.lazyz.conformance.cases.Confetti

/**
 * A difficulty that frames may have, for [FrameMix].
 *
 * @property isInSpace whether such frames are scenes before a camera; the others are given on the screen
 */
public enum class FrameKind(public val isInSpace: Boolean = false) {
    /** Three to six vertices anywhere on the 1/256 pixel grid, on and around the raster; any depths, so seldom flat. */
    SCATTERED,

    /** Vertices exactly on samples, and so many samples exactly on edges. */
    ON_SAMPLES,

    /** Vertices exactly on the corners of pixels. */
    ON_CORNERS,

    /** Triangles a few grid steps wide and any length, often steep. */
    SLIVERS,

    /** Polygons that cover a sample or two, or none. */
    TINY,

    /** Flat polygons with a notch. */
    CONCAVE,

    /** Flat polygons with a hole, or an island in the hole, by either fill rule. */
    HOLES,

    /** Flat polygons with up to eighty teeth: as many spans in a row, where the raster is wide enough. */
    COMBS,

    /** Flat polygons whose contour crosses itself: bow ties and pentagrams. */
    SELF_CROSSING,

    /** The same polygon two or three times: ties at all its samples. */
    COINCIDENT,

    /** Polygons of one of five depths, parallel to the screen: ties where they overlap. */
    COPLANAR,

    /** Triangles around a common corner, each of which shares an edge with the next. */
    SHARED_EDGES,

    /** Two flat polygons over each other that change places somewhere in the middle. */
    INTERPENETRATING,

    /** Two or three large polygons that a few units of depth part, and that cross. */
    NEARLY_COPLANAR,

    /** A slope, and levels at its nearest or farthest depth, or a unit before or behind it. */
    TOUCHING,

    /** Two to five polygons, each of which covers the whole raster. */
    LAYERED,

    /** Vertices up to the end of the guard band, 2^19 pixels away. */
    GIANT,

    /** What covers nothing: too few vertices, no area, numbers that are none. */
    DEGENERATE,

    /** [Confetti]: primitives of one's own, with many spans a row and no coherence. */
    CONFETTI,

    /** Polygons of three to five vertices in space, flat squares with holes among them. */
    POLYGONS_IN_SPACE(true),

    /** Meshes of up to six triangles. */
    MESHES(true),

    /** Spheres of any size, some around the camera. */
    SPHERES(true),

    /** Triangles from before the camera to behind it. */
    NEAR_PLANE(true),
}
