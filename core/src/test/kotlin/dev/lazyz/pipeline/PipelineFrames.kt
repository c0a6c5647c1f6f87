package dev.lazyz.pipeline

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
import dev.lazyz.SampleScenes
import dev.lazyz.Shader
import dev.lazyz.SpanCursor
import dev.lazyz.Spans
import dev.lazyz.behindAll
import dev.lazyz.world.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Sphere
import java.util.Random
import org.joml.Vector3d

/** Frames of legal edge cases for the row pipelines; the same seed gives the same frame. */
internal class PipelineFrames(seed: Long) {
    private val random = Random(seed)
    private val width = side(40)
    private val height = side(30)
    private val drawn = ArrayList<DoubleArray>()

    fun next(): Frame {
        val convention = pick(DepthConvention.entries)
        val test = pick(DepthTest.entries)
        val raster = Raster(width, height, Rgba(0.2f, 0.3f, 0.4f), convention, test, backgroundDepth(test))
        val builder = FrameBuilder(raster)
        repeat(random.nextInt(25)) { add(builder) }
        val primitives = ArrayList(builder.build().primitives)
        if (random.nextInt(3) == 0) primitives += balls(raster)
        if (random.nextInt(8) == 0) primitives += SampleScenes.mixed(random).primitives(raster)
        primitives.shuffle(random)
        return Frame(raster, primitives, region(raster))
    }

    private fun side(most: Int): Int = if (random.nextInt(6) == 0) 1 else 1 + random.nextInt(most)

    private fun backgroundDepth(test: DepthTest): Int =
        if (random.nextInt(3) == 0) Depth.ofUnit(0.25 * random.nextInt(5)) else test.behindAll

    private fun region(raster: Raster): Region {
        if (random.nextBoolean()) return raster.region
        val x = random.nextInt(width)
        val y = random.nextInt(height)
        return Region(x, y, x + 1 + random.nextInt(width - x), y + 1 + random.nextInt(height - y))
    }

    private fun add(builder: FrameBuilder) {
        when (random.nextInt(9)) {
            0 -> builder.add(Cloud(random.nextInt(1000), width, height))
            1 -> polygon(builder, contour(5 + random.nextInt(4)), contour(3 + random.nextInt(3)))
            2 -> polygon(builder, contour(4 + random.nextInt(5)))
            3 -> polygon(builder, sliver())
            4 -> polygon(builder, drawn.randomOrFresh())
            5 -> polygon(builder, drawn.randomOrFresh().sharingAnEdge())
            6 -> polygon(builder, contour(random.nextInt(3)))
            else -> polygon(builder, contour(3))
        }
    }

    private fun polygon(builder: FrameBuilder, vararg contours: DoubleArray) {
        drawn += contours.filter { it.size >= 9 }
        val tint = random.nextFloat()
        val shader = Shader { it.setColor(tint, it.worldX / 40f, it.worldY / 30f) }
        builder.polygon(shader, pick(FillRule.entries), *contours)
    }

    /**
     * A contour that can be concave and self-intersecting; on samples, on pixel corners and between; in planes that
     * cause ties.
     */
    private fun contour(vertices: Int): DoubleArray {
        val tie = if (random.nextBoolean()) 0.25 * random.nextInt(5) else -1.0
        return DoubleArray(3 * vertices) {
            when (it % 3) {
                0 -> position(width)
                1 -> position(height)
                else -> if (tie >= 0.0) tie else random.nextDouble()
            }
        }
    }

    private fun position(size: Int): Double {
        val position = (random.nextDouble() * 1.6 - 0.3) * size
        return when (random.nextInt(3)) {
            0 -> StrictMath.floor(position) + 0.5
            1 -> StrictMath.floor(position)
            else -> position
        }
    }

    private fun sliver(): DoubleArray {
        val x = position(width)
        return doubleArrayOf(x, -3.0, 0.0, x + 0.03, height + 3.0, 1.0, x + 1.0, position(height), random.nextDouble())
    }

    private fun List<DoubleArray>.randomOrFresh(): DoubleArray = if (isEmpty()) contour(3) else pick(this)

    private fun DoubleArray.sharingAnEdge(): DoubleArray = contour(3).also { copyInto(it, 0, 0, 6) }

    private fun balls(raster: Raster): List<Primitive> {
        val surfaces = List(1 + random.nextInt(4)) {
            val center = Vector3d(random.nextDouble() * 4 - 2, random.nextDouble() * 4 - 2, random.nextDouble() * 6 - 2)
            Sphere(center, 0.2 + random.nextDouble())
        }
        return Scene(surfaces, emptyList(), SampleScenes.camera).primitives(raster).toList()
    }

