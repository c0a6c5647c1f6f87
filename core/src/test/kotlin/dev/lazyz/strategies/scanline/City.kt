package dev.lazyz.strategies.scanline

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
import kotlin.random.Random
import org.joml.Vector3d

/** Scenes of high depth complexity, for tests of counters. */
internal object City {
    private val material = Material(shading = Shading.CONSTANT, baseColor = Rgba(0.5f, 0.4f, 0.3f))

    /** [blocks] x [blocks] houses of five walls each on a ground, seen from a street at their height. */
    fun frame(width: Int, height: Int, blocks: Int): Frame {
        val random = Random(12)
        val side = blocks * 2.0
        val builder = Scene.builder()
        val ground = listOf(listOf(0.0, 0.0), listOf(0.0, side), listOf(side, side), listOf(side, 0.0))
        builder.add(face(*ground.map { (x, z) -> listOf(x, 0.0, z) }.toTypedArray()))
        for (i in 0 until blocks) {
            for (k in 0 until blocks) {
                house(builder, 2.0 * i + 0.3, 2.0 * k + 0.3, 1.4, random.nextDouble(1.0, 4.0))
            }
        }
        builder.viewpoint(
            Camera.perspective(
                Vector3d(-3.0, 3.0, -4.0), Vector3d(side / 2, 1.0, side / 2), Vector3d(0.0, 1.0, 0.0),
                50.0, 0.5, 4 * side,
            ),
        )
        return builder.build().frame(width, height)
    }

    private fun house(builder: Scene.Builder, x: Double, z: Double, size: Double, height: Double) {
        val corners = listOf(listOf(x, z), listOf(x + size, z), listOf(x + size, z + size), listOf(x, z + size))
        for (i in 0 until 4) {
            val (x0, z0) = corners[i]
            val (x1, z1) = corners[(i + 1) % 4]
            builder.add(face(listOf(x0, 0.0, z0), listOf(x1, 0.0, z1), listOf(x1, height, z1), listOf(x0, height, z0)))
        }
        val roof = corners.map { (x, z) -> listOf(x, height, z) }
        builder.add(face(roof[0], roof[1], roof[2], roof[3]))
    }

    private fun face(vararg corners: List<Double>): Polygon =
        Polygon(listOf(corners.map { (x, y, z) -> Vertex(x, y, z) }), material)

    /**
     * [count] layers over the whole raster; the last submitted is the nearest. Each layer is as steep as [steepness]
     * layers: above 1, their extents of depth overlap.
     */
    fun layers(raster: Raster, count: Int, steepness: Double): Frame {
        val builder = FrameBuilder(raster)
        val w = raster.width.toDouble()
        val h = raster.height.toDouble()
        for (i in 0 until count) {
            val far = 1.0 - i / (count + steepness)
            val near = far - steepness / (count + steepness)
            val contour = doubleArrayOf(0.0, 0.0, far, w, 0.0, far, w, h, near, 0.0, h, near)
            builder.polygon(Rgba(i / count.toFloat(), 0f, 1f), contour)
        }
        return builder.build()
    }
}
