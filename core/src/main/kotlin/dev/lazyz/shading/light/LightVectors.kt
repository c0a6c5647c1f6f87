package dev.lazyz.shading.light

import dev.lazyz.spi.FragmentBatch
import dev.lazyz.world.light.AmbientVisibility

/**
 * The unit vectors that light depends on, for many fragments at a time: normals, and the directions to the viewer and
 * to a light. The operations of a fragment and their order are those of [Viewer.from] and [LightSources.from].
 *
 * They are in the first [COUNT] arrays of a batch's scratch memory. Immutable and thread safe.
 */
internal class LightVectors(
    private val viewer: Viewer,
    private val sources: LightSources,
    private val visibility: AmbientVisibility?,
) {
    /** Gives the normals length 1. Returns false if one has no length. */
    fun toUnitNormals(scratch: Array<FloatArray>, count: Int): Boolean {
        val length = scratch[LENGTH]
        Loops.lengths(scratch, NORMAL, length, count)
        for (i in 0 until count) if (!(length[i] > 0f)) return false
        for (axis in 0 until 3) Loops.divide(scratch[NORMAL + axis], length, count)
        return true
    }

    /** Multiplies [factor] by the visibility of ambient light. */
    fun occlude(batch: FragmentBatch, scratch: Array<FloatArray>, factor: FloatArray) {
        val visibility = visibility ?: return
        for (i in 0 until batch.size) {
            factor[i] *= visibility.at(
                batch.worldX[i], batch.worldY[i], batch.worldZ[i],
                scratch[NORMAL][i], scratch[NORMAL + 1][i], scratch[NORMAL + 2][i],
            )
        }
    }

    /** Stores the unit vectors to the viewer. */
    fun view(batch: FragmentBatch, scratch: Array<FloatArray>) {
        val count = batch.size
        if (viewer.isPerspective) {
            Loops.towards(viewer.eyeX, batch.worldX, scratch[VIEW], count)
            Loops.towards(viewer.eyeY, batch.worldY, scratch[VIEW + 1], count)
            Loops.towards(viewer.eyeZ, batch.worldZ, scratch[VIEW + 2], count)
            Loops.toUnit(scratch, VIEW, scratch[LENGTH], count)
        } else {
            scratch[VIEW].fill(viewer.backX, 0, count)
            scratch[VIEW + 1].fill(viewer.backY, 0, count)
            scratch[VIEW + 2].fill(viewer.backZ, 0, count)
        }
    }

    /** Stores the unit vectors to a light, its strength, and its cosines with the normals. */
    fun light(batch: FragmentBatch, scratch: Array<FloatArray>, light: Int) {
        val count = batch.size
        val numbers = sources.numbers
        val at = LightSources.STRIDE * light
        when (numbers[at + LightSources.KIND]) {
            LightSources.VARYING -> lightOneByOne(batch, scratch, light)
            LightSources.UNIFORM -> {
                scratch[STRENGTH].fill(1f, 0, count)
                Loops.towards(numbers[at], batch.worldX, scratch[LIGHT], count)
                Loops.towards(numbers[at + 1], batch.worldY, scratch[LIGHT + 1], count)
                Loops.towards(numbers[at + 2], batch.worldZ, scratch[LIGHT + 2], count)
                Loops.toUnit(scratch, LIGHT, scratch[LENGTH], count)
            }
            else -> {
                scratch[STRENGTH].fill(1f, 0, count)
                for (axis in 0 until 3) scratch[LIGHT + axis].fill(numbers[at + axis], 0, count)
            }
        }
        Loops.dot(scratch, NORMAL, LIGHT, scratch[COSINE], count)
        Loops.positive(scratch[COSINE], scratch[LIT], count)
    }

    private fun lightOneByOne(batch: FragmentBatch, scratch: Array<FloatArray>, light: Int) {
        for (i in 0 until batch.size) {
            sources.from(light, batch.worldX[i], batch.worldY[i], batch.worldZ[i]) { lx, ly, lz, factor ->
                scratch[LIGHT][i] = lx
                scratch[LIGHT + 1][i] = ly
                scratch[LIGHT + 2][i] = lz
                scratch[STRENGTH][i] = factor
            }
        }
    }

    companion object {
        /** Normals, three arrays: the caller sets them, to any length. */
        const val NORMAL: Int = 0

        /** Unit vectors to the viewer and to a light. */
        const val VIEW: Int = 3
        const val LIGHT: Int = 6
        const val STRENGTH: Int = 9

        /** Cosines between normal and light, and the same with 0 for those below 0. */
        const val COSINE: Int = 10
        const val LIT: Int = 11

        /** Scratch memory for lengths. */
        const val LENGTH: Int = 12

        /** A factor of ambient light: the caller sets it. */
        const val OCCLUSION: Int = 13

        /** Number of arrays. */
        const val COUNT: Int = 14
    }
}
