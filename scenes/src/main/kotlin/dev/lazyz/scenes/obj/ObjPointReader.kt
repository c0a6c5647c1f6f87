package dev.lazyz.scenes.obj

import dev.lazyz.scenes.loading.Source

/** Reads the statements `p v1 v2 ...` and `l v1 v2 ...`, whose vertices may be `v/vt`; the texture coordinates are not used. */
internal class ObjPointReader(
    private val source: Source,
    private val statements: Statements,
    private val model: ObjModel,
    private val faces: ObjFaceReader,
) {
    /** Reads the points of the statement at hand. */
    fun readPoints(material: String?) {
        statements.nextWord()
        while (statements.nextWord()) model.points.add(material, statements.number, faces.vertex("point"))
    }

    /** Reads the polyline of the statement at hand. */
    fun readLine(material: String?) {
        statements.nextWord()
        var previous = -1
        var count = 0
        while (statements.nextWord()) {
            val vertex = faces.vertex("line")
            if (count++ > 0) model.points.add(material, statements.number, previous, vertex)
            previous = vertex
        }
        if (count < 2) source.warn("line ${statements.number}: a line of $count vertices is left out")
    }
}
