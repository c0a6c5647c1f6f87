package dev.lazyz.scenes.off

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.SceneParser
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.MissingNormals
import dev.lazyz.scenes.meshes.PolygonMesh
import dev.lazyz.scenes.meshes.Polygons
import dev.lazyz.scenes.meshes.VertexArrays
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import org.joml.Vector3dc

/**
 * Reads the Object File Format in its ASCII form (M. Phillips, S. Levy and T. Munzner, "Geomview Manual", version 1.9,
 * section 4.2.5).
 *
 * The file becomes one mesh, or points if it has no faces. Each vertex is one line with x, y, z and the attributes that
 * the first word of the file declares, in this order: the normal (`N`), the colour (`C`), and texture coordinates
 * (`ST`, v upward, converted to `1 - v`). If it declares none, and each vertex has three or four more numbers, they are
 * read as a colour, with a warning, unless they are out of range or could be normals. A face, on one or more lines, can
 * have any number of corners and a colour, which is used if vertices have none. Colours of three or four numbers are
 * sRGB-encoded, see [OffColors]; indices into a colour map are ignored with a warning. Alpha is stored unchanged in the
 * vertex colours, and the material stays opaque. If the file has no normals, they are computed, smooth up to creases of
 * [CREASE_ANGLE] degrees. Vertices that are not three-dimensional, and the binary form, are rejected.
 */
internal object OffParser : SceneParser {
    /** The crease angle in degrees: edges that are sharper stay sharp. */
    const val CREASE_ANGLE = 45.0

    override fun parse(source: Source): Scene {
        source.decodeText()
        val reader = FarOrigin.reading(
            source.loading,
            read = { origin -> OffReader(source, origin).also { it.readVertices() } },
            bounds = { Box.around(it.vertices.positions) },
        )
        reader.readFaces()
        source.release()
        val triangles = PolygonMesh(source, reader.vertices, reader.polygons)
        if (triangles.triangleCount == 0) {
            if (reader.vertices.count == 0) source.warn("there are no vertices, so there is nothing to see")
            return Scene(reader.vertices.points())
        }
        return Scene(listOf(MissingNormals.computed(source, triangles.mesh(Material()), CREASE_ANGLE)))
    }
}

/**
 * Reads the tables of a file: each vertex is one line, and each face begins on a new line. Not thread safe.
 *
 * @param origin the point to subtract from all positions
 */
internal class OffReader(private val source: Source, private val origin: Vector3dc) {
    private val line = OffLine(source)
    private val header = OffHeader.read(source, line)

    private var longRows = 0
    private var hasUndeclaredColors = false

    /** The vertices, after they have been read. */
    lateinit var vertices: VertexArrays
        private set

    /** The faces, after they have been read. */
    val polygons = Polygons()

    /** Reads the vertices. Call [readFaces] afterwards. */
    fun readVertices() {
        val count = header.vertexCount
        if (count > line.bytesLeft / LEAST_VERTEX_BYTES + 1) {
            line.fail("$count vertices are announced, but the remaining ${line.bytesLeft} bytes are too few for them")
        }
        source.loading.vertices(source, count.toLong())
        vertices = VertexArrays(
            FloatArray(3 * count),
            if (header.hasNormals) FloatArray(3 * count) else null,
            if (header.hasPlaces) FloatArray(2 * count) else null,
            if (header.hasColors) FloatArray(4 * count) else null,
            origin,
        )
        val colors = OffColors()
        for (vertex in 0 until count) {
            if (!line.next()) cutOff("vertices", vertex, count)
            if (!readVertex(vertices, vertex, colors)) longRows++
        }
        if (header.isPlain && count > 0 && colors.size == count && colors.areEvident()) {
            hasUndeclaredColors = true
            longRows = 0
            vertices = VertexArrays(vertices.positions, colors = FloatArray(4 * count), origin = origin)
        }
        vertices.colors?.let { for (i in it.indices) it[i] = colors.channel(i / 4, i % 4) }
    }

    /**
     * Reads a vertex from the line. Returns false if numbers are left over, for example because they are not a colour.
     */
    private fun readVertex(to: VertexArrays, vertex: Int, colors: OffColors): Boolean {
        val plain = header.plainNumbers
        if (line.count < plain) line.fail("the vertex has ${line.count} numbers, not $plain")
        for (axis in 0 until 3) to.positions[3 * vertex + axis] = (line.numbers[axis] - origin.get(axis)).toFloat()
        var at = 3
        if (to.normals != null) {
            copy(at, to.normals, 3 * vertex, 3)
            at += 3
        }
        val colorCount = line.count - plain
        if (to.colors != null && colorCount in 3..4) {
            colors.add(line, at, colorCount)
            at += colorCount
        } else if (to.colors != null) {
            colors.addWhite()
        } else if (header.isPlain && colorCount in 3..4 && colors.size == vertex) {
            // Numbers that the header does not declare; they can be colours only if all vertices have them
            colors.add(line, at, colorCount)
        }
        if (to.uvs != null) {
            to.uvs[2 * vertex] = line.numbers[at++].toFloat()
            to.uvs[2 * vertex + 1] = (1.0 - line.numbers[at++]).toFloat()
        }
        return at == line.count
    }

