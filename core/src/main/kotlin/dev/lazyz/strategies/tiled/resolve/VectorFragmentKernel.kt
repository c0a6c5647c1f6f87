package dev.lazyz.strategies.tiled.resolve

import dev.lazyz.shading.Vertices
import dev.lazyz.spi.FragmentBatch
import dev.lazyz.spi.Srgb
import jdk.incubator.vector.DoubleVector
import jdk.incubator.vector.FloatVector
import jdk.incubator.vector.IntVector
import jdk.incubator.vector.LongVector
import jdk.incubator.vector.VectorOperators
import jdk.incubator.vector.VectorShape
import jdk.incubator.vector.VectorSpecies

private val DOUBLES: VectorSpecies<Double> = DoubleVector.SPECIES_PREFERRED
private val LANES: Int = DOUBLES.length()

/** Bits of half a key. */
private const val HALF = 32L
private val LONGS: VectorSpecies<Long> = LongVector.SPECIES_PREFERRED

/** As many floats as [DOUBLES] has lanes. */
private val NARROW: VectorSpecies<Float> =
    VectorSpecies.of(Float::class.javaPrimitiveType, VectorShape.forBitSize(LANES * Float.SIZE_BITS))
private val FLOATS: VectorSpecies<Float> = FloatVector.SPECIES_PREFERRED
private val INTS: VectorSpecies<Int> = IntVector.SPECIES_PREFERRED

/**
 * Loops with the JVM's Vector API. Can only be loaded if the JVM has the module `jdk.incubator.vector`.
 *
 * Edge functions are represented as doubles, which hold them exactly, so the order in which steps are added does not
 * matter. Methods are small and pass arrays to each other, so that C2 keeps vectors in registers.
 */
internal class VectorFragmentKernel : FragmentKernel(long = 4) {
    private val red = Component()
    private val green = Component()
    private val blue = Component()

    override fun weigh(face: Face, fragments: WaitingFragments, at: Int, x: Int, y: Int) {
        val first0 = face.at0(x, y).toDouble()
        val first1 = face.at1(x, y).toDouble()
        val first2 = face.at2(x, y).toDouble()
        val right0 = face.e0dx.toDouble()
        val right1 = face.e1dx.toDouble()
        val right2 = face.e2dx.toDouble()
        val down0 = face.e0dy.toDouble()
        val down1 = face.e1dy.toDouble()
        val down2 = face.e2dy.toDouble()
        val count = fragments.size - at
        var i = 0
        while (i < count) {
            val column = DoubleVector.fromArray(DOUBLES, fragments.columns, at + i)
            val row = DoubleVector.fromArray(DOUBLES, fragments.rows, at + i)
            val part0 = column.mul(right0).add(row.mul(down0)).add(first0).mul(face.over0)
            val part1 = column.mul(right1).add(row.mul(down1)).add(first1).mul(face.over1)
            val part2 = column.mul(right2).add(row.mul(down2)).add(first2).mul(face.over2)
            val sum = part0.add(part1).add(part2).max(face.least)
            val scale = DoubleVector.broadcast(DOUBLES, 1.0).div(sum)
            part0.mul(scale).intoArray(weight0, i)
            part1.mul(scale).intoArray(weight1, i)
            part2.mul(scale).intoArray(weight2, i)
            i += LANES
        }
    }

    override fun mix(face: Face, field: Int, sign: Double, out: FloatArray, at: Int, count: Int) {
        val data = face.vertices.data
        val a = data[field]
        val b = data[Vertices.LONG_STRIDE + field]
        val c = data[2 * Vertices.LONG_STRIDE + field]
        if (face.isSame(a, b, c)) return out.fill((sign * a).toFloat(), at, at + count)
        var i = 0
        while (i < count) {
            val sum = DoubleVector.fromArray(DOUBLES, weight0, i).mul(a)
                .add(DoubleVector.fromArray(DOUBLES, weight1, i).mul(b))
                .add(DoubleVector.fromArray(DOUBLES, weight2, i).mul(c))
            sum.mul(sign).convertShape(VectorOperators.D2F, NARROW, 0).reinterpretAsFloats().intoArray(out, at + i)
            i += LANES
        }
    }

