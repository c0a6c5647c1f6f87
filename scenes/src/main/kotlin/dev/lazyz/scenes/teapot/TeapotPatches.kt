package dev.lazyz.scenes.teapot

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