    private fun copy(from: Int, to: FloatArray, at: Int, count: Int) {
        for (i in 0 until count) to[at + i] = line.numbers[from + i].toFloat()
    }

    /** Reads the faces into [polygons], and reports the numbers that were ignored. */
    fun readFaces() {
        if (hasUndeclaredColors) {
            source.warn("vertices have numbers that the header does not declare; they are read as colours")
        }
        if (longRows > 0) source.warn("$longRows vertices have numbers that do not fit the header and are ignored")
        val colors = OffColors()

        // For each colour, the number of its polygon
        val polygonOf = Ints()
        var tooSmall = 0
        var oddColors = 0
        for (face in 0 until header.faceCount) {
            if (!line.next()) cutOff("faces", face, header.faceCount)
            val corners = line.whole(0, "the number of corners")
            if (corners == Int.MAX_VALUE || !line.extend(1 + corners)) {
                line.fail("the file ends within a face of $corners corners", "export or copy the model again")
            }
            if (corners < 3) {
                tooSmall++
                continue
            }
            polygons.begin(corners)
            for (i in 1..corners) polygons.add(line.whole(i, "the number of a vertex", header.vertexCount - 1))
            val colorCount = line.count - 1 - corners
            if (colorCount in 3..4) {
                polygonOf.add(polygons.count - 1)
                colors.add(line, corners + 1, colorCount)
            } else if (colorCount > 0) {
                oddColors++
            }
        }
        source.step(polygonOf.size)
        for (i in 0 until polygonOf.size) polygons.color(polygonOf[i], number(colors, i))
        if (tooSmall > 0) source.warn("$tooSmall faces of fewer than 3 corners are left out")
        if (oddColors > 0) {
            source.warn("$oddColors faces have a colour that is not three or four numbers; it is not used")
        }
    }

    private fun number(colors: OffColors, color: Int): Int = polygons.colors.add(
        colors.channel(color, 0),
        colors.channel(color, 1),
        colors.channel(color, 2),
        colors.channel(color, 3),
    )

    private fun cutOff(what: String, present: Int, count: Int): Nothing =
        line.fail("the file ends after $present of $count $what", "export or copy the model again")

    private companion object {
        const val LEAST_VERTEX_BYTES = 6
    }
}

/**
 * The part before the tables: a word that gives the attributes of vertices, and the numbers of vertices and faces.
 *
 * @property hasNormals whether each vertex has a normal
 * @property hasColors whether each vertex has a colour
 * @property hasPlaces whether each vertex has texture coordinates
 * @property vertexCount number of vertices
 * @property faceCount number of faces
 */
internal class OffHeader private constructor(
    val hasNormals: Boolean,
    val hasColors: Boolean,
    val hasPlaces: Boolean,
    val vertexCount: Int,
    val faceCount: Int,
) {
    /** Number of numbers for each vertex, without its colour. */
    val plainNumbers: Int get() = 3 + (if (hasNormals) 3 else 0) + (if (hasPlaces) 2 else 0)

    /** Whether vertices have only positions. */
    val isPlain: Boolean get() = !hasNormals && !hasColors && !hasPlaces

    companion object {
        /** Whether [word] is the first word of a file of this format. */
        fun isKeyword(word: String): Boolean = keyword(word) != null

        /** Returns the letters in front of `OFF`, and the digits behind it, or null if [word] is something else. */
        private fun keyword(word: String): Pair<String, String>? {
            var letters = 0
            while (letters < word.length) {
                letters += if (word.startsWith("ST", letters)) {
                    2
                } else if (word[letters] in "CN4n") {
                    1
                } else {
                    break
                }
            }
            val behind = word.drop(letters + 3)
            val isOne = word.startsWith("OFF", letters) || word.startsWith("off", letters)
            return if (isOne && behind.all { it in '0'..'9' }) word.take(letters) to behind else null
        }

        /**
         * Reads the header. [line] must be at the start of the file. The first word may be missing; vertices then have
         * only positions.
         */
        fun read(source: Source, line: OffLine): OffHeader {
            val word = line.firstWord() ?: source.fail(null, "there are no words in the file", "export the model again")
            val (letters, behind) = keyword(word) ?: ("" to word)
            if ('4' in letters || 'n' in letters) {
                line.fail("\"$word\" has vertices of other than three dimensions", "export them with three, as OFF")
            }

            // Some programs write no space between the word and the counts; the number of edges is not used
            val first = behind.ifEmpty { line.wordOfLine() }
            if (first.equals("BINARY", ignoreCase = true)) {
                line.fail("the file is binary OFF, which is not read", "export the model as ASCII OFF")
            }
            if (first.isEmpty()) line.next() else line.readFrom(first)
            if (line.count < 2) line.fail("the numbers of vertices and faces should stand here")
            return OffHeader(
                'N' in letters,
                'C' in letters,
                "ST" in letters,
                line.whole(0, "the number of vertices"),
                line.whole(1, "the number of faces"),
            )
        }
    }
}