    private fun <T> pick(list: List<T>): T = list[random.nextInt(list.size)]
}

/** A custom primitive: several spans a row, no linear form, no cursor, no depth bounds. */
private class Cloud(private val seed: Int, width: Int, height: Int) : Primitive {
    override val rowStart: Int = seed % height
    override val rowEnd: Int = height
    override val columnStart: Int = seed / 3 % width
    override val columnEnd: Int = width

    override fun spans(y: Int, spans: Spans) {
        if (y !in rowStart until rowEnd) return
        for (x in columnStart + y % 2 until columnEnd step 4) spans.add(x, minOf(x + 3, columnEnd))
    }

    override fun depth(x: Int, y: Int): Int = Depth.ofUnit(((x * 7 + y * 5 + seed) % 13) / 12.0)

    override fun shade(fragment: Fragment): Unit = fragment.setColor(fragment.x / 40f, seed / 1000f, fragment.y / 30f)
}

/** A rectangle of constant depth that records the calls. */
internal class Witness(private val region: Region, private val depth: Int, private val onRow: (Int) -> Unit = {}) :
    Primitive {
    /** Rows at which cursors began. */
    val cursors = ArrayList<Int>()

    /** Rows whose spans were requested. */
    val rows = ArrayList<Int>()

    /** Samples whose depth was requested. */
    var depths = 0

    /** Samples whose colour was requested, x and y. */
    val shaded = ArrayList<Pair<Int, Int>>()

    override val rowStart: Int get() = region.rowStart
    override val rowEnd: Int get() = region.rowEnd
    override val columnStart: Int get() = region.columnStart
    override val columnEnd: Int get() = region.columnEnd

    override fun cursor(y: Int): SpanCursor {
        synchronized(this) { cursors += y }
        return super.cursor(y)
    }

    override fun spans(y: Int, spans: Spans) {
        synchronized(this) { rows += y }
        onRow(y)
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int {
        depths++
        return depth
    }

    override fun shade(fragment: Fragment) {
        synchronized(this) { shaded += Pair(fragment.x, fragment.y) }
        fragment.setColor(depth / 1e9f, fragment.x / 64f, fragment.y / 64f)
    }
}

/** Scenes that make the guarantees of the pipelines measurable. */
internal object PipelineScenes {
    /** [count] layers that cover all of [raster]; the nearest comes last. */
    fun layers(raster: Raster, count: Int, onRow: (index: Int, y: Int) -> Unit = { _, _ -> }): List<Witness> =
        List(count) { index -> Witness(raster.region, Depth.FAR - index) { y -> onRow(index, y) } }

    /** A staircase: a new tile starts every [step] rows and is [alive] steps high, so [alive] tiles cover any row. */
    fun staircase(raster: Raster, step: Int, alive: Int): Frame {
        val builder = FrameBuilder(raster)
        val right = raster.width.toDouble()
        for (top in 0 until raster.height step step) {
            val bottom = minOf(top + step * alive, raster.height).toDouble()
            val z = 0.5 + 0.4 * (top % 97) / 97
            builder.polygon(
                Rgba(0.5f, (top % 7) / 7f, 0.5f),
                doubleArrayOf(0.0, top.toDouble(), z, right, top.toDouble(), z, right, bottom, z, 0.0, bottom, z),
            )
        }
        return builder.build()
    }

    /** [count] triangles that all cover the only column of a raster of [rows] rows. */
    fun crowd(count: Int, rows: Int): Frame {
        val builder = FrameBuilder(Raster(1, rows))
        for (i in 0 until count) {
            val z = 0.1 + 0.8 * (i * 7919L % count) / count
            builder.polygon(Rgba.BLACK, doubleArrayOf(0.0, -1.0, z, 3.0 * rows, -1.0, z, 0.0, 3.0 * rows, z))
        }
        return builder.build()
    }

    /** Runs [block] on a thread with a stack of 128 kilobytes, and rethrows its exceptions. */
    fun <T> onASmallStack(block: () -> T): T {
        var result: Result<T>? = null
        val thread = Thread(null, { result = runCatching(block) }, "small stack", 128L shl 10)
        thread.start()
        thread.join()
        return result!!.getOrThrow()
    }

    /** Bytes in use after a garbage collection. */
    fun usedBytes(): Long {
        repeat(3) { System.gc() }
        val runtime = Runtime.getRuntime()
        return runtime.totalMemory() - runtime.freeMemory()
    }
}
