package dev.lazyz.scenes.ply

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.Ints
import dev.lazyz.scenes.triangulation.Triangulation

/**
 * The faces of a file: polygons, and strips of triangles with -1 where a new strip begins. They are kept until the
 * vertices are known, which may stand behind them. Not thread safe.
 *
 * @param vertexCount how many vertices there are or will be
 */
internal class PlyFaces(private val source: Source, private val vertexCount: Int) {
    /** Polygons one after the other: the number of corners, then the vertex numbers. */
    private val polygons = Ints()

    /** Reads all rows of element `face`. */
    fun readFaces(element: PlyElement, body: PlyBody) {
        val column = indexColumn(element)
        warnOfOthers(element)
        body.announce(element)
        val row = PlyRow(element)
        var tooSmall = 0
        repeat(element.count) {
            body.read(row)
            val corners = row.lists[column]
            if (corners.size < 3) {
                tooSmall++
            } else {
                polygons.add(corners.size)
                for (i in 0 until corners.size) polygons.add(vertex(corners.numbers[i], body))
            }
        }
        if (tooSmall > 0) source.warn("$tooSmall faces of fewer than 3 corners are left out")
    }

    /** Reads all rows of element `tristrips`. */
    fun readStrips(element: PlyElement, body: PlyBody) {
        val column = indexColumn(element)
        body.announce(element)
        val row = PlyRow(element)
        repeat(element.count) {
            body.read(row)
            strip(row.lists[column], body)
        }
    }

    private fun strip(list: PlyList, body: PlyBody) {
        val corners = list.numbers
        var start = 0
        for (i in 0 until list.size) {
            val corner = corners[i]
            if (corner == RESTART) {
                start = i + 1
                continue
            }
            val c = vertex(corner, body)
            if (i < start + 2) continue
            val a = corners[i - 2].toInt()
            val b = corners[i - 1].toInt()

            // A triangle with a corner twice only joins two strips
            if (a == b || b == c || a == c) continue
            val isTurned = (i - start) % 2 == 1
            polygons.add(3)
            polygons.add(if (isTurned) b else a)
            polygons.add(if (isTurned) a else b)
            polygons.add(c)
        }
    }

    /** Returns three vertex numbers a triangle, in the order of the file. */
    fun triangles(positions: FloatArray): IntArray {
        val triangles = Ints(polygons.size - polygons.size / 4)
        var at = 0
        while (at < polygons.size) {
            val count = polygons[at++]
            if (count == 3) {
                for (corner in at until at + 3) triangles.add(polygons[corner])
            } else {
                addPolygon(at, count, positions, triangles)
            }
            at += count
        }
        return triangles.toArray()
    }

    private fun addPolygon(at: Int, count: Int, positions: FloatArray, triangles: Ints) {
        val corners = Triangulation.triangles(
            DoubleArray(3 * count) { positions[3 * polygons[at + it / 3] + it % 3].toDouble() },
        )
        if (corners == null) {
            val most = Triangulation.MAX_CONCAVE_CORNERS
            source.warn("a concave face of $count corners, more than $most, is left out")
            return
        }
        for (corner in corners) triangles.add(polygons[at + corner])
    }

    private fun vertex(number: Double, body: PlyBody): Int {
        if (!(number >= 0.0 && number < vertexCount) || number != number.toInt().toDouble()) {
            val shown = if (number == StrictMath.rint(number)) number.toLong().toString() else number.toString()
            source.fail(
                body.location,
                "vertex number $shown is not one of the $vertexCount vertices, which count from 0",
                "correct the face or export the model again",
            )
        }
        return number.toInt()
    }

    private fun indexColumn(element: PlyElement): Int =
        element.column(listOf("vertex_indices", "vertex_index"), isList = true) ?: source.fail(
            "header",
            "element ${element.name} has no list vertex_indices",
            "rename the list that holds vertex numbers",
        )

    private fun warnOfOthers(element: PlyElement) {
        val others = element.properties.map { it.name }
        if ("red" in others) source.warn("colours of faces are not used; give them to the vertices")
        if ("texcoord" in others) source.warn("texture coordinates of faces are not used; give them to the vertices")
    }

    private companion object {
        const val RESTART = -1.0
    }
}
