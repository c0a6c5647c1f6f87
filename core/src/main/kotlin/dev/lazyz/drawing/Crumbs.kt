package dev.lazyz.drawing

/**
 * Removes crumbs from [pieces]: what is visible of a silhouette between two places where it is hidden, if that is very
 * short. A silhouette of triangles is a zigzag around that of the smooth surface, so where the surface is seen almost
 * along its tangent, crumbs of the zigzag appear in front of it.
 *
 * Pieces that have a point in common belong together. What belongs together is removed if it has no boundary and no
 * crease, is partly hidden, and is shorter than [least] pixels. Used once; not thread safe. Cost: linear.
 *
 * @param pointCount number of points of the model
 */
internal class Crumbs(private val pieces: Pieces, private val pointCount: Int, private val least: Double) {
    private val parent = IntArray(pieces.count) { it }

    /** Returns the pieces that are no crumbs. */
    fun removed(): Pieces {
        connect()
        val length = DoubleArray(pieces.count)
        val isKept = BooleanArray(pieces.count)
        val isCut = BooleanArray(pieces.count)
        for (i in 0 until pieces.count) {
            val root = root(i)
            val x = pieces.x(i, 1) - pieces.x(i, 0)
            val y = pieces.y(i, 1) - pieces.y(i, 0)
            length[root] += StrictMath.sqrt(x * x + y * y)
            if (pieces.isFeature(i)) isKept[root] = true
            if (pieces.point(i, 0) < 0 || pieces.point(i, 1) < 0) isCut[root] = true
        }
        val rest = Pieces()
        for (i in 0 until pieces.count) {
            val root = root(i)
            if (isKept[root] || !isCut[root] || length[root] >= least) rest.add(pieces, i)
        }
        return rest
    }

    private fun connect() {
        val pieceAt = IntArray(pointCount) { -1 }
        for (i in 0 until 2 * pieces.count) {
            val point = pieces.point(i / 2, i % 2)
            if (point < 0) continue
            if (pieceAt[point] < 0) pieceAt[point] = i / 2 else parent[root(i / 2)] = root(pieceAt[point])
        }
    }

    private fun root(piece: Int): Int {
        var at = piece
        while (parent[at] != at) {
            parent[at] = parent[parent[at]]
            at = parent[at]
        }
        return at
    }
}
