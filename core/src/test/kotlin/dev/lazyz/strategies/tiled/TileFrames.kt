package dev.lazyz.strategies.tiled

import dev.lazyz.Depth
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.FillRule
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.Shader
import dev.lazyz.Spans
import dev.lazyz.behindAll
import dev.lazyz.world.Camera
import dev.lazyz.world.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Sphere
import java.util.Random
import org.joml.Vector3d

/** Random frames that are legal but difficult to render, several tiles wide and high, the same for the same seed. */
internal class TileFrames(seed: Long) {
    private val random = Random(seed)
    private val width = side(100)
    private val height = side(60)
    private val contours = ArrayList<DoubleArray>()

    fun next(): Frame {
        val convention = DepthConvention.entries.pick()
        val test = DepthTest.entries.pick()
        val background = if (random.nextInt(3) == 0) Depth.ofUnit(0.25 * random.nextInt(5)) else test.behindAll
        val raster = Raster(width, height, Rgba(0.2f, 0.3f, 0.4f), convention, test, background)
        val builder = FrameBuilder(raster)
        repeat(random.nextInt(20)) { add(builder) }
        val primitives = ArrayList(builder.build().primitives)
        if (random.nextInt(3) == 0) primitives += spheres(raster)
        primitives.shuffle(random)
        return Frame(raster, primitives, region(raster))
    }

    private fun side(most: Int): Int = if (random.nextInt(8) == 0) 1 else 1 + random.nextInt(most)

    private fun region(raster: Raster): Region {
        if (random.nextBoolean()) return raster.region
        val x = random.nextInt(width)
        val y = random.nextInt(height)
        return Region(x, y, x + 1 + random.nextInt(width - x), y + 1 + random.nextInt(height - y))
    }

    private fun add(builder: FrameBuilder) {
        when (random.nextInt(10)) {
            0 -> builder.add(Stripes(random.nextInt(1000), width, height))
            1 -> polygon(builder, contour(5 + random.nextInt(4)), contour(3 + random.nextInt(3)))
            2 -> polygon(builder, contour(4 + random.nextInt(5)))
            3 -> polygon(builder, sliver())
            4 -> polygon(builder, if (contours.isEmpty()) contour(3) else contours.pick())
            5 -> polygon(builder, contour(3).also { contours.lastOrNull()?.copyInto(it, 0, 0, 6) })
            6 -> polygon(builder, contour(random.nextInt(3)))
            7 -> polygon(builder, wall())
            else -> polygon(builder, contour(3))
        }
    }

    private fun polygon(builder: FrameBuilder, vararg parts: DoubleArray) {
        contours += parts.filter { it.size >= 9 }
        val tint = random.nextFloat()
        val shader = Shader { it.setColor(tint, it.worldX / 100f, it.worldY / 60f) }
        builder.polygon(shader, FillRule.entries.pick(), *parts)
    }

    /**
     * Concave, self-intersecting, small or large; with vertices on samples, on corners of pixels and between; often in
     * tied planes.
     */
    private fun contour(vertices: Int): DoubleArray {
        val tie = if (random.nextBoolean()) 0.25 * random.nextInt(5) else -1.0
        val scale = if (random.nextInt(3) == 0) 0.15 else 1.6
        val x = random.nextDouble()
        val y = random.nextDouble()
        return DoubleArray(3 * vertices) {
            when (it % 3) {
                0 -> position(x + (random.nextDouble() - 0.5) * scale, width)
                1 -> position(y + (random.nextDouble() - 0.5) * scale, height)
                else -> if (tie >= 0.0) tie else random.nextDouble()
            }
        }
    }

    private fun position(part: Double, size: Int): Double = when (random.nextInt(3)) {
        0 -> StrictMath.floor(part * size) + 0.5
        1 -> StrictMath.floor(part * size)
        else -> part * size
    }

    private fun sliver(): DoubleArray {
        val x = random.nextDouble() * width
        val y = random.nextDouble() * height
        return doubleArrayOf(x, -3.0, 0.0, x + 0.03, height + 3.0, 1.0, x + 1.0, y, random.nextDouble())
    }

    /** Covers everything, so that later primitives behind it can be rejected. */
    private fun wall(): DoubleArray {
        val z = random.nextDouble()
        val tilt = random.nextDouble() * 0.01
        val w = width.toDouble()
        val h = height.toDouble()
        return doubleArrayOf(0.0, 0.0, z, w, 0.0, z, w, h, z + tilt, 0.0, h, z + tilt)
    }

    private fun spheres(raster: Raster): List<Primitive> {
        val camera = Camera.perspective(
            Vector3d(0.0, 0.0, 4.0), Vector3d(0.0, 0.0, 0.0), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 9.0,
        )
        val surfaces = List(1 + random.nextInt(4)) {
            val center = Vector3d(random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2, random.nextDouble() * 7 - 2)
            Sphere(center, 0.2 + random.nextDouble(), Material())
        }
        return Scene(surfaces, emptyList(), camera).primitives(raster).toList()
    }

    private fun <T> List<T>.pick(): T = get(random.nextInt(size))
}

/** A custom primitive: several spans a row, no linear form, no cursor, no bounds of its depth. */
private class Stripes(private val seed: Int, width: Int, height: Int) : Primitive {
    override val rowStart: Int = seed % height
    override val rowEnd: Int = height
    override val columnStart: Int = seed / 3 % width
    override val columnEnd: Int = width

    override fun spans(y: Int, spans: Spans) {
        if (y !in rowStart until rowEnd) return
        for (x in columnStart + y % 2 until columnEnd step 4) spans.add(x, minOf(x + 3, columnEnd))
    }

    override fun depth(x: Int, y: Int): Int = Depth.ofUnit(((x * 7 + y * 5 + seed) % 13) / 12.0)

    override fun shade(fragment: Fragment): Unit = fragment.setColor(fragment.x / 99f, seed / 1000f, fragment.y / 60f)
}
