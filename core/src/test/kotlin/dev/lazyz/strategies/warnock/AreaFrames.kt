package dev.lazyz.strategies.warnock

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
import dev.lazyz.world.Camera
import dev.lazyz.world.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Sphere
import kotlin.random.Random
import org.joml.Vector3d

/**
 * Frames that are difficult for renderers that process areas, the same for the same seed: some rasters of several bands
 * and many blocks; primitives that surround areas, end exactly at powers of two or a sample beside, tie, cross, and
 * wrap.
 */
internal class AreaFrames(seed: Long) {
    private val random = Random(seed)
    private val isLarge = random.nextInt(4) == 0
    private val width = side()
    private val height = side()
    private val drawn = ArrayList<DoubleArray>()

    /** Few different depths, so that many are equal. */
    private val levels = DoubleArray(3) { random.nextDouble() }

    fun frame(): Frame {
        val raster = Raster(
            width, height, Rgba.BLACK, DepthConvention.entries.random(random), DepthTest.entries.random(random),
            backgroundDepth(),
        )
        val builder = FrameBuilder(raster)
        repeat(random.nextInt(20)) { add(builder, raster) }
        val frame = builder.build()
        return if (random.nextInt(3) > 0) frame else frame.within(region())
    }

    private fun side(): Int = when (random.nextInt(8)) {
        0 -> 1
        1 -> listOf(7, 8, 9, 16, 17, 63, 64, 65).random(random)
        else -> 1 + random.nextInt(if (isLarge) 180 else 40)
    }

    private fun backgroundDepth(): Int = when (random.nextInt(6)) {
        0 -> Depth.ofUnit(levels.random(random))
        1 -> Depth.ofUnit(random.nextDouble())
        2, 3 -> 0
        else -> Int.MAX_VALUE
    }

    private fun region(): Region {
        val column = random.nextInt(width)
        val row = random.nextInt(height)
        return Region(column, row, column + 1 + random.nextInt(width - column), row + 1 + random.nextInt(height - row))
    }

    private fun add(builder: FrameBuilder, raster: Raster) {
        when (random.nextInt(16)) {
            0 -> builder.add(Weave(random.nextInt(), width, height, isLoose = random.nextBoolean()))
            1 -> builder.add(Steep(random, width, height))
            2 -> spheres(raster).forEach { builder.add(it) }
            3 -> drawn.randomOrNull(random)?.let { polygon(builder, it) }
            4 -> drawn.randomOrNull(random)?.let { polygon(builder, nudged(it)) }
            5 -> drawn.randomOrNull(random)?.let { polygon(builder, contour(3).apply { it.copyInto(this, 0, 0, 6) }) }
            6 -> polygon(builder, contour(4 + random.nextInt(5)), contour(3 + random.nextInt(3)))
            7 -> polygon(builder, sliver())
            8 -> polygon(builder, DoubleArray(0), contour(random.nextInt(3)))
            9, 10, 11 -> polygon(builder, wall())
            else -> polygon(builder, contour(3 + random.nextInt(4)))
        }
    }

    private fun polygon(builder: FrameBuilder, vararg contours: DoubleArray) {
        drawn += contours.filter { it.size >= 9 }
        val tint = random.nextFloat()
        val shader = Shader { it.setColor(tint, it.worldX / 200f, it.worldZ) }
        builder.polygon(shader, FillRule.entries.random(random), *contours)
    }

    /** A rectangle, often larger than the raster; level, or tilted a little or much. */
    private fun wall(): DoubleArray {
        val left = edge(width)
        val right = edge(width)
        val top = edge(height)
        val bottom = edge(height)
        val depth = levels.random(random)
        val tilts = listOf(0.0, 1e-9, -2e-9, 0.1, -0.3)
        val across = tilts.random(random)
        val down = tilts.random(random)
        fun at(across: Double) = (depth + across).coerceIn(0.0, 1.0)
        return doubleArrayOf(
            left, top, at(0.0), right, top, at(across), right, bottom, at(across + down), left, bottom, at(down),
        )
    }

    /** Outside the raster, at a multiple of eight or a sample beside, or anywhere. */
    private fun edge(size: Int): Double = when (random.nextInt(4)) {
        0 -> if (random.nextBoolean()) -1.0 else size + 1.0
        1 -> 8.0 * random.nextInt(size / 8 + 2) + random.nextInt(-1, 2)
        2 -> random.nextInt(size + 1) + 0.5
        else -> random.nextDouble() * size
    }

