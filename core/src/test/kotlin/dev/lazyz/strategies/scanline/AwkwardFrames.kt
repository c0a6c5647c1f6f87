package dev.lazyz.strategies.scanline

import dev.lazyz.Depth
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.FillRule
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.LinearForm
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
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import kotlin.random.Random
import org.joml.Vector3d

/** Random frames that are legal but difficult to render, the same for the same seed. */
internal class AwkwardFrames(seed: Long) {
    private val random = Random(seed)
    private val width = if (random.nextInt(8) == 0) 1 else 1 + random.nextInt(48)
    private val height = if (random.nextInt(8) == 0) 1 else 1 + random.nextInt(32)
    private val polygons = ArrayList<List<DoubleArray>>()

    /** Few different depths, so that many are equal or nearly equal. */
    private val depths = DoubleArray(3) { random.nextDouble() }

    fun frame(): Frame {
        val convention = DepthConvention.entries.random(random)
        val test = DepthTest.entries.random(random)
        val raster = Raster(width, height, Rgba.BLACK, convention, test, backgroundDepth(test))
        val builder = FrameBuilder(raster)
        repeat(random.nextInt(24)) { add(builder, raster) }
        val frame = builder.build()
        return if (random.nextBoolean()) frame else frame.within(region())
    }

    private fun backgroundDepth(test: DepthTest): Int = when (random.nextInt(4)) {
        0 -> Depth.ofUnit(depths.random(random))
        1 -> Depth.ofUnit(random.nextDouble())
        2 -> Int.MAX_VALUE - test.behindAll
        else -> test.behindAll
    }

    private fun region(): Region {
        val column = random.nextInt(width)
        val row = random.nextInt(height)
        return Region(column, row, column + 1 + random.nextInt(width - column), row + 1 + random.nextInt(height - row))
    }

    private fun add(builder: FrameBuilder, raster: Raster) {
        when (random.nextInt(14)) {
            0 -> builder.add(sphere(raster))
            1 -> builder.add(Ripple(random.nextInt(), width, height, isLoose = random.nextBoolean()))
            2 -> builder.add(Checkers(random.nextInt(), width, height))
            3 -> addOffsetCopy(builder)
            4 -> if (polygons.isNotEmpty()) polygon(builder, polygons.random(random))
            5 -> addSharedEdge(builder)
            6 -> polygon(builder, listOf(sliver()))
            7 -> polygon(builder, listOf(contour(3 + random.nextInt(6)), contour(3)))
            8 -> polygon(builder, listOf(layer()))
            9 -> polygon(builder, listOf(contour(2), doubleArrayOf()))
            else -> polygon(builder, listOf(contour(if (random.nextBoolean()) 3 else 4 + random.nextInt(3))))
        }
    }

    private fun polygon(builder: FrameBuilder, contours: List<DoubleArray>) {
        polygons += contours
        val tint = random.nextFloat()
        val shader = Shader { it.setColor(tint, it.worldX / 64f, it.worldZ) }
        builder.polygon(shader, FillRule.entries.random(random), *contours.toTypedArray())
    }

    private fun contour(vertices: Int): DoubleArray {
        val size = if (random.nextBoolean()) 1.5 else 0.3
        val x = random.nextDouble() * width
        val y = random.nextDouble() * height
        val isLevel = random.nextInt(3) == 0
        val level = depths.random(random)
        return DoubleArray(3 * vertices) {
            when (it % 3) {
                0 -> snapped(x + (random.nextDouble() - 0.5) * size * width)
                1 -> snapped(y + (random.nextDouble() - 0.5) * size * height)
                else -> if (isLevel) {
                    level
                } else if (random.nextBoolean()) {
                    depths.random(random)
                } else {
                    random.nextDouble()
                }
            }
        }
    }

    /** Often exactly on a sample, or on the border between pixels. */
    private fun snapped(position: Double): Double = when (random.nextInt(3)) {
        0 -> StrictMath.floor(position) + 0.5
        1 -> StrictMath.floor(position)
        else -> position
    }

