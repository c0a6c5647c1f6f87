package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import kotlin.random.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals

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

/** Frames of high depth complexity, for tests of counters. */
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

    /** [blocks] x [blocks] houses of five walls each on a ground, seen from a street at their height. */
    fun city(width: Int, height: Int, blocks: Int): Frame {
        val random = Random(12)
        val side = blocks * 2.0
        val builder = Scene.builder()
        fun face(vararg places: Double) {
            val corners = places.toList().chunked(3).map { (x, y, z) -> Vertex(x, y, z) }
            builder.add(Polygon(listOf(corners), Material(shading = Shading.CONSTANT)))
        }
        face(0.0, 0.0, 0.0, 0.0, 0.0, side, side, 0.0, side, side, 0.0, 0.0)
        for (block in 0 until blocks * blocks) {
            val x = block / blocks * 2 + 0.3
            val z = block % blocks * 2 + 0.3
            val top = random.nextDouble(1.0, 4.0)
            val corners = listOf(x to z, x + 1.4 to z, x + 1.4 to z + 1.4, x to z + 1.4)
            for ((i, from) in corners.withIndex()) {
                val to = corners[(i + 1) % 4]
                face(
                    from.first, 0.0, from.second, to.first, 0.0, to.second, to.first, top, to.second,
                    from.first, top, from.second,
                )
            }
            face(*corners.flatMap { (x, z) -> listOf(x, top, z) }.toDoubleArray())
        }
        val eye = Vector3d(-3.0, 3.0, -4.0)
        val target = Vector3d(side / 2, 1.0, side / 2)
        builder.viewpoint(Camera.perspective(eye, target, Vector3d(0.0, 1.0, 0.0), 50.0, 0.5, 4 * side))
        return builder.build().frame(width, height)
    }

    /** Two sheets over the whole raster that cross in a column. */
    fun crossing(width: Int, height: Int): Frame {
        val w = width.toDouble()
        val h = height.toDouble()
        return FrameBuilder(Raster(width, height))
            .polygon(Rgba.BLACK, doubleArrayOf(0.0, 0.0, 0.2, w, 0.0, 0.8, w, h, 0.8, 0.0, h, 0.2))
            .polygon(Rgba.WHITE, doubleArrayOf(0.0, 0.0, 0.7, w, 0.0, 0.3, w, h, 0.3, 0.0, h, 0.7))
            .build()
    }
}

/**
 * Renders [frame], compares the picture with that of `zbuffer`, and returns the work. If there are translucent
 * primitives, compares picture and shading calls with those of `lists`.
 */
internal fun Renderer.counted(frame: Frame): Counters {
    val image = render(frame)
    val expected = (if (frame.hasTranslucency) ListsRenderer() else ZBufferRenderer()).render(frame)
    assertEquals(expected, image, id)
    val calls = if (frame.hasTranslucency) expected.counters.shadingCalls else image.visible.toLong()
    if (frame.hasTranslucency || Capability.SHADES_ONLY_VISIBLE in capabilities) {
        assertEquals(calls, image.counters.shadingCalls, id)
    }
    return image.counters
}
