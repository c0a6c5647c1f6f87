package dev.lazyz.strategies

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.geometry.FillRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.spi.Spans
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import kotlin.random.Random
import org.joml.Vector3d

/**
 * Frames that are legal but difficult to render, the same for the same seed: some of several bands, tiles and blocks;
 * primitives of all kinds that surround areas, end at powers of two or a sample beside, tie, cross, share edges and
 * wrap.
 *
 * @param most the longest side
 */
internal class AwkwardFrames(private val seed: Long, most: Int = if (seed and 3L == 0L) 180 else 40) {
    private val random = Random(seed)
    private val width = side(most)
    private val height = side(most)
    private val drawn = ArrayList<DoubleArray>()

    /** Few different depths, so that many are equal. */
    private val levels = DoubleArray(3) { random.nextDouble() }

    /** A frame of opaque primitives. */
    fun frame(): Frame {
        val raster = Raster(
            width, height, listOf(Rgba.BLACK, Rgba(0.3f, 0.6f, 0.1f, 0f), Rgba(0.2f, 0.4f, 0.8f, 0.5f)).random(random),
            DepthConvention.entries.random(random), DepthTest.entries.random(random), backgroundDepth(),
        )
        val builder = FrameBuilder(raster)
        repeat(random.nextInt(24)) { add(builder, raster) }
        val primitives = builder.build().primitives
        if (primitives.isNotEmpty() && random.nextInt(4) == 0) builder.add(primitives.random(random))
        val frame = builder.build()
        return if (random.nextInt(3) > 0) frame else frame.within(region())
    }

    /** A frame as [frame], with about half of the primitives translucent, some of them with alpha 0 or 1. */
    fun translucent(): Frame {
        val frame = frame()
        val primitives = frame.primitives.map { if (random.nextBoolean()) Glass(it, random) else it }
        return Frame(frame.raster, primitives, frame.region)
    }

    override fun toString(): String = "AwkwardFrames($seed)"

    private fun side(most: Int): Int = when (random.nextInt(8)) {
        0 -> 1
        1 -> minOf(most, listOf(7, 8, 9, 16, 17, 63, 64, 65).random(random))
        else -> 1 + random.nextInt(most)
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
        when (random.nextInt(18)) {
            0 -> builder.add(Weave(random.nextInt(), width, height, isLoose = random.nextBoolean()))
            1 -> builder.add(Steep(random, width, height))
            2 -> builder.add(Checkers(random.nextInt(), width, height))
            3 -> scene().primitives(raster).forEach { builder.add(it) }
            4 -> drawn.randomOrNull(random)?.let { polygon(builder, it) }
            5 -> drawn.randomOrNull(random)?.let { polygon(builder, nudged(it)) }
            6 -> drawn.randomOrNull(random)?.let { polygon(builder, contour(3).apply { it.copyInto(this, 0, 0, 6) }) }
            7 -> polygon(builder, contour(4 + random.nextInt(5)), contour(3 + random.nextInt(3)))
            8 -> polygon(builder, sliver())
            9 -> polygon(builder, DoubleArray(0), contour(random.nextInt(3)))
            10, 11, 12 -> polygon(builder, wall())
            else -> polygon(builder, contour(3 + random.nextInt(4)))
        }
    }

    /** The colour differs between samples, and its alpha is below 1 at some of them, which counts for nothing. */
    private fun polygon(builder: FrameBuilder, vararg contours: DoubleArray) {
        drawn += contours.filter { it.size >= 9 }
        val tint = random.nextFloat()
        val shader = Shader { it.setColor(tint, it.worldX / 200f, it.worldZ, if (it.x % 5 == 0) 0.6f else 1f) }
        builder.polygon(shader, FillRule.entries.random(random), *contours)
    }

    /** A rectangle, often larger than the raster; level, or tilted a little or much. */
    private fun wall(): DoubleArray {
        val (left, right) = List(2) { edge(width) }
        val (top, bottom) = List(2) { edge(height) }
        val depth = levels.random(random)
        val (across, down) = List(2) { listOf(0.0, 1e-9, -2e-9, 0.1, -0.3).random(random) }
        fun at(tilt: Double) = (depth + tilt).coerceIn(0.0, 1.0)
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
        val x = snapped(random.nextDouble() * width)
        val y = snapped(random.nextDouble() * height)
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

    /** Often on a sample, or on the border between pixels. */
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

    private fun scene(): Scene {
        val color = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat())
        val material = Material(color, shading = Shading.entries.random(random), specular = Rgba.WHITE)
        val mesh = Mesh(FloatArray(18) { random.nextFloat() * 6 - 3 }, IntArray(6) { it }, material)
        val spheres = List(1 + random.nextInt(2)) {
            val (x, y, z) = List(3) { random.nextDouble(-2.0, 2.0) }
            Sphere(Vector3d(x, y, z), random.nextDouble() * 2.5, material)
        }
        return Scene(spheres + mesh, viewpoint = SampleScenes.camera)
    }
}

/** Without a linear form, with holes: covers some areas completely, with bounds that are close or trivial. */
internal class Weave(private val seed: Int, width: Int, height: Int, private val isLoose: Boolean) : Primitive {
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

/**
 * Covers every other sample of every other row. Its form is legal, and wraps between these samples: two steps of -2^63
 * add up to 0.
 */
private class Checkers(seed: Int, private val width: Int, private val height: Int) : Primitive {
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

/** Wraps another primitive, with an opacity that differs between samples. */
private class Glass(private val whole: Primitive, random: Random) : Primitive by whole {
    private val alpha = listOf(0f, 1f, 0.5f, Float.NaN, random.nextFloat(), random.nextFloat()).random(random)
    private val isEven = random.nextBoolean()
    override val isTranslucent: Boolean get() = true

    override fun shade(fragment: Fragment) {
        whole.shade(fragment)
        val opacity = if (isEven || fragment.x % 3 > 0) alpha else fragment.y % 5 / 4f
        fragment.setColor(fragment.red, fragment.green, fragment.blue, opacity)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
}