    private fun sliver(): DoubleArray {
        val x = random.nextDouble() * width
        return doubleArrayOf(x, -5.0, 0.0, x + 0.02, height + 5.0, 1.0, x + 1.0, random.nextDouble() * height, 0.5)
    }

    /** As wide as the raster, tilted a little, so that layers cross at a small angle. */
    private fun layer(): DoubleArray {
        val depth = depths.random(random)
        val tilt = random.nextInt(-4, 5) * 1e-9
        val w = width.toDouble()
        val h = height.toDouble()
        return doubleArrayOf(0.0, 0.0, depth, w, 0.0, depth + tilt, w, h, depth + tilt, 0.0, h, depth)
    }

    /** Adds a copy of a polygon, up to two units of depth away. */
    private fun addOffsetCopy(builder: FrameBuilder) {
        val contours = polygons.randomOrNull(random) ?: return
        val offset = random.nextInt(-2, 3) / 2147483648.0
        fun moved(contour: DoubleArray) = DoubleArray(contour.size) { contour[it] + if (it % 3 == 2) offset else 0.0 }
        polygon(builder, contours.map { moved(it) })
    }

    private fun addSharedEdge(builder: FrameBuilder) {
        val a = contour(3)
        val b = contour(3)
        a.copyInto(b, 0, 0, 6)
        polygon(builder, listOf(a))
        polygon(builder, listOf(b))
    }

    private fun sphere(raster: Raster): Primitive {
        val camera = Camera.perspective(
            Vector3d(0.0, 0.0, 4.0), Vector3d(0.0, 0.0, 0.0), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 9.0,
        )
        val center = Vector3d(random.nextDouble(-2.0, 2.0), random.nextDouble(-2.0, 2.0), random.nextDouble(-4.0, 4.0))
        return SetUp(raster, camera, emptyList()).sphere(Sphere(center, random.nextDouble() * 1.5, Material()))
    }
}

/** A custom primitive: without linear depth, with several spans a row, and bounds that may be trivial. */
internal class Ripple(private val seed: Int, width: Int, height: Int, private val isLoose: Boolean) : Primitive {
    override val rowStart: Int = Math.floorMod(seed, height)
    override val rowEnd: Int = height
    override val columnStart: Int = Math.floorMod(seed / 7, width)
    override val columnEnd: Int = width
    override val leastDepth: Int get() = if (isLoose) 0 else DEPTH
    override val greatestDepth: Int get() = if (isLoose) Int.MAX_VALUE else DEPTH + HEIGHT

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        val period = 3 + Math.floorMod(seed, 9)
        for (x in columnStart + y % 3 until columnEnd step period) spans.add(x, minOf(x + period - 1, columnEnd))
    }

    override fun depth(x: Int, y: Int): Int = DEPTH + Math.floorMod((x * 31 + y * 17) * (seed or 1), HEIGHT)

    override fun shade(fragment: Fragment): Unit = fragment.setColor(0.5f, fragment.x / 64f, fragment.y / 64f)

    private companion object {
        const val DEPTH = 1 shl 29
        const val HEIGHT = 1 shl 30
    }
}

/**
 * A custom primitive that covers every other sample of every other row. Its form is legal, and wraps between these
 * samples: two steps of -2^63 add up to 0.
 */
internal class Checkers(seed: Int, private val width: Int, private val height: Int) : Primitive {
    override val rowStart: Int get() = 0
    override val rowEnd: Int get() = height
    override val columnStart: Int get() = 0
    override val columnEnd: Int get() = width
    override val depthForm: LinearForm =
        LinearForm(Math.floorMod(seed, 7).toLong() shl 60, Long.MIN_VALUE + (1L shl 40), Long.MIN_VALUE)

    override fun spans(y: Int, spans: Spans) {
        if (y !in 0 until height || y % 2 != 0) return
        for (x in 0 until width step 2) spans.add(x, x + 1)
    }

    override fun depth(x: Int, y: Int): Int = (depthForm.at(x, y) shr 32).toInt()

    override fun shade(fragment: Fragment): Unit = fragment.setColor(1f, 1f, 0f)
}
