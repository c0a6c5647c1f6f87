package dev.lazyz.scenes.builtin

/**
 * The 32 bicubic patches of the Utah teapot, z up, built from [TeapotControlPoints].
 *
 * Seen from outside, u runs to the right and v runs down the chain, in every patch. Shared borders consist of the same
 * control points.
 */
internal object TeapotPatches {
    /** Rim (4), upper body (4), lower body (4), bottom (4). */
    val body: List<BezierPatch> = revolved(TeapotControlPoints.bodyRings)

    /** Knob (4), lid (4). */
    val lid: List<BezierPatch> = revolved(TeapotControlPoints.lidRings)

    /** Upper half (2), lower half (2). */
    val handle: List<BezierPatch> = swept(TeapotControlPoints.handleSections)

    /** Stem (2), lip (2). */
    val spout: List<BezierPatch> = swept(TeapotControlPoints.spoutSections)

    /** All patches: body, lid, handle, spout. */
    val all: List<BezierPatch> = body + lid + handle + spout

    /** Returns one patch per quadrant and per three rings, counter-clockwise from +x seen from above. */
    private fun revolved(rings: DoubleArray): List<BezierPatch> {
        val rows = ArrayList<Double>()
        for (at in rings.indices step 3) {
            val radius = rings[at]
            val tangent = rings[at + 1]
            val z = rings[at + 2]
            // Lay the quarter ring from +x to +y
            rows += listOf(radius, 0.0, z)
            rows += listOf(radius, tangent, z)
            rows += listOf(tangent, radius, z)
            rows += listOf(0.0, radius, z)
        }
        return patchesOf(rows).flatMap { patch ->
            val left = patch.mirrored(Axis.X)
            listOf(patch, left, left.mirrored(Axis.Y), patch.mirrored(Axis.Y))
        }
    }

    /** Returns one patch per side and per three sections, the +y side first. */
    private fun swept(sections: DoubleArray): List<BezierPatch> {
        val rows = ArrayList<Double>()
        for (at in sections.indices step 5) {
            val halfWidth = sections[at + 4]
            // Lay the half section over the side of +y
            rows += listOf(sections[at], 0.0, sections[at + 1])
            rows += listOf(sections[at], halfWidth, sections[at + 1])
            rows += listOf(sections[at + 2], halfWidth, sections[at + 3])
            rows += listOf(sections[at + 2], 0.0, sections[at + 3])
        }
        return patchesOf(rows).flatMap { patch -> listOf(patch, patch.mirrored(Axis.Y)) }
    }

    /** Splits a chain of `3 k + 1` rows into `k` patches. */
    private fun patchesOf(rows: List<Double>): List<BezierPatch> {
        val rowSize = BezierPatch.SIDE * BezierPatch.AXES
        val last = rows.size - rowSize
        return (0 until last step 3 * rowSize).map { first ->
            BezierPatch(rows.subList(first, first + BezierPatch.SIDE * rowSize).toDoubleArray())
        }
    }
}

/** A coordinate axis. */
internal enum class Axis { X, Y, Z }

/**
 * A bicubic Bezier patch: four rows of four control points, row after row, three coordinates each.
 *
 * u runs along a row, v from row to row.
 *
 * @property controlPoints the 48 coordinates; owned by the patch, must not be changed.
 */
internal class BezierPatch(val controlPoints: DoubleArray) {
    init {
        require(controlPoints.size == SIZE) { "a patch has $SIZE coordinates: ${controlPoints.size}" }
    }

    /** Returns the mirror image along [axis], with its rows reversed so that the outside stays outside. */
    fun mirrored(axis: Axis): BezierPatch {
        val image = DoubleArray(SIZE)
        for (point in 0 until SIDE * SIDE) {
            val row = point / SIDE
            val column = point % SIDE
            val from = AXES * (row * SIDE + SIDE - 1 - column)
            for (coordinate in 0 until AXES) {
                val value = controlPoints[from + coordinate]
                // Subtract instead of negating: the mirror image of 0 is 0, not -0
                image[AXES * point + coordinate] = if (coordinate == axis.ordinal) 0.0 - value else value
            }
        }
        return BezierPatch(image)
    }

