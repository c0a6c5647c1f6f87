package dev.lazyz.strategies.bsp

import dev.lazyz.Checkpoint
import dev.lazyz.Frame
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.VertexStage
import kotlin.math.abs

/**
 * Draws the triangles of a [PlaneTree] from front to back, and says for each which of those before it are proved to be
 * in front of it.
 *
 * At each node, the side of its plane that the camera sees first comes first, then the triangles of the node, then the
 * other side. Vertices are snapped, so some are on the other side of the plane on the screen, and depths are rounded.
 * So let f be the plane as a linear function of column, row and depth that grows away from the camera, and c the
 * coefficient of depth. A fragment's depth is within a unit of the plane through the snapped vertices (contract rule
 * 4.4), so f at the fragment is in the range of f at the three vertices, but for c. If f at all vertices of one
 * triangle exceeds f at all vertices of another by 3 c, it is behind at each sample that they share: no depths need be
 * compared. The greatest f of all that came before at the node is compared with the least f of each triangle on the
 * other side. Boxes of the vertices below each node settle most nodes without a look at their triangles.
 *
 * Triangles with one depth for an inclined plane (rule 3.4) are left to [steep].
 *
 * Sources: Robert Schumacker, Brigitta Brand, Maurice Gilliland, Werner Sharp, "Study for Applying Computer-Generated
 * Images to Visual Simulation" (1969); Henry Fuchs, Zvi Kedem, Bruce Naylor, "On Visible Surface Generation by A Priori
 * Tree Structures", SIGGRAPH 1980. There, faces that a plane cuts are divided; here they stay whole, at the node.
 *
 * @param batches at least one, each with triangles
 */
