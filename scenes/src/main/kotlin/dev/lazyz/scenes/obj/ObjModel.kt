package dev.lazyz.scenes.obj

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.triangulation.Floats
import dev.lazyz.scenes.triangulation.Ints

/** What an OBJ file says, as plain arrays. */
internal class ObjModel(private val source: Source) {
    /** x, y, z of each `v`. */
    val positions = Floats()

    /** Linear red, green, blue of each `v` up to the last that has a colour; white where it has none. */
    val colors = Floats()

    /** u, v of each `vt`, v upward. */
    val textures = Floats()

    /** x, y, z of each `vn`. */
    val normals = Floats()

    val faces = FaceTable()

    /** What `mtllib` statements say, in order. */
    val libraries = ArrayList<String>()

    /** Fails if a face refers to something that no line of the file, before it or after, defines. */
    fun checkReferences() {
        checkReferences(faces.positions, positions.size / 3, "vertices")
        checkReferences(faces.textures, textures.size / 2, "texture coordinates")
        checkReferences(faces.normals, normals.size / 3, "normals")
    }

    private fun checkReferences(numbers: Ints, count: Int, what: String) {
        for (corner in 0 until numbers.size) {
            if (numbers[corner] < count) continue
            val face = (0 until faces.size).first { corner < faces.end(it) }
            val problem = "the face refers to number ${numbers[corner] + 1} of $count $what"
            source.fail("line ${faces.line(face)}", problem, REFERENCE_REMEDY)
        }
    }

    companion object {
        const val REFERENCE_REMEDY = "correct the face or export the model again"
    }
}
