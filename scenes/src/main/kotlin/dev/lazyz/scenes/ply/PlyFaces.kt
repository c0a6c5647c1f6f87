package dev.lazyz.scenes.ply

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.Polygons

/**
 * Reads the faces of a file: polygons, and triangle strips, which are separated by -1. They are stored until the
 * vertices are known, because the vertices may follow them in the file, or passed on in blocks. Not thread safe.
 *
 * @param vertexCount number of vertices that the header declares
 * @param use takes the polygons that were read, whenever there are some thousands; call [end] for the last ones. Null
 *   to keep all polygons, with their texture coordinates
 */
internal class PlyFaces(
    private val source: Source,
    private val vertexCount: Int,
    private val use: ((Polygons) -> Unit)? = null,
) {
    /** The polygons so far that were not passed on. */
    var polygons = Polygons()
        private set
    private var tooSmall = 0
    private var wrongTexture = 0

    /** Reports the faces and lists that were left out. */
    fun warn() {
        if (tooSmall > 0) source.warn("$tooSmall faces of fewer than 3 corners are left out")
        if (wrongTexture > 0) source.warn("$wrongTexture faces have a texcoord list that is not two numbers a corner")
    }

    /** Reads all rows of element `face`. Returns the numbers of the columns that were used. */
    fun readFaces(element: PlyElement, body: PlyBody): Set<Int> {
        val column = indexColumn(element)
        val color = PlyColor.of(element)
        val texture = if (use == null) element.column(listOf("texcoord"), isList = true) else null
        val textureNumber = texture?.let { element.column(listOf("texnumber")) }
        expect(element, body)
        if (body is PlyBinaryBody && body.areLists(element)) {
            body.readLists(element) { at, count ->
                face(body, at, count)
                passOn()
            }
            return setOf(column)
        }
        body.readRows(element) { _, row ->
            val corners = row.lists[column]
            if (corners.size < 3) {
                tooSmall++
            } else {
                polygons.begin(corners.size)
                for (i in 0 until corners.size) polygons.add(vertex(corners.numbers[i], body))
                if (color != null) {
                    polygons.color(
                        polygons.count - 1,
                        polygons.colors.add(
                            color.channel(row, 0),
                            color.channel(row, 1),
                            color.channel(row, 2),
                            color.channel(row, 3),
                        ),
                    )
                }
                if (texture != null && row.lists[texture].size == 2 * corners.size) {
                    addTexture(row.lists[texture], textureNumber?.let { row.numbers[it].toInt() } ?: 0)
                } else if (texture != null && row.lists[texture].size > 0) {
                    wrongTexture++
                }
                passOn()
            }
        }
        return setOf(column) + (color?.columns ?: emptyList()) + listOfNotNull(texture, textureNumber)
    }

    /** Reserves memory for the rows of [element]. */
    private fun expect(element: PlyElement, body: PlyBody) {
        val room = body.cornerRoom(element)
        polygons.expect(if (use == null) room else minOf(room, BLOCK))
    }

    private fun passOn() {
        if (use != null && polygons.cornerCount >= BLOCK) end()
    }

    /** Passes on the polygons that were read and not passed on yet. */
    fun end() {
        checkNotNull(use)(polygons)
        polygons = Polygons()
    }

    /** Adds a face of [count] corners, whose numbers begin at index [at] of [body]. */
    private fun face(body: PlyBinaryBody, at: Int, count: Int) {
        if (count == 3) {
            val size = Int.SIZE_BYTES
            polygons.addTriangle(
                vertex(body.int(at), body),
                vertex(body.int(at + size), body),
                vertex(body.int(at + 2 * size), body),
            )
        } else if (count < 3) {
            tooSmall++
        } else {
            polygons.begin(count)
            for (i in 0 until count) {
                polygons.add(vertex(body.int(at + Int.SIZE_BYTES * i), body))
                source.step()
            }
        }
    }

    private fun addTexture(list: PlyList, number: Int) {
        polygons.texture(number)
        for (i in 0 until list.size step 2) {
            polygons.addPlace(polygons.places.add(list.numbers[i].toFloat(), (1.0 - list.numbers[i + 1]).toFloat()))
        }
    }

    /** Reads all rows of element `tristrips`. Returns the numbers of the columns that were used. */
    fun readStrips(element: PlyElement, body: PlyBody): Set<Int> {
        val column = indexColumn(element)
        expect(element, body)
        if (body is PlyBinaryBody && body.areLists(element)) {
            body.readLists(element) { at, count ->
                strip(IntArray(count) { body.int(at + Int.SIZE_BYTES * it) }, count, body)
            }
            return setOf(column)
        }
        body.readRows(element) { _, row ->
            val list = row.lists[column]
            strip(IntArray(list.size) { cornerOfStrip(list.numbers[it], body) }, list.size, body)
        }
        return setOf(column)
    }

    private fun strip(corners: IntArray, count: Int, body: PlyBody) {
        var start = 0
        for (i in 0 until count) {
            val c = corners[i]
            source.step()
            if (c == RESTART) {
                start = i + 1
                continue
            }
            vertex(c, body)
            if (i < start + 2) continue
            val a = corners[i - 2]
            val b = corners[i - 1]

            // A triangle with two equal corners only joins two strips
            if (a == b || b == c || a == c) continue
            val isTurned = (i - start) % 2 == 1
            polygons.addTriangle(if (isTurned) b else a, if (isTurned) a else b, c)
            passOn()
        }
    }

    private fun cornerOfStrip(number: Double, body: PlyBody): Int =
        if (number == RESTART.toDouble()) RESTART else vertex(number, body)

    private fun vertex(number: Double, body: PlyBody): Int = body.vertexNumber(number, vertexCount, "face")

    private fun vertex(number: Int, body: PlyBody): Int =
        if (number in 0 until vertexCount) number else vertex(number.toDouble(), body)

    /** Returns the number of the list of vertex numbers. Fails if [element] has none. */
    fun indexColumn(element: PlyElement): Int =
        element.column(listOf("vertex_indices", "vertex_index"), isList = true) ?: source.fail(
            "header",
            "element ${element.name} has no list vertex_indices",
            "rename the list that holds vertex numbers",
        )

    private companion object {
        const val RESTART = -1

        /** Corners of polygons that are passed on at a time. */
        const val BLOCK = 1 shl 14
    }
}
