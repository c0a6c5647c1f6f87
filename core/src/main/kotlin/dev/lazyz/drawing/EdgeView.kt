package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.Workers
import dev.lazyz.drawing.EdgeDrawing.LineKind
import dev.lazyz.drawing.EdgeStyle.EdgeSet

/**
 * The edges of [model] in one view: which of them are drawn, and which parts of them are hidden. Used once; not thread
 * safe, but uses the threads of [workers]. The result does not depend on them.
 *
 * @param tolerance see [HiddenParts], world units
 * @param checkpoint that of the calling thread, passed for each point and edge
 * @param margin how far outside the raster a line can be and still cover a part of it, pixels
 */
internal class EdgeView(
    private val model: EdgeModel,
    private val facing: Facing,
    private val space: ViewSpace,
    private val tolerance: Double,
    private val margin: Double,
    private val workers: Workers,
    private val checkpoint: Checkpoint,
) {
    private val places = DoubleArray(4 * model.pointCount)
    private val grid: FaceGrid

    /** By polygon of the model: what it hides with; null if it hides nothing. */
    private val polygons: List<HidingPolygon?>

    /** The parts of the edges that are visible. */
    val visible: Pieces = Pieces()

    /** The parts that are hidden. */
    val hidden: Pieces = Pieces()

    init {
        val p = model.points
        for (point in 0 until model.pointCount) {
            checkpoint.pass()
            val at = 3 * point
            space.place(p[at].toDouble(), p[at + 1].toDouble(), p[at + 2].toDouble(), places, 4 * point)
        }
        polygons = model.polygons.mapIndexed { i, polygon ->
            if (facing.isHiding(model.triangleCount + i)) HidingPolygon.of(polygon, places, space) else null
        }
        grid = FaceGrid(space, model, facing, places, polygons, margin, checkpoint)
    }

    /**
     * Divides the drawn edges of the set [edges] into visible and hidden parts. Edges of faces that are not drawn,
     * because they show their backs, have no visible parts.
     *
     * @param hiddenBehind parts that more faces hide are not needed
     */
    fun divide(edges: EdgeSet, hiddenBehind: Int) {
        val drawn = (0 until model.edgeCount).filter { isIn(edges, it) && (hiddenBehind > 0 || facing.isDrawn(it)) }
        val chunks = List((drawn.size + CHUNK - 1) / CHUNK) { Chunk(hiddenBehind) }
        workers.forEach(chunks.size, checkpoint) { number, own ->
            for (i in number * CHUNK until minOf((number + 1) * CHUNK, drawn.size)) {
                own.pass()
                chunks[number].divide(drawn[i])
            }
        }
        for (chunk in chunks) {
            visible.addAll(chunk.visible)
            hidden.addAll(chunk.hidden)
        }
    }

    private fun isIn(edges: EdgeSet, edge: Int): Boolean =
        edges == EdgeSet.ALL || model.isFeature(edge) || facing.isSilhouette(edge)

    /** Some of the edges, for one thread. */
    private inner class Chunk(private val hiddenBehind: Int) {
        val visible = Pieces()
        val hidden = Pieces()
        private val isCounted = hiddenBehind in 1 until Int.MAX_VALUE
        private val parts = HiddenParts(space, places, tolerance, isCounted)

        /** The parts that too many faces hide. */
        private val deep = Intervals()

        // The part of the edge that is on the raster and between the near and the far plane
        private val part = KeptPart()
        private var kind = LineKind.FACET

        /** Polygons that were compared with the edge, which can have many sides, and triangles that count once. */
        private val compared = HashSet<Int>()

        fun divide(edge: Int) {
            kind = model.kind(edge)
            if (kind == LineKind.FACET && facing.isSilhouette(edge)) kind = LineKind.OUTLINE
            val start = model.end(edge, 0)
            val end = model.end(edge, 1)
            clip(start, end)
            if (part.isEmpty) return
            compared.clear()
            val low = part.low
            val high = part.high
            val w0 = mix(start, end, 2, low)
            val w1 = mix(start, end, 2, high)
            val from = space.distance(w0, mix(start, end, 3, low))
            val until = space.distance(w1, mix(start, end, 3, high))
            parts.begin(start, end, minOf(from, until))
            grid.forEachAlong(
                mix(start, end, 0, low) / w0, mix(start, end, 1, low) / w0,
                mix(start, end, 0, high) / w1, mix(start, end, 1, high) / w1,
            ) { face -> addHidden(face) }

            // What is not hidden is visible
            val isDrawn = facing.isDrawn(edge)
            if (isCounted) deep.setDeep(parts.intervals, hiddenBehind)
            parts.intervals.join()
            var at = low
            parts.intervals.forEachGap(low, high) { gapFrom, gapUntil ->
                addHidden(start, end, at, gapFrom)
                if (isDrawn) add(visible, start, end, gapFrom, gapUntil)
                at = gapUntil
            }
            addHidden(start, end, at, high)
        }

        private fun addHidden(start: Int, end: Int, from: Double, until: Double) =
            deep.forEachGap(from, until) { gapFrom, gapUntil -> add(hidden, start, end, gapFrom, gapUntil) }

        /** Adds what [face] hides of the edge. */
        private fun addHidden(face: Int) {
            if (face < model.triangleCount) {
                if (isCounted && !compared.add(face)) return
                parts.behindTriangle(model.corners[3 * face], model.corners[3 * face + 1], model.corners[3 * face + 2])
                return
            }
            val number = face - model.triangleCount
            if (compared.add(face)) polygons[number]?.let { parts.behindPolygon(it) }
        }

        private fun add(pieces: Pieces, start: Int, end: Int, from: Double, until: Double) {
            if (from >= until) return
            val w0 = mix(start, end, 2, from)
            val w1 = mix(start, end, 2, until)
            pieces.add(
                mix(start, end, 0, from) / w0, mix(start, end, 1, from) / w0, if (from == 0.0) start else -1,
                mix(start, end, 0, until) / w1, mix(start, end, 1, until) / w1, if (until == 1.0) end else -1,
                kind,
            )
        }

        private fun mix(start: Int, end: Int, place: Int, t: Double): Double = when (t) {
            0.0 -> places[4 * start + place]
            1.0 -> places[4 * end + place]
            else -> places[4 * start + place] + t * (places[4 * end + place] - places[4 * start + place])
        }

        private fun clip(start: Int, end: Int) {
            part.begin()
            part.keepPositive(beyondNear(start), beyondNear(end))
            part.keepPositive(space.far - distance(start), space.far - distance(end))
            part.keepPositive(inside(start, 0, 1.0, margin), inside(end, 0, 1.0, margin))
            part.keepPositive(inside(start, 1, 1.0, margin), inside(end, 1, 1.0, margin))
            val right = space.raster.width + margin
            val bottom = space.raster.height + margin
            part.keepPositive(inside(start, 0, -1.0, right), inside(end, 0, -1.0, right))
            part.keepPositive(inside(start, 1, -1.0, bottom), inside(end, 1, -1.0, bottom))
        }

        private fun beyondNear(point: Int) = space.beyondNear(places[4 * point + 2], places[4 * point + 3])

        private fun distance(point: Int) = space.distance(places[4 * point + 2], places[4 * point + 3])

        private fun inside(point: Int, place: Int, sign: Double, limit: Double): Double =
            sign * places[4 * point + place] + limit * places[4 * point + 2]
    }

    private companion object {
        /** Number of edges in one task of a thread. */
        const val CHUNK = 4096
    }
}