internal class ListPriority(
    private val frame: Frame,
    private val batches: List<TriangleBatch>,
    private val samples: OwnedSamples,
) {
    private val region = frame.region
    private val tree = PlaneTree.of(batches.map { it.mesh })
    private val planes = ScreenPlanes(batches[0].stage)

    /** The factor of depth for order: -1 if the greatest depth wins. */
    private val direction = VisibilityOrder(frame.raster.depthTest).lead(0, 1).toDouble()

    /** The number of the first triangle of each batch in the tree. */
    private val firsts = IntArray(batches.size)

    /** Boxes of the vertices of all triangles drawn at and below each node: the least three numbers, the greatest. */
    private val boxes = IntArray(BOX * tree.size)

    /** For each level of the path to the current node: f, its greatest value so far, and by how much to exceed it. */
    private val functions = DoubleArray(4 * PlaneTree.MOST_LEVELS)
    private val greatest = DoubleArray(PlaneTree.MOST_LEVELS)
    private val leads = DoubleArray(PlaneTree.MOST_LEVELS)

    /** The f that is behind the near side, and that behind the triangles of the node, too. */
    private val behindNear = DoubleArray(PlaneTree.MOST_LEVELS)
    private val behindBoth = DoubleArray(PlaneTree.MOST_LEVELS)

    /** The numbers of the first triangles drawn of the near side, of the node, and of the far side. */
    private val begins = IntArray(PlaneTree.MOST_LEVELS)
    private val middles = IntArray(PlaneTree.MOST_LEVELS)
    private val ends = IntArray(PlaneTree.MOST_LEVELS)

    /** Levels whose planes must still be compared with what is below, for each level one after the other. */
    private val open = IntArray((PlaneTree.MOST_LEVELS + 1) * (PlaneTree.MOST_LEVELS + 1))

    /** Those triangles drawn before the current one that are not proved to be in front of it. */
    private val undecided = DrawnRanges(PlaneTree.MOST_LEVELS + 1)

    /** Submission indices of the triangles that were left out, and must be drawn after the others. */
    val steep: ArrayList<Int> = ArrayList()

    /** Bytes held. */
    val bytes: Long get() = tree.bytes + boxes.bytes + open.bytes + firsts.bytes

    init {
        for (i in 1 until batches.size) firsts[i] = firsts[i - 1] + batches[i - 1].count
        for (node in tree.size - 1 downTo PlaneTree.ROOT) {
            endIfInterrupted()
            boxes.fill(Int.MAX_VALUE, BOX * node, BOX * node + 3)
            boxes.fill(Int.MIN_VALUE, BOX * node + 3, BOX * node + BOX)
            forEachFace(node) { batch, triangle ->
                for (corner in 0 until 3) {
                    val at = batch.place(triangle, corner)
                    include(node, batch.grid, at, at)
                }
            }
            if (!tree.isInner(node)) continue
            for (isPositive in listOf(false, true)) {
                val at = BOX * tree.below(node, isPositive)
                include(node, boxes, at, at + 3)
            }
        }
    }

    private inline fun forEachFace(node: Int, action: (batch: TriangleBatch, triangle: Int) -> Unit) {
        for (place in tree.start(node) until tree.start(node + 1)) {
            if (Checkpoint.isDue(place)) endIfInterrupted()
            val face = tree.face(place)
            val number = firsts.binarySearch(face).let { if (it < 0) -it - 2 else it }
            val batch = batches[number]
            val triangle = face - firsts[number]
            if (batch.isDrawn(triangle) && batch.boundsIn(region, triangle) != null) action(batch, triangle)
        }
    }

    private fun include(node: Int, numbers: IntArray, least: Int, most: Int) {
        val at = BOX * node
        for (k in 0 until 3) {
            boxes[at + k] = minOf(boxes[at + k], numbers[least + k])
            boxes[at + 3 + k] = maxOf(boxes[at + 3 + k], numbers[most + k])
        }
    }

    /** Draws all triangles but the [steep] ones. */
    fun draw() {
        draw(PlaneTree.ROOT, 0, 0, 0)
    }

    /** Draws [node] and what is below; [open] has the levels above that are not settled from [from] until [until]. */
    private fun draw(node: Int, level: Int, from: Int, until: Int) {
        endIfInterrupted()
        if (boxes[BOX * node] > boxes[BOX * node + 3]) return
        var last = until
        for (i in from until until) if (!isSettled(open[i], node)) open[last++] = open[i]
        begins[level] = samples.drawn
        if (!tree.isInner(node)) return drawFaces(node, level, until, last)

        val isPositiveFirst = begin(node, level)
        open[last] = 2 * level
        draw(tree.below(node, isPositiveFirst), level + 1, until, last + 1)
        middles[level] = samples.drawn
        behindNear[level] = greatest[level] + leads[level]
        drawFaces(node, level, until, last + 1)
        ends[level] = samples.drawn
        behindBoth[level] = greatest[level] + leads[level]
        open[last] = 2 * level + BEHIND
        draw(tree.below(node, !isPositiveFirst), level + 1, until, last + 1)
    }

    /** Sets the function of [node]. Returns whether its positive side is in front. */
    private fun begin(node: Int, level: Int): Boolean {
        val at = 4 * level
        planes.write(tree, node, functions, at)
        val isPositiveFirst = functions[at + 2] * direction < 0.0
        if (isPositiveFirst) for (k in at until at + 4) functions[k] = -functions[k]
        greatest[level] = Double.NEGATIVE_INFINITY

        // A bound of the rounding of f in the whole box: four products, and three sums, each with half of 2^-52
        var magnitude = abs(functions[at + 3])
        for (k in 0 until 3) {
            val farthest = maxOf(abs(boxes[BOX * node + k].toDouble()), abs(boxes[BOX * node + 3 + k].toDouble()))
            magnitude += abs(functions[at + k]) * farthest
        }
        val lead = LEAD * abs(functions[at + 2]) + ROUNDING * magnitude
        leads[level] = if (lead in LEAST..Double.MAX_VALUE) lead else Double.NaN
        return isPositiveFirst
    }

    /** Whether nothing below [node] changes the greatest f at a level, or can be undecided there. */
    private fun isSettled(entry: Int, node: Int): Boolean {
        val at = 4 * (entry shr 1)
        val isBehind = entry and BEHIND != 0
        var f = functions[at + 3]
        for (k in 0 until 3) {
            val isGreatest = functions[at + k] < 0.0 == isBehind
            f += functions[at + k] * boxes[BOX * node + if (isGreatest) 3 + k else k]
        }
        return if (isBehind) f >= behindBoth[entry shr 1] else f <= greatest[entry shr 1]
    }

    private fun drawFaces(node: Int, level: Int, from: Int, until: Int) {
        forEachFace(node) { batch, triangle ->
            val index = batch.first + triangle
            if (isSteep(batch, triangle)) {
                steep.add(index)
            } else {
                undecided.clear()
                for (i in from until until) examine(open[i], batch, triangle)
                val isBehindNear = tree.isInner(node) && behind(behindNear, level, batch, triangle)
                undecided.add(if (isBehindNear) middles[level] else begins[level], samples.drawn)
                samples.draw(index, undecided)
            }
        }
    }

    private fun isSteep(batch: TriangleBatch, triangle: Int): Boolean {
        val form = frame.primitives[batch.first + triangle].depthForm ?: return true
        return form.dx == 0L && form.dy == 0L && batch.leastDepth(triangle) + 2 < batch.greatestDepth(triangle)
    }

    /** Compares a triangle with the plane of a level. */
    private fun examine(entry: Int, batch: TriangleBatch, triangle: Int) {
        val level = entry shr 1
        if (entry and BEHIND == 0) {
            for (corner in 0 until 3) greatest[level] = maxOf(greatest[level], f(level, batch, triangle, corner))
        } else if (!behind(behindBoth, level, batch, triangle)) {
            val isBehindNear = behind(behindNear, level, batch, triangle)
            undecided.add(if (isBehindNear) middles[level] else begins[level], ends[level])
        }
    }

    /** Whether f at all vertices is at least a limit of its level. */
    private fun behind(limits: DoubleArray, level: Int, batch: TriangleBatch, triangle: Int): Boolean {
        for (corner in 0 until 3) if (!(f(level, batch, triangle, corner) >= limits[level])) return false
        return true
    }

    private fun f(level: Int, batch: TriangleBatch, triangle: Int, corner: Int): Double {
        val at = 4 * level
        val place = batch.place(triangle, corner)
        return functions[at + 3] + functions[at] * batch.grid[place] + functions[at + 1] * batch.grid[place + 1] +
            functions[at + 2] * batch.grid[place + 2]
    }

    private companion object {
        const val BOX = 6

        /** The bit of entries of [open] for what is on the far side; others are for what comes before. */
        const val BEHIND = 1

        /** Units that prove the order of two depths of which each may be off by one. */
        const val LEAD = 3.0
        const val ROUNDING = 1.0 / (1L shl 48)

        /** Below this, numbers can be too small for the bound of rounding, and a plane proves nothing. */
        const val LEAST = 1e-300
    }
}

