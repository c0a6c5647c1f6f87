package dev.lazyz.tiled

import dev.lazyz.FragmentBatch
import dev.lazyz.Srgb
import dev.lazyz.setup.Face
import dev.lazyz.setup.PlanarPrimitive
import dev.lazyz.setup.Vertices

/** The loops as any JVM runs them: those over arrays are such that C2 makes vectors of them. */
internal class ScalarFragmentKernel : FragmentKernel {
    private val weight0 = DoubleArray(FragmentBatch.CAPACITY)
    private val weight1 = DoubleArray(FragmentBatch.CAPACITY)
    private val weight2 = DoubleArray(FragmentBatch.CAPACITY)

    override fun attributes(face: Face, batch: FragmentBatch, at: Int, x: Int, y: Int, count: Int) {
        if (face.fields == 0) return
        if (count < LONG || !face.isExact) {
            for (i in 0 until count) face.attributes(batch, at + i, x + i, y)
            return
        }
        weigh(face, x, y, count)
        val fields = face.fields
        if (fields and PlanarPrimitive.WORLD != 0) {
            mix(face, Vertices.WORLD, 1.0, batch.worldX, at, count)
            mix(face, Vertices.WORLD + 1, 1.0, batch.worldY, at, count)
            mix(face, Vertices.WORLD + 2, 1.0, batch.worldZ, at, count)
        }
        if (fields and PlanarPrimitive.NORMAL != 0) {
            mix(face, Vertices.NORMAL, face.normalSign, batch.normalX, at, count)
            mix(face, Vertices.NORMAL + 1, face.normalSign, batch.normalY, at, count)
            mix(face, Vertices.NORMAL + 2, face.normalSign, batch.normalZ, at, count)
        }
        if (fields and PlanarPrimitive.UV != 0) {
            mix(face, Vertices.UV, 1.0, batch.u, at, count)
            mix(face, Vertices.UV + 1, 1.0, batch.v, at, count)
        }
        if (fields and PlanarPrimitive.COLOR != 0) {
            mix(face, Vertices.COLOR, 1.0, batch.vertexRed, at, count)
            mix(face, Vertices.COLOR + 1, 1.0, batch.vertexGreen, at, count)
            mix(face, Vertices.COLOR + 2, 1.0, batch.vertexBlue, at, count)
            mix(face, Vertices.COLOR + 3, 1.0, batch.vertexAlpha, at, count)
        }
    }

    /** Perspective-correct weights, as [Face] has them for one sample; edge functions are exact as doubles. */
    private fun weigh(face: Face, x: Int, y: Int, count: Int) {
        val first0 = (face.e0 + face.e0dx * x + face.e0dy * y).toDouble()
        val first1 = (face.e1 + face.e1dx * x + face.e1dy * y).toDouble()
        val first2 = (face.e2 + face.e2dx * x + face.e2dy * y).toDouble()
        val step0 = face.e0dx.toDouble()
        val step1 = face.e1dx.toDouble()
        val step2 = face.e2dx.toDouble()
        for (i in 0 until count) {
            val part0 = (first0 + i * step0) * face.over0
            val part1 = (first1 + i * step1) * face.over1
            val part2 = (first2 + i * step2) * face.over2
            val scale = 1.0 / maxOf(part0 + part1 + part2, face.least)
            weight0[i] = part0 * scale
            weight1[i] = part1 * scale
            weight2[i] = part2 * scale
        }
    }

    private fun mix(face: Face, field: Int, sign: Double, out: FloatArray, at: Int, count: Int) {
        val a = face.vertices.get(0, field)
        val b = face.vertices.get(1, field)
        val c = face.vertices.get(2, field)
        if (face.isSame(a, b, c)) return out.fill(a.toFloat(), at, at + count)
        for (i in 0 until count) out[at + i] = (sign * (weight0[i] * a + weight1[i] * b + weight2[i] * c)).toFloat()
    }

    override fun pack(batch: FragmentBatch, argb: IntArray) {
        for (i in 0 until batch.size) {
            argb[i] = Srgb.pack(batch.red[i], batch.green[i], batch.blue[i], batch.alpha[i])
        }
    }

    private companion object {
        /** Samples from which on a run is worth loops over arrays. */
        const val LONG = 12
    }
}
