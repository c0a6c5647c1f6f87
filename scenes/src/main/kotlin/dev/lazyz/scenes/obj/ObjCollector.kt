package dev.lazyz.scenes.obj

import de.javagl.obj.AbstractWritableObj
import de.javagl.obj.FloatTuple
import de.javagl.obj.ObjFace
import dev.lazyz.scenes.Source
import dev.lazyz.scenes.images.SrgbDecoding
import dev.lazyz.scenes.triangulation.Floats
import dev.lazyz.scenes.triangulation.TextNumbers

/** Takes what `ObjReader` reads into plain arrays. */
internal class ObjCollector(private val source: Source, private val statements: ObjStatements) : AbstractWritableObj() {
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

    private var material: String? = null

    override fun addVertex(vertex: FloatTuple) {
        addTriple(positions, vertex)
        val words = statements.words
        if (words.size < FIRST_COLOR + 3) return

        // Vertices before the first coloured one are white
        while (colors.size < positions.size - 3) colors.add(1f)
        for (i in 0 until 3) colors.add(SrgbDecoding.decode(TextNumbers.parse(words[FIRST_COLOR + i]) ?: 0.0))
    }

    override fun addTexCoord(texCoord: FloatTuple) {
        textures.add(texCoord.x)
        textures.add(if (texCoord.dimensions > 1) texCoord.y else 0f)
    }

    override fun addNormal(normal: FloatTuple) = addTriple(normals, normal)

    private fun addTriple(to: Floats, tuple: FloatTuple) {
        to.add(tuple.x)
        to.add(tuple.y)
        to.add(tuple.z)
    }

    override fun addFace(face: ObjFace) {
        faces.begin(Part(statements.objectNumber, material, statements.isSmooth), statements.number)
        for (i in 0 until face.numVertices) {
            faces.addCorner(
                resolved(face.getVertexIndex(i), positions.size / 3, "vertices"),
                if (face.containsTexCoordIndices()) {
                    resolved(face.getTexCoordIndex(i), textures.size / 2, "texture coordinates")
                } else {
                    -1
                },
                if (face.containsNormalIndices()) resolved(face.getNormalIndex(i), normals.size / 3, "normals") else -1,
            )
        }
    }

    override fun setActiveMaterialGroupName(materialGroupName: String) {
        material = materialGroupName
    }

    override fun setMtlFileNames(mtlFileNames: Collection<String>) {
        libraries.addAll(mtlFileNames)
    }

    /** Fails if a face refers to something that no line of the file, before it or after, defines. */
    fun checkReferences() {
        for (face in 0 until faces.size) {
            for (corner in faces.corners(face)) {
                check(face, faces.positions[corner], positions.size / 3, "vertices")
                check(face, faces.textures[corner], textures.size / 2, "texture coordinates")
                check(face, faces.normals[corner], normals.size / 3, "normals")
            }
        }
    }

    private fun check(face: Int, number: Int, count: Int, what: String) {
        if (number >= count) {
            source.fail("line ${faces.line(face)}", "the face refers to number ${number + 1} of $count $what", REMEDY)
        }
    }

    /** The parser has made a number counted backward into one counted from 0; below 0 it lies before the first. */
    private fun resolved(number: Int, count: Int, what: String): Int {
        if (number < 0) {
            source.fail(
                "line ${statements.number}",
                "the face refers to number ${number - count}, counted backward, of the $count $what before it",
                REMEDY,
            )
        }
        return number
    }

    private companion object {
        /** `v x y z red green blue`: where the colour begins. */
        const val FIRST_COLOR = 4
        const val REMEDY = "correct the face or export the model again"
    }
}