    private fun contour(vertices: Int): DoubleArray {
        val size = listOf(0.1, 0.5, 2.5).random(random)
        val x = random.nextDouble() * width
        val y = random.nextDouble() * height
        val isLevel = random.nextInt(3) == 0
        val level = levels.random(random)
        return DoubleArray(3 * vertices) {
            when (it % 3) {
                0 -> x + snapped((random.nextDouble() - 0.5) * size * width)
                1 -> y + snapped((random.nextDouble() - 0.5) * size * height)
                else -> if (isLevel) level else random.nextDouble()
            }
        }
    }

    private fun snapped(position: Double): Double =
        if (random.nextBoolean()) position else StrictMath.floor(position) + 0.5 * random.nextInt(2)

    private fun sliver(): DoubleArray {
        val x = random.nextDouble() * width
        return doubleArrayOf(x, -5.0, 0.0, x + 0.02, height + 5.0, 1.0, x + 1.0, random.nextDouble() * height, 0.5)
    }

    /** A copy, up to two units of depth away. */
    private fun nudged(contour: DoubleArray): DoubleArray {
        val offset = random.nextInt(-2, 3) / 2147483648.0
        return DoubleArray(contour.size) { contour[it] + if (it % 3 == 2) offset else 0.0 }
    }

    private fun spheres(raster: Raster): Sequence<Primitive> {
        val camera = Camera.perspective(
            Vector3d(0.0, 0.0, 4.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 1.0, 9.0,
        )
        val surfaces = List(1 + random.nextInt(3)) {
            val x = random.nextDouble(-2.0, 2.0)
            val y = random.nextDouble(-2.0, 2.0)
            Sphere(Vector3d(x, y, random.nextDouble(-4.0, 4.0)), random.nextDouble() * 2.5, Material())
        }
        return Scene(surfaces, emptyList(), camera).primitives(raster)
    }
}

/** Without a linear form, with holes: covers some areas completely, with bounds that are close or trivial. */
private class Weave(private val seed: Int, width: Int, height: Int, private val isLoose: Boolean) : Primitive {
    override val rowStart: Int = Math.floorMod(seed, height)
    override val rowEnd: Int = height
    override val columnStart: Int = Math.floorMod(seed / 7, width)
    override val columnEnd: Int = width
    override val leastDepth: Int get() = if (isLoose) 0 else DEPTH
    override val greatestDepth: Int get() = if (isLoose) Int.MAX_VALUE else DEPTH + RANGE

    override fun spans(y: Int, spans: Spans) {
        if (y < rowStart || y >= rowEnd) return
        val period = 1 + Math.floorMod(seed, 70)
        if (y / period % 2 == 0) {
            spans.add(columnStart, columnEnd)
        } else {
            for (x in columnStart + y % 3 until columnEnd step period + 2) spans.add(x, minOf(x + period, columnEnd))
        }
    }

    override fun depth(x: Int, y: Int): Int = DEPTH + Math.floorMod((x / 5 * 31 + y / 7 * 17) * (seed or 1), RANGE)

    override fun shade(fragment: Fragment): Unit = fragment.setColor(0.5f, fragment.x / 200f, fragment.y / 200f)

    private companion object {
        const val DEPTH = 1 shl 29
        const val RANGE = 1 shl 30
    }
}

/** A form with arbitrary steps, covered wherever its value is not negative: it wraps in between. */
private class Steep(random: Random, width: Int, height: Int) : Primitive {
    override val rowStart: Int = 0
    override val rowEnd: Int = height
    override val columnStart: Int = 0
    override val columnEnd: Int = width
    private val shift = random.nextInt(20)
    override val depthForm: LinearForm =
        LinearForm(random.nextLong(), random.nextLong() shr shift, random.nextLong() shr random.nextInt(20))

    override fun spans(y: Int, spans: Spans) {
        if (y !in rowStart until rowEnd) return
        for (x in columnStart until columnEnd) if (depthForm.at(x, y) >= 0) spans.add(x, x + 1)
    }

    override fun depth(x: Int, y: Int): Int = (depthForm.at(x, y) shr 32).toInt()

    override fun shade(fragment: Fragment): Unit = fragment.setColor(0f, fragment.x / 200f, shift / 20f)
}
