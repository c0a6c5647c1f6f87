package dev.lazyz.scenes.obj

import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.Statements

/**
 * Reads the statements `p v1 v2 ...` and `l v1 v2 ...`. Vertices may be written as `v/vt`; texture coordinates are not
 * used.
 */
internal class ObjPointReader(
    private val source: Source,
    private val statements: Statements,
    private val model: ObjModel,
    private val faces: ObjFaceReader,
) {
    /** Reads the points of the current statement. */
    fun readPoints(label: Label) {
        statements.nextWord()
        while (statements.nextWord()) model.points.add(label, statements.number, faces.vertex("point"))
    }

    /** Reads the polyline of the current statement. */
    fun readLine(label: Label) {
        statements.nextWord()
        var previous = -1
        var count = 0
        while (statements.nextWord()) {
            val vertex = faces.vertex("line")
            if (count++ > 0) model.points.add(label, statements.number, previous, vertex)
            previous = vertex
        }
        if (count < 2) source.warn("", "line ${statements.number}", ": a line of $count vertices is left out")
    }
}
