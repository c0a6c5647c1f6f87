package dev.lazyz.scenes.obj

import dev.lazyz.scenes.triangulation.Ints

/**
 * What a run of faces has in common.
 *
 * @property objectNumber how many `o` statements stand before
 * @property material name given by `usemtl`, or null before the first
 * @property isSmooth whether it is to look smooth if it has no normals
 */
internal data class Part(val objectNumber: Int, val material: String?, val isSmooth: Boolean)

/** The faces of an OBJ file in order, as plain arrays. Numbers count from 0, and -1 stands for none. */
internal class FaceTable {
    /** The different parts in the order of their first face. */
    val parts = ArrayList<Part>()
    private val partNumbers = HashMap<Part, Int>()
    private val starts = Ints()
    private val lines = Ints()
    private val partOfFace = Ints()

    /** By corner: number of its position, texture coordinate and normal. */
    val positions = Ints()
    val textures = Ints()
    val normals = Ints()

    /** Number of faces. */
    val size: Int get() = starts.size

    /** Begins a face that the file has on [line]; its corners are those that are added next. */
    fun begin(part: Part, line: Int) {
        starts.add(positions.size)
        lines.add(line)
        partOfFace.add(
            partNumbers.getOrPut(part) {
                parts.add(part)
                parts.size - 1
            },
        )
    }

    fun addCorner(position: Int, texture: Int, normal: Int) {
        positions.add(position)
        textures.add(texture)
        normals.add(normal)
    }

    /** Returns the numbers of the corners of a face. */
    fun corners(face: Int): IntRange = starts[face] until if (face + 1 < size) starts[face + 1] else positions.size

    fun part(face: Int): Part = parts[partOfFace[face]]

    fun line(face: Int): Int = lines[face]
}