    override fun runEnd(keys: LongArray, from: Int, until: Int): Int {
        // Most runs are either short or long
        val rank = keys[from]
        var at = from + 1
        val near = minOf(from + NEAR, until)
        while (at < near) {
            if (keys[at].toInt() != rank.toInt()) return at
            at++
        }
        while (at + LANES <= until) {
            val difference = LongVector.fromArray(LONGS, keys, at).lanewise(VectorOperators.XOR, rank)
            val isOther = difference.lanewise(VectorOperators.LSHL, HALF).compare(VectorOperators.NE, 0L)
            if (isOther.anyTrue()) return at + isOther.firstTrue()
            at += LANES
        }
        while (at < until && keys[at].toInt() == rank.toInt()) at++
        return at
    }

    override fun pack(batch: FragmentBatch, argb: IntArray) {
        val count = batch.size
        if (!isOpaque(batch.alpha, count)) {
            for (i in 0 until count) {
                argb[i] = Srgb.pack(batch.red[i], batch.green[i], batch.blue[i], batch.alpha[i])
            }
            return
        }
        red.find(batch.red, count)
        green.find(batch.green, count)
        blue.find(batch.blue, count)
        join(argb, count)
    }

    /** Repeats the code for the three components, because C2 does not inline the look-up if it is a separate method. */
    private fun join(argb: IntArray, count: Int) {
        val summands = Srgb.summands
        var i = 0
        while (i < count) {
            val r = IntVector.fromArray(INTS, red.bits, i)
                .add(IntVector.fromArray(INTS, summands, 0, red.buckets, i))
            val g = IntVector.fromArray(INTS, green.bits, i)
                .add(IntVector.fromArray(INTS, summands, 0, green.buckets, i))
            val b = IntVector.fromArray(INTS, blue.bits, i)
                .add(IntVector.fromArray(INTS, summands, 0, blue.buckets, i))
            r.lanewise(VectorOperators.LSHR, Srgb.BUCKET_SHIFT).lanewise(VectorOperators.LSHL, 16)
                .or(g.lanewise(VectorOperators.LSHR, Srgb.BUCKET_SHIFT).lanewise(VectorOperators.LSHL, 8))
                .or(b.lanewise(VectorOperators.LSHR, Srgb.BUCKET_SHIFT))
                .or(OPAQUE).intoArray(argb, i)
            i += INTS.length()
        }
    }

    private fun isOpaque(alpha: FloatArray, count: Int): Boolean {
        for (i in 0 until count) if (alpha[i] != 1f) return false
        return true
    }

    /** The table positions that [Srgb.encode] uses, for one component of a batch's colours. */
    private class Component {
        @JvmField val bits = IntArray(FragmentBatch.ROOM)

        @JvmField val buckets = IntArray(FragmentBatch.ROOM)

        fun find(linear: FloatArray, count: Int) {
            var i = 0
            while (i < count) {
                val value = FloatVector.fromArray(FLOATS, linear, i)
                val isSomething = value.compare(VectorOperators.GE, Srgb.LEAST)
                val known = FloatVector.broadcast(FLOATS, Srgb.LEAST).blend(value, isSomething)
                val bits = known.reinterpretAsInts().min(Srgb.MOST_BITS)
                bits.intoArray(this.bits, i)
                bits.sub(Srgb.LEAST_BITS).lanewise(VectorOperators.LSHR, Srgb.BUCKET_SHIFT).intoArray(buckets, i)
                i += INTS.length()
            }
        }
    }

    private companion object {
        /** Number of samples at the start of a run that are tested one by one. */
        const val NEAR = 4

        const val OPAQUE = 0xFF shl 24
    }
}
