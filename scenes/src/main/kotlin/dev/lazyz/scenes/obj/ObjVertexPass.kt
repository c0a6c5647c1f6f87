package dev.lazyz.scenes.obj

import dev.lazyz.scenes.collections.KindCounts
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.streaming.VertexSpool

/** Reads the vertices of an OBJ file into [vertices], and counts the statements that are ignored. */
internal class ObjVertexPass(private val source: Source, val vertices: VertexSpool) : ObjVertexSink {
    private val ignored = ObjIgnored()
    private val unused = KindCounts()

    /** Reads all [statements]. */
    fun read(statements: Statements) {
        val reader = ObjVertexReader(source, statements, vertices.origin, this)
        while (statements.next()) {
            if (statements.hasKeyword("v")) {
                reader.readVertex()
            } else if (!statements.hasKeyword("f") && !statements.hasKeyword("fo")) {
                readOther(statements)
            }
        }
    }

    private fun readOther(statements: Statements) {
        val keyword = UNUSED.firstOrNull(statements::hasKeyword)
        if (keyword != null) {
            unused.add(keyword)
        } else if (NEUTRAL.none(statements::hasKeyword)) {
            ignored.add(statements.keyword())
        }
    }

    /** Reports the statements that were ignored. */
    fun warn() {
        ignored.warn(source)
        if (unused.total > 0) source.warn("statements that are not used are passed over: $unused")
    }

    override fun vertex(x: Float, y: Float, z: Float) = vertices.add(x, y, z)

    override fun color(red: Float, green: Float, blue: Float) = vertices.color(red, green, blue, 1f)

    override fun texture(u: Float, v: Float) = Unit

    override fun normal(x: Float, y: Float, z: Float) = Unit

    private companion object {
        /** Statements that the picture of the whole model may use. */
        val UNUSED = listOf("vn", "vt", "usemtl", "mtllib", "p", "l")

        /** Statements that make no difference, because each triangle has its own normal. */
        val NEUTRAL = listOf("g", "o", "s")
    }
}
