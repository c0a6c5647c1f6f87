package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.FragmentBatch
import dev.lazyz.Srgb
import dev.lazyz.setup.planar.PerspectiveWeights
import dev.lazyz.shading.Vertices

/** Loops that run on any JVM. C2 can vectorize those over arrays. */
internal class ScalarFragmentKernel : FragmentKernel(long = 12) {
    override fun weigh(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int) {
        val first0 = (face.e0 + face.e0dx * x + face.e0dy * y).toDouble()
        val first1 = (face.e1 + face.e1dx * x + face.e1dy * y).toDouble()
        val first2 = (face.e2 + face.e2dx * x + face.e2dy * y).toDouble()
        val right0 = face.e0dx.toDouble()
        val right1 = face.e1dx.toDouble()
        val right2 = face.e2dx.toDouble()
        val down0 = face.e0dy.toDouble()
        val down1 = face.e1dy.toDouble()
        val down2 = face.e2dy.toDouble()
        val columns = fragments.columns
        val rows = fragments.rows
        for (i in 0 until fragments.size - at) {
            val column = columns[at + i]
            val row = rows[at + i]
            val at0 = first0 + column * right0 + row * down0
            val at1 = first1 + column * right1 + row * down1
            val at2 = first2 + column * right2 + row * down2
            PerspectiveWeights.of(at0, at1, at2, face.over0, face.over1, face.over2, face.least) { w0, w1, w2, _ ->
                weight0[i] = w0
                weight1[i] = w1
                weight2[i] = w2
            }
        }
    }

    override fun mix(face: Face, field: Int, sign: Double, out: FloatArray, at: Int, count: Int) {
        val a = face.vertices.get(0, field)
        val b = face.vertices.get(1, field)
        val c = face.vertices.get(2, field)
        if (face.isSame(a, b, c)) return out.fill((sign * a).toFloat(), at, at + count)
        for (i in 0 until count) out[at + i] = (sign * (weight0[i] * a + weight1[i] * b + weight2[i] * c)).toFloat()
    }

    override fun runEnd(keys: LongArray, from: Int, until: Int): Int {
        val rank = keys[from].toInt()
        var at = from + 1
        while (at < until && keys[at].toInt() == rank) at++
        return at
    }

    override fun pack(batch: FragmentBatch, argb: IntArray) {
        for (i in 0 until batch.size) {
            argb[i] = Srgb.pack(batch.red[i], batch.green[i], batch.blue[i], batch.alpha[i])
        }
    }
}
