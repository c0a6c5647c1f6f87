package dev.lazyz.scenes.gltf.meshopt

/**
 * Decodes mode `TRIANGLES`. Most triangles take one byte, which refers to a recent edge and a recent vertex (appendix
 * A, "Mode 1: triangles").
 */
internal class TriangleStream private constructor(private val bytes: ByteArray, private val count: Int, stride: Int) {
    private val result = IndexBytes(count, stride)
    private val tail = bytes.size - TAIL
    private val data = CompressedBytes(bytes, 1 + count / 3, tail)
    private val edges = Recent(2)
    private val vertices = Recent(1)
    private var next = 0
    private var last = 0

    private fun decode(work: (Int) -> Unit): ByteArray {
        if (bytes[0].toInt() and 0xFF != HEADER) {
            throw MeshoptException("the first byte is ${bytes[0].toInt() and 0xFF}, not $HEADER")
        }
        for (i in 0 until count / 3) {
            work(1)
            val code = bytes[1 + i].toInt() and 0xFF
            if (code < 0xF0) knownEdge(i, code shr 4, code and 15) else newEdges(i, code and 15)
        }
        data.expectEnd()
        return result.bytes
    }

    /** Decodes a triangle that shares a recent edge. */
    private fun knownEdge(triangle: Int, edge: Int, kind: Int) {
        val a = edges.get(edge, 0)
        val b = edges.get(edge, 1)
        val c = when (kind) {
            0 -> next++
            PREVIOUS -> --last
            FOLLOWING -> ++last
            EXPLICIT -> explicit()
            else -> vertices.get(kind, 0)
        }
        result.put(3 * triangle, a)
        result.put(3 * triangle + 1, b)
        result.put(3 * triangle + 2, c)
        edges.add(c, b)
        edges.add(a, c)
        if (kind == 0 || kind >= PREVIOUS) vertices.add(c)
    }

    /** Decodes a triangle whose edges are all new. */
    private fun newEdges(triangle: Int, kind: Int) {
        val kinds = if (kind < FROM_DATA) auxiliary(kind) else data.next()
        if (kind >= FROM_DATA && kinds == 0) next = 0
        val second = kinds shr 4
        val third = kinds and 15
        val a = if (kind == EXPLICIT) explicit() else next++
        val b = corner(second)
        val c = corner(third)
        result.put(3 * triangle, a)
        result.put(3 * triangle + 1, b)
        result.put(3 * triangle + 2, c)
        edges.add(b, a)
        edges.add(c, b)
        edges.add(a, c)
        vertices.add(a)
        if (second == 0 || second == EXPLICIT) vertices.add(b)
        if (third == 0 || third == EXPLICIT) vertices.add(c)
    }

    private fun corner(kind: Int): Int = when (kind) {
        0 -> next++
        EXPLICIT -> explicit()
        else -> vertices.get(kind - 1, 0)
    }

    private fun auxiliary(index: Int): Int {
        val kinds = bytes[tail + index].toInt() and 0xFF
        if (kinds shr 4 == EXPLICIT || kinds and 15 == EXPLICIT) {
            throw MeshoptException("byte $index of the table at the end is $kinds, which is not allowed")
        }
        return kinds
    }

    private fun explicit(): Int {
        last += signed(data.variable())
        return last
    }

    /** The last 16 entries of [width] numbers each; entry 0 is the newest. */
    private class Recent(private val width: Int) {
        private val numbers = IntArray(SIZE * width)
        private var count = 0

        fun add(vararg entry: Int) {
            entry.copyInto(numbers, count % SIZE * width)
            count++
        }

        fun get(age: Int, part: Int): Int {
            if (age >= count) throw MeshoptException("a triangle refers to an edge or vertex that did not occur before")
            return numbers[(count - 1 - age) % SIZE * width + part]
        }
    }

    companion object {
        private const val HEADER = 0xE1
        private const val TAIL = 16
        private const val SIZE = 16
        private const val PREVIOUS = 13
        private const val FOLLOWING = 14
        private const val EXPLICIT = 15
        private const val FROM_DATA = 14

        fun decode(bytes: ByteArray, count: Int, stride: Int, work: (Int) -> Unit): ByteArray =
            TriangleStream(bytes, count, stride).decode(work)
    }
}

/** Decodes mode `INDICES`: integers stored as differences from one of two earlier values (appendix A, "Mode 2"). */
internal object IndexStream {
    private const val HEADER = 0xD1
    private const val TAIL = 4

    fun decode(bytes: ByteArray, count: Int, stride: Int, work: (Int) -> Unit): ByteArray {
        val input = CompressedBytes(bytes, 0, bytes.size - TAIL)
        val header = input.next()
        if (header != HEADER) throw MeshoptException("the first byte is $header, not $HEADER")
        val result = IndexBytes(count, stride)
        val last = IntArray(2)
        for (i in 0 until count) {
            work(1)
            val code = input.variable()
            val baseline = code and 1
            last[baseline] += signed(code ushr 1)
            result.put(i, last[baseline])
        }
        input.expectEnd()
        return result.bytes
    }
}

/** An array of integers of [stride] bytes, 2 or 4, little endian. Higher bits are dropped. */
internal class IndexBytes(count: Int, private val stride: Int) {
    val bytes = ByteArray(count * stride)

    fun put(place: Int, value: Int) {
        for (byte in 0 until stride) bytes[place * stride + byte] = (value shr 8 * byte).toByte()
    }
}
