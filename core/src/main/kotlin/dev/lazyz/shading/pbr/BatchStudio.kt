package dev.lazyz.shading.pbr

import dev.lazyz.shading.light.LightVectors
import dev.lazyz.shading.light.Loops

/**
 * The light of the studio for many fragments at a time: [StudioView.radiance] around the reflected rays, and
 * [StudioView.irradiance] for the normals. Immutable and thread safe.
 */
internal class BatchStudio(private val view: StudioView) {
    /** Reads normals, directions to the viewer and roughness, and stores radiance and irradiance. */
    fun store(scratch: Array<FloatArray>, count: Int) {
        alphas(scratch[BatchPhysicalLighting.ROUGHNESS], scratch[ALPHA], count)
        for (axis in 0 until 3) {
            reflect(
                scratch[BatchPhysicalLighting.ALONG], scratch[LightVectors.NORMAL + axis],
                scratch[LightVectors.VIEW + axis], scratch[DIRECTION + axis], count,
            )
        }
        turn(scratch[DIRECTION], scratch[DIRECTION + 2], scratch[DIRECTION], scratch[DIRECTION + 2], count)
        radiance(scratch, count)
        scratch[LightVectors.NORMAL + 1].copyInto(scratch[DIRECTION + 1], 0, 0, count)
        turn(
            scratch[LightVectors.NORMAL], scratch[LightVectors.NORMAL + 2], scratch[DIRECTION], scratch[DIRECTION + 2],
            count,
        )
        irradiance(scratch, BatchPhysicalLighting.IRRADIANCE, count)
        for (channel in 0 until 3) {
            scale(scratch[BatchPhysicalLighting.RADIANCE + channel], count)
            scale(scratch[BatchPhysicalLighting.IRRADIANCE + channel], count)
        }
    }

    private fun alphas(roughness: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = roughness[i] * roughness[i]
    }

    private fun reflect(along: FloatArray, normal: FloatArray, view: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = 2f * along[i] * normal[i] - view[i]
    }

    /** Turns vectors from world space into the space of the studio. */
    private fun turn(x: FloatArray, z: FloatArray, outX: FloatArray, outZ: FloatArray, count: Int) {
        for (i in 0 until count) {
            val worldX = x[i]
            val worldZ = z[i]
            outX[i] = view.x(worldX, worldZ)
            outZ[i] = view.z(worldX, worldZ)
        }
    }

    private fun radiance(scratch: Array<FloatArray>, count: Int) {
        val alpha = scratch[ALPHA]
        irradiance(scratch, BatchPhysicalLighting.RADIANCE, count)
        walls(scratch[DIRECTION + 1], alpha, scratch[WALL], count)
        for (channel in 0 until 3) mix(scratch[BatchPhysicalLighting.RADIANCE + channel], alpha, scratch[WALL], count)
        if (!isGlossy(alpha, count)) return
        blurs(alpha, scratch[BLUR], count)
        for (box in Studio.boxes) {
            project(box, scratch, count)
            cover(box, scratch[S], scratch[T], scratch[BLUR], scratch[COVERAGE], count)
            weigh(scratch[COVERAGE], scratch[DISTANCE], alpha, count)
            add(scratch[BatchPhysicalLighting.RADIANCE], scratch[COVERAGE], box.red, count)
            add(scratch[BatchPhysicalLighting.RADIANCE + 1], scratch[COVERAGE], box.green, count)
            add(scratch[BatchPhysicalLighting.RADIANCE + 2], scratch[COVERAGE], box.blue, count)
        }
    }

    private fun isGlossy(alpha: FloatArray, count: Int): Boolean {
        for (i in 0 until count) if (alpha[i] != 1f) return true
        return false
    }

    private fun irradiance(scratch: Array<FloatArray>, at: Int, count: Int) {
        for (channel in 0 until 3) {
            irradiance(
                Studio.harmonics[channel], scratch[DIRECTION], scratch[DIRECTION + 1], scratch[DIRECTION + 2],
                scratch[at + channel], count,
            )
        }
    }

    private fun irradiance(h: FloatArray, x: FloatArray, y: FloatArray, z: FloatArray, out: FloatArray, count: Int) {
        val h0 = h[0]
        val h1 = h[1]
        val h2 = h[2]
        val h3 = h[3]
        val h4 = h[4]
        val h5 = h[5]
        val h6 = h[6]
        val h7 = h[7]
        val h8 = h[8]
        for (i in 0 until count) {
            out[i] = maxOf(Studio.sum(h0, h1, h2, h3, h4, h5, h6, h7, h8, x[i], y[i], z[i]), 0f)
        }
    }

    private fun walls(y: FloatArray, alpha: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = Studio.wall(y[i], alpha[i])
    }

    private fun mix(to: FloatArray, alpha: FloatArray, wall: FloatArray, count: Int) {
        for (i in 0 until count) to[i] = alpha[i] * to[i] + (1f - alpha[i]) * wall[i]
    }

    private fun blurs(alpha: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = Studio.blur(alpha[i])
    }

    /** Stores where the rays meet the plane of [box], and their cosines with its direction. */
    private fun project(box: SoftBox, scratch: Array<FloatArray>, count: Int) = project(
        box, scratch[DIRECTION], scratch[DIRECTION + 1], scratch[DIRECTION + 2], scratch[S], scratch[T],
        scratch[DISTANCE], count,
    )

    private fun project(
        box: SoftBox,
        x: FloatArray,
        y: FloatArray,
        z: FloatArray,
        s: FloatArray,
        t: FloatArray,
        depth: FloatArray,
        count: Int,
    ) {
        for (i in 0 until count) {
            val distance = box.distance(x[i], y[i], z[i])
            val front = maxOf(distance, SoftBox.LEAST)
            depth[i] = distance
            s[i] = box.s(x[i], z[i], front)
            t[i] = box.t(x[i], y[i], z[i], front)
        }
    }

    private fun cover(box: SoftBox, s: FloatArray, t: FloatArray, blur: FloatArray, out: FloatArray, count: Int) {
        for (i in 0 until count) out[i] = box.coverage(s[i], t[i], blur[i])
    }

    private fun weigh(coverage: FloatArray, distance: FloatArray, alpha: FloatArray, count: Int) {
        for (i in 0 until count) {
            val mask = Loops.step(distance[i] - SoftBox.LEAST)
            coverage[i] = (1f - alpha[i]) * (coverage[i] * mask)
        }
    }

    private fun add(to: FloatArray, part: FloatArray, color: Float, count: Int) {
        for (i in 0 until count) to[i] = to[i] + part[i] * color
    }

    private fun scale(values: FloatArray, count: Int) {
        for (i in 0 until count) values[i] = values[i] * view.intensity
    }

    companion object {
        private const val ALPHA = BatchPhysicalLighting.STUDIO
        private const val DIRECTION = ALPHA + 1
        private const val WALL = DIRECTION + 3
        private const val BLUR = WALL + 1
        private const val S = BLUR + 1
        private const val T = S + 1
        private const val DISTANCE = T + 1
        private const val COVERAGE = DISTANCE + 1

        /** Number of arrays of scratch memory. */
        const val COUNT: Int = 10
    }
}
