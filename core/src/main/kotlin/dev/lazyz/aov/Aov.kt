package dev.lazyz.aov

import dev.lazyz.Counters
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.filter.SampledFrame
import dev.lazyz.world.Scene

/**
 * An arbitrary output variable (AOV): what a rendering knows about each pixel besides its colour.
 *
 * [DEPTH] to [PRIMITIVE] describe one point: that of the pixel's sample that wins the depth test, the nearest one; of
 * several, the first in rows from the top. With several samples a pixel they are not means, because a mean of two
 * surfaces is a point on neither. They, [COVERAGE] and [OVERDRAW] are the same bits for every renderer, number of
 * threads and region. A translucent surface counts like an opaque one. With a selector, the visible surface is the one
 * that the selector shows.
 *
 * @property id lower-case name, used on command lines and in files
 * @property channels names of the numbers of each pixel
 * @property isInteger whether the numbers are integers; otherwise they are of single precision
 * @property background each number of pixels in which nothing is visible
 * @property summary a description in one line
 */
public enum class Aov(
    public val id: String,
    public val channels: List<String>,
    public val isInteger: Boolean,
    public val background: Double,
    public val summary: String,
) {
    /**
     * Distance from the eye along the line of sight (not along the ray), in units of the scene. It is computed from the
     * 31-bit depth of the sample in double precision; where the depth test uses one depth for all of a primitive, from
     * [POSITION], because a sliver seen edge-on is not everywhere at that depth. So both agree, up to rounding. For
     * frames that were not set up from a scene, it is 0 at the near plane and 1 at the far plane.
     */
    DEPTH(
        "depth", listOf("z"), false, Double.POSITIVE_INFINITY,
        "distance from the camera along the line of sight, units of the scene",
    ),

    /**
     * The interpolated normal, in world space, of unit length. The normals of the vertices of a face are all reversed,
     * if necessary, so that their sum is on the side of the face that the viewer sees; an interpolated normal can still
     * point away from the viewer, near a silhouette. If the surface has no normals or flat shading, it is the normal of
     * the face, which faces the viewer. Normal maps are not applied. 0 for what has no normal: lines, points without
     * normals, drawn edges, and polygons of frames that were not set up from a scene.
     */
    NORMAL("normal", listOf("x", "y", "z"), false, 0.0, "unit normal, on the visible side of the face"),

    /** Position in world space; in pixels for what is given on the screen. 0 for drawn edges. */
    POSITION("position", listOf("x", "y", "z"), false, 0.0, "position, units of the scene"),

    /** Texture coordinates of the first set; v increases downward, as in textures. 0 for surfaces without them. */
    UV("uv", listOf("u", "v"), false, 0.0, "texture coordinates"),

    /**
     * Number of the surface in [Scene.surfaces], from 0; [AovImage.names] has their names. 0 for all primitives of a
     * frame that was not set up from a scene.
     */
    OBJECT("object", listOf("id"), true, -1.0, "number of the surface in the scene"),

    /** Submission index of the primitive, from 0: triangles, polygons, spheres, points and segments of lines. */
    PRIMITIVE("primitive", listOf("id"), true, -1.0, "number of the primitive in the frame"),

    /** The part of the pixel's own samples at which something is visible, 0..1, whatever the filter. */
    COVERAGE("coverage", listOf("a"), false, 0.0, "part of the pixel that is covered"),

    /**
     * Number of fragments: covered samples of the pixel, counted once for each primitive that covers them, whether it
     * is visible or not. A property of the frame, not of the renderer. The sum is [Counters.fragments] of renderers
     * that reject nothing. Numbers above 2^31-1 count as 2^31-1.
     */
    OVERDRAW("overdraw", listOf("n"), true, 0.0, "fragments of all surfaces"),

    /**
     * Number of shading calls at the pixel's own samples. It differs between renderers, and does not depend on their
     * number of threads. The sum is [Counters.shadingCalls], unless a filter is wider than a pixel and also needs
     * samples around the picture. Takes another rendering, with an object for each primitive.
     */
    SHADING_CALLS("shading-calls", listOf("n"), true, 0.0, "shading calls of the strategy"),
    ;

    /** Whether the numbers describe the point at the pixel's nearest sample. */
    internal val isOfPoint: Boolean get() = ordinal <= PRIMITIVE.ordinal

    public companion object {
        /** Returns the AOV with this [id], or null. */
        @JvmStatic
        public fun ofId(id: String): Aov? = entries.firstOrNull { it.id == id }

        /** Those that are known by the number of the visible primitive. */
        internal val WITHOUT_PRIMITIVES: Set<Aov> = setOf(OBJECT, PRIMITIVE, COVERAGE)

        /** Returns how many numbers an array can have at most. */
        internal const val MAX_NUMBERS: Long = Int.MAX_VALUE - 8L

        /** Throws [IllegalArgumentException] if [aov] of the pixels of [frame] does not fit into an array. */
        internal fun requireRoom(aov: Aov, frame: SampledFrame) {
            val numbers = frame.pixels.size * aov.channels.size
            require(numbers <= MAX_NUMBERS) {
                "'${aov.id}' of ${frame.pixels.width} x ${frame.pixels.height} pixels has $numbers numbers, and the " +
                    "maximum is $MAX_NUMBERS: render regions"
            }
        }
    }
}