    override fun toString(): String = "BezierPatch(${controlPoints.joinToString()})"

    companion object {
        /** Control points per row, and rows per patch. */
        const val SIDE: Int = 4

        /** Coordinates per control point. */
        const val AXES: Int = 3

        private const val SIZE = SIDE * SIDE * AXES
    }
}

/**
 * The published control points of the Utah teapot, z up, reduced to profiles.
 *
 * The published list has 306 control points and 32 patches of sixteen indices. The points are not independent: the
 * pot is symmetric about the plane y = 0, its body and lid also about x = 0, every ring of the body is one radius at
 * one height, and every cross-section of handle and spout is one width between two points. This object stores only
 * the independent numbers, which yield the same 32 patches, number for number. (Of the 306 points, four belong to no
 * patch, and twelve repeat the base where the bottom joins it: 290 are distinct.)
 *
 * Consecutive patches share their border row, so a chain of `3 k + 1` rows makes `k` patches.
 *
 * Heights are as published: the base is at z = 0 and the top of the knob at z = 3.15. The real porcelain pot is
 * taller by a factor of about 1.3, but the published, lower shape is the well-known one.
 *
 * Source: Martin Newell, "The Utilization of Procedure Models in Digital Image Synthesis", 1975; the numbers as
 * printed by Frank Crow, "The Origins of the Teapot", IEEE Computer Graphics and Applications, 1987. Newell's pot has
 * no underside: the four bottom patches, which are not flat, were added later.
 */
internal object TeapotControlPoints {
    /**
     * Rings from the inside of the rim over the body to the centre of the bottom: radius, tangent, height.
     *
     * The tangent gives the inner control points of a quarter circle. It is about 0.56 of the radius.
     */
    val bodyRings: DoubleArray =
        doubleArrayOf(
            // Rim
            1.4, 0.784, 2.4,
            1.3375, 0.749, 2.53125,
            1.4375, 0.805, 2.53125,
            1.5, 0.84, 2.4,
            // Upper body
            1.75, 0.98, 1.875,
            2.0, 1.12, 1.35,
            2.0, 1.12, 0.9,
            // Lower body
            2.0, 1.12, 0.45,
            1.5, 0.84, 0.225,
            1.5, 0.84, 0.15,
            // Bottom
            1.5, 0.84, 0.075,
            1.425, 0.798, 0.0,
            0.0, 0.0, 0.0,
        )

    /** Rings from the top of the knob to the edge of the lid: radius, tangent, height. */
    val lidRings: DoubleArray =
        doubleArrayOf(
            // Knob
            0.0, 0.0, 3.15,
            0.8, 0.45, 3.15,
            0.0, 0.0, 2.85,
            0.2, 0.112, 2.7,
            // Lid
            0.4, 0.224, 2.55,
            1.3, 0.728, 2.55,
            1.3, 0.728, 2.4,
        )

    /** Cross-sections of the handle, from its upper end: inner x, z, outer x, z, half the width along y. */
    val handleSections: DoubleArray =
        doubleArrayOf(
            // Upper half
            -1.6, 2.025, -1.5, 2.25, 0.3,
            -2.3, 2.025, -2.5, 2.25, 0.3,
            -2.7, 2.025, -3.0, 2.25, 0.3,
            -2.7, 1.8, -3.0, 1.8, 0.3,
            // Lower half
            -2.7, 1.575, -3.0, 1.35, 0.3,
            -2.5, 1.125, -2.65, 0.9375, 0.3,
            -2.0, 0.9, -1.9, 0.6, 0.3,
        )

    /** Cross-sections of the spout, from the body to inside the lip: upper x, z, lower x, z, half the width along y. */
    val spoutSections: DoubleArray =
        doubleArrayOf(
            // Stem
            1.7, 1.425, 1.7, 0.6, 0.66,
            2.6, 1.425, 3.1, 0.825, 0.66,
            2.3, 2.1, 2.4, 2.025, 0.25,
            2.7, 2.4, 3.3, 2.4, 0.25,
            // Lip
            2.8, 2.475, 3.525, 2.49375, 0.25,
            2.9, 2.475, 3.45, 2.5125, 0.15,
            2.8, 2.4, 3.2, 2.4, 0.15,
        )
}
