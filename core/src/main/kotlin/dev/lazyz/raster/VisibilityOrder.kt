package dev.lazyz.raster

import dev.lazyz.DepthTest
import dev.lazyz.Primitive

/**
 * The order of fragments that a [DepthTest] makes, asked about whole primitives: by their bounds, and by linear forms.
 *
 * Shared by the renderers that decide many samples at a time. Immutable and thread safe.
 *
 * Why two samples can decide all between them. Let the forms of two primitives have the values f and b at a sample that
 * both cover, and call b - f (f - b where the greatest depth wins) the *lead* of the first. Depth is the value without
 * its lower 32 bits, rounded down; ties go by submission index. So, at one sample:
 *
 * - lead >= 0 implies that the depth of the first is not behind: rounding down keeps an order (and where the greatest
 *   depth wins, depths compare as their values do, the other way round). If the first also wins ties, it is visible.
 * - lead >= 2^32 implies that the depth of the first is at least one unit before the other, whoever wins ties.
 *
 * That is [leastLead]. The lead of two linear forms is a linear form, so its minimum over samples in a row, or over a
 * convex set of samples, is at an end or a corner: what has the least lead there has it everywhere, and is visible
 * everywhere. Nothing wraps: at covered samples a value is in 0 until 2^63, so a difference of two is exact in 64 bits;
 * and the sum of a form's value and its step at neighbours that are both covered is the true sum, for two numbers below
 * 2^63 that are equal modulo 2^64 are equal.
 */
internal class VisibilityOrder(private val test: DepthTest) {
    /** Whether the greatest depth wins. */
    private val isReversed = test.key(1, 0) < test.key(0, 0)

    /** Returns a key that no fragment of [primitive] is before. */
    fun nearestKey(primitive: Primitive, index: Int): Long =
        test.key(if (isReversed) primitive.greatestDepth else primitive.leastDepth, index)

    /** Returns a key that no fragment of [primitive] is behind. */
    fun farthestKey(primitive: Primitive, index: Int): Long =
        test.key(if (isReversed) primitive.leastDepth else primitive.greatestDepth, index)

    /** Returns the key of a fragment of the primitive [index], whose form has the value [value] there. */
    fun key(value: Long, index: Int): Long = test.key((value shr 32).toInt(), index)

    /** Returns how far the form's value [front] is before the value [behind] at the same sample, covered by both. */
    fun lead(front: Long, behind: Long): Long = if (isReversed) front - behind else behind - front

    /** Returns the lead that implies that the primitive [front] is visible, not the primitive [behind]. */
    fun leastLead(front: Int, behind: Int): Long = if (test.key(0, front) < test.key(0, behind)) 0 else UNIT

    private companion object {
        /** One unit of depth, as a linear form counts: with 32 bits of fraction. */
        const val UNIT = 1L shl 32
    }
}
