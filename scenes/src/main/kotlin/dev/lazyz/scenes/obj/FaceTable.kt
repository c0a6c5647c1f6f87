package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source

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
