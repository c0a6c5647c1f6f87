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
