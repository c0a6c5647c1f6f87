package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.Floats
import dev.lazyz.scenes.collections.Ints
import dev.lazyz.scenes.loading.Source
import org.joml.Vector3dc

/** The content of an OBJ file, as plain arrays. */
internal class ObjModel(private val source: Source, val origin: Vector3dc) {
    /** x, y, z of each `v`, relative to [origin]. */
    val positions = Floats()

    /** Linear red, green, blue of each `v` up to the last one that has a colour; white for those without one. */
    val colors = Floats()

    /** u, v of each `vt`, v upward. */
    val textures = Floats()

    /** x, y, z of each `vn`. */
    val normals = Floats()

    val faces = FaceTable()

    val points = ObjPoints()

    /** Returns red, green, blue, alpha of all vertices. */
    fun colors(): FloatArray = FloatArray(4 * (positions.size / 3)) { color(it / 4, it % 4) }

    /** Returns a channel of the colour of a vertex; white after the last one that has a colour. */
    private fun color(vertex: Int, channel: Int): Float {
        val at = 3 * vertex + channel
        return if (channel < 3 && at < colors.size) colors[at] else 1f
    }

    /** What was removed by [clear]. */
    private var earlierVertices = 0
    private var earlierTextures = 0
    private var earlierNormals = 0

    /** Number of `v` so far. */
    val vertexCount: Int get() = earlierVertices + positions.size / 3

    /** Number of `vt` so far. */
    val textureCount: Int get() = earlierTextures + textures.size / 2

    /** Number of `vn` so far. */
    val normalCount: Int get() = earlierNormals + normals.size / 3

    /** Number of numbers in the lists. */
    val pending: Int get() = positions.size + textures.size + normals.size + faces.positions.size + points.size

    /** Removes vertices, texture coordinates, normals, faces, points and lines, and keeps their counts. */
    fun clear() {
        earlierVertices = vertexCount
        earlierTextures = textureCount
        earlierNormals = normalCount
        positions.clear()
        colors.clear()
        textures.clear()
        normals.clear()
        faces.clear()
        points.clear()
    }

    /** The arguments of the `mtllib` statements, in order. */
    val libraries = ArrayList<String>()

    /**
     * Returns red, green, blue, alpha of [count] vertices, or null if the file has no colours. [positionOf] returns the
     * number of a vertex's position.
     */
    fun colors(count: Int, positionOf: (Int) -> Int): FloatArray? {
        if (colors.size == 0) return null
        return FloatArray(4 * count) { color(positionOf(it / 4), it % 4) }
    }

    /**
     * Fails if a face refers to a vertex that the file does not define, before or after the face. References to missing
     * texture coordinates or normals are removed from the face, with a warning.
     */
    fun checkReferences() {
        val count = positions.size / 3
        points.check(source, count)
        if (!faces.positions.areBelow(count)) {
            val corner = (0 until faces.positions.size).first { faces.positions[it] >= count }
            val face = (0 until faces.size).first { corner < faces.end(it) }
            failAt(face, faces.positions[corner], count)
        }
        drop(faces.textures, textures.size / 2, "texture coordinates")
        drop(faces.normals, normals.size / 3, "normals")
    }

    /** Fails because [face] refers to [vertex], which is not one of the [count] vertices. */
    fun failAt(face: Int, vertex: Int, count: Int): Nothing {
        val problem = "the face refers to number ${vertex + 1} of $count vertices"
        source.fail("line ${faces.line(face)}", problem, REFERENCE_REMEDY)
    }

    private fun drop(numbers: Ints, count: Int, what: String) {
        if (numbers.areBelow(count)) return
        var dropped = 0
        var first = -1
        for (face in 0 until faces.size) {
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
