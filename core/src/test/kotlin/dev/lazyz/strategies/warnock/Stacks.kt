package dev.lazyz.strategies.warnock

import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.world.Camera
import dev.lazyz.world.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Vertex

/** The order in which layers are submitted. */
internal enum class Submission {
    FRONT_TO_BACK,
    BACK_TO_FRONT,
    SHUFFLED,
    ;

    /** Position from the front, 0 until [count], of the layer submitted as number [i]. */
    fun place(i: Int, count: Int): Int = when (this) {
        FRONT_TO_BACK -> i
        BACK_TO_FRONT -> count - 1 - i
        SHUFFLED -> (i * 7919L % count).toInt()
    }
}

/** Frames of many overlapping layers. */
internal object Stacks {
    /**
     * [count] layers over the whole raster, each as steep as [steepness] layers: above 1, their extents of depth
     * overlap.
     */
    fun layers(raster: Raster, count: Int, submission: Submission, steepness: Double = 0.5): Frame {
        val builder = FrameBuilder(raster)
        val w = raster.width.toDouble()
        val h = raster.height.toDouble()
        for (i in 0 until count) {
            val near = submission.place(i, count) / (count + steepness)
            val far = near + steepness / (count + steepness)
            val contour = doubleArrayOf(0.0, 0.0, far, w, 0.0, far, w, h, near, 0.0, h, near)
            builder.polygon(Rgba(i / count.toFloat(), 0f, 1f), contour)
        }
        return builder.build()
    }

    /**
     * [count] squares seen from above, each rotated and smaller than the one below: edges of all of them are visible.
     */
    fun twisted(width: Int, height: Int, count: Int, submission: Submission): Frame {
        val builder = Scene.builder()
        for (i in 0 until count) {
            val place = submission.place(i, count) / (count - 1.0)
            val angle = place * StrictMath.PI
            val radius = 0.8 + 0.5 * place
            val corners = List(4) { corner ->
                val turned = angle + corner * StrictMath.PI / 2
                Vertex(radius * StrictMath.cos(turned), 1.9 - 1.9 * place, -radius * StrictMath.sin(turned))
            }
            builder.add(Polygon(listOf(corners), Material(shading = Shading.CONSTANT)))
        }
        return builder.viewpoint(Camera.fit(azimuth = 20.0, elevation = 48.0)).build().frame(width, height)
    }
}