/** Ranges of the numbers that triangles got when they were drawn. */
internal class DrawnRanges(most: Int) {
    private val ends = IntArray(2 * most)
    private var count = 0

    /** The number that was looked for last, and whether it was found. */
    private var last = -1
    private var wasFound = false

    fun clear() {
        count = 0
        last = -1
    }

    /** Adds the numbers [from] until [until], before any is looked for. */
    fun add(from: Int, until: Int) {
        ends[count++] = from
        ends[count++] = until
    }

    operator fun contains(number: Int): Boolean {
        if (number == last) return wasFound
        last = number
        wasFound = false
        for (i in 0 until count step 2) wasFound = wasFound || (number >= ends[i] && number < ends[i + 1])
        return wasFound
    }
}

/**
 * Planes of the world as linear functions of column, row and depth: on the grid of the screen, where straight planes
 * stay straight. Immutable.
 *
 * Any linear function may divide snapped vertices, so these need not be exact: [ListPriority] looks at the vertices.
 */
internal class ScreenPlanes(stage: VertexStage) {
    /** For each coordinate of the world and 1, the coefficients of column, row, depth and 1. */
    private val rows = DoubleArray(16)

    init {
        // The inverse of the matrix to clip space, but for a positive factor
        val m = stage.worldToClip
        val clip = doubleArrayOf(
            m.m00, m.m10, m.m20, m.m30, m.m01, m.m11, m.m21, m.m31,
            m.m02, m.m12, m.m22, m.m32, m.m03, m.m13, m.m23, m.m33,
        )
        var determinant = 0.0
        for (row in 0 until 4) determinant += clip[4 * row] * cofactor(clip, row, 0)
        val sign = if (determinant < 0.0) -1.0 else 1.0

        // The grid is linear in x/w, y/w and z/w, and exact at these places
        val viewport = stage.viewport
        val x0 = viewport.gridX(0.0, 1.0).toDouble()
        val y0 = viewport.gridY(0.0, 1.0).toDouble()
        val z0 = viewport.depth(viewport.near, 1.0).toDouble()
        val x1 = viewport.gridX(1.0, 1.0) - x0
        val y1 = viewport.gridY(1.0, 1.0) - y0
        val z1 = (viewport.depth(1.0, 1.0) - z0) / (1.0 - viewport.near)
        for (column in 0 until 4) {
            val x = sign * cofactor(clip, 0, column) / x1
            val y = sign * cofactor(clip, 1, column) / y1
            val z = sign * cofactor(clip, 2, column) / z1
            rows[4 * column] = x
            rows[4 * column + 1] = y
            rows[4 * column + 2] = z
            rows[4 * column + 3] = sign * cofactor(clip, 3, column) - x * x0 - y * y0 - z * (z0 - viewport.near * z1)
        }
    }

    /** Returns the determinant of [m], by rows, without a row and a column, with the sign of its place. */
    private fun cofactor(m: DoubleArray, row: Int, column: Int): Double {
        val r = IntArray(3) { if (it < row) it else it + 1 }
        val c = IntArray(3) { if (it < column) it else it + 1 }
        var sum = 0.0
        for (i in 0 until 3) {
            val j = (i + 1) % 3
            val k = (i + 2) % 3
            sum += m[4 * r[0] + c[i]] *
                (m[4 * r[1] + c[j]] * m[4 * r[2] + c[k]] - m[4 * r[1] + c[k]] * m[4 * r[2] + c[j]])
        }
        return if ((row + column) % 2 == 0) sum else -sum
    }

    /**
     * Writes the function that is negative where the plane of [node] is, and positive where it is, to four elements of
     * [to] from [at] on.
     */
    fun write(tree: PlaneTree, node: Int, to: DoubleArray, at: Int) {
        for (k in 0 until 4) {
            to[at + k] = tree.plane(node, 0) * rows[k] + tree.plane(node, 1) * rows[4 + k] +
                tree.plane(node, 2) * rows[8 + k] + tree.plane(node, 3) * rows[12 + k]
        }
    }
}
