package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Floats
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.meshes.VertexArrays
import org.joml.Vector3dc

/** The content of an OBJ file, as plain arrays. */
internal class ObjModel(private val source: Source, val origin: Vector3dc) :
    ObjVertexSink,
    ObjCounts {
    /** x, y, z of each `v`, relative to [origin]. */
    val positions = Floats()

    /** Linear red, green, blue of each `v` up to the last one that has a colour; white for those without one. */
    val colors = Floats()

    /** u, v of each `vt`, v upward. */
    val textures = Floats()

    /** x, y, z of each `vn`. */
    val normals = Floats()

    override val vertexCount: Int get() = positions.size / 3
    override val textureCount: Int get() = textures.size / 2
    override val normalCount: Int get() = normals.size / 3

    val faces = FaceTable()

    val points = ObjPoints()

    /** The arguments of the `mtllib` statements, in order. */
    val libraries = ArrayList<String>()

    override fun vertex(x: Float, y: Float, z: Float) {
        positions.add(x)
        positions.add(y)
        positions.add(z)
    }

    override fun color(red: Float, green: Float, blue: Float) {
        // Vertices before the first coloured one are white
        while (colors.size < positions.size - 3) colors.add(1f)
        colors.add(red)
        colors.add(green)
        colors.add(blue)
    }

    override fun texture(u: Float, v: Float) {
        textures.add(u)
        textures.add(v)
    }

    override fun normal(x: Float, y: Float, z: Float) {
        normals.add(x)
        normals.add(y)
        normals.add(z)
    }

    /** Returns all `v`, with their colours. */
    fun vertices(): VertexArrays =
        VertexArrays(positions.toArray(), colors = colors(vertexCount) { it }, origin = origin)

    /**
     * Returns red, green, blue, alpha of [count] vertices, or null if the file has no colours. [positionOf] returns the
     * number of a vertex's position.
     */
    fun colors(count: Int, positionOf: (Int) -> Int): FloatArray? {
        if (colors.size == 0) return null
        return FloatArray(4 * count) {
            val at = 3 * positionOf(it / 4) + it % 4
            if (it % 4 < 3 && at < colors.size) colors[at] else 1f
        }
    }

    /**
     * Fails if a face refers to a vertex that the file does not define, before or after the face. References to missing
     * texture coordinates or normals are removed from the face, with a warning.
     */
    fun checkReferences() {
        points.check(source, vertexCount)
        faces.requirePositions(source, vertexCount)
        drop(faces.textures, textureCount, "texture coordinates")
        drop(faces.normals, normalCount, "normals")
    }

    private fun drop(numbers: Ints, count: Int, what: String) {
        if (numbers.areBelow(count)) return
        var dropped = 0
        var first = -1
        for (face in 0 until faces.size) {
            source.step()
            val corners = faces.start(face) until faces.end(face)
            if (corners.none { numbers[it] >= count }) continue
            for (corner in corners) numbers[corner] = -1
            if (dropped++ == 0) first = faces.line(face)
        }
        source.warn("$dropped faces, first in line $first, refer to $what that are not there, and are drawn without")
    }

    companion object {
        const val REFERENCE_REMEDY = "correct the face or export the model again"

        /** A number that no element has: a reference to it is always invalid. */
        const val NOWHERE = Int.MAX_VALUE
    }
}

/** The numbers of elements of an OBJ file so far. */
internal interface ObjCounts {
    val vertexCount: Int
    val textureCount: Int
    val normalCount: Int
}

/**
 * The name of faces, points or lines, and their material: what has both in common becomes one surface.
 *
 * @property name names given by `o` and `g`, with `/` between them
 * @property material name given by `usemtl`, or null before the first
 */
internal data class Label(val name: String, val material: String?)

/**
 * The properties that a group of faces has in common.
 *
 * @property objectNumber number of `o` statements before the faces
 * @property isSmooth whether the faces are shaded smoothly if they have no normals
 */
internal data class Part(val objectNumber: Int, val label: Label, val isSmooth: Boolean)

/** The faces of an OBJ file in order, as plain arrays. Numbers count from 0, and -1 means none. */
internal class FaceTable {
    /** The distinct parts, in the order of the file. */
    val parts = ArrayList<Part>()
    private val partNumbers = HashMap<Part, Int>()
    private val starts = Ints()
    private val lines = Ints()
    private val partOfFace = Ints()

    /** For each corner, the numbers of its position, texture coordinate and normal. */
    val positions = Ints()
    val textures = Ints()
    val normals = Ints()

    /** Number of faces. */
    val size: Int get() = starts.size

    /** Returns the number of [part]. Adds the part if it is new. */
    fun partNumber(part: Part): Int = partNumbers.getOrPut(part) {
        parts.add(part)
        parts.size - 1
    }

    /**
     * Begins a face. [part] is the number of its part, and [line] its line in the file. The corners that are added next
     * belong to this face.
     */
    fun begin(part: Int, line: Int) {
        starts.add(positions.size)
        lines.add(line)
        partOfFace.add(part)
    }

    fun addCorner(position: Int, texture: Int, normal: Int) {
        positions.add(position)
        textures.add(texture)
        normals.add(normal)
    }

    /** Returns the index of a face's first corner. */
    fun start(face: Int): Int = starts[face]

    /** Returns the index after a face's last corner. */
    fun end(face: Int): Int = if (face + 1 < size) starts[face + 1] else positions.size

    /** Returns the number of a face's part. */
    fun part(face: Int): Int = partOfFace[face]

    fun line(face: Int): Int = lines[face]

    /** Fails if a corner refers to a vertex that is not one of the [count] vertices of the file. */
    fun requirePositions(source: Source, count: Int) {
        if (positions.areBelow(count)) return
        val corner = (0 until positions.size).first { positions[it] >= count }
        val face = (0 until size).first { corner < end(it) }
        val problem = "the face refers to number ${positions[corner] + 1} of $count vertices"
        source.fail("line ${line(face)}", problem, ObjModel.REFERENCE_REMEDY)
    }

    /** Removes all faces. The parts stay. */
    fun clear() {
        for (numbers in listOf(starts, lines, partOfFace, positions, textures, normals)) numbers.clear()
    }
}
