package dev.lazyz.pipeline

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
import dev.lazyz.ShadingCursor
import dev.lazyz.Spans
import dev.lazyz.behindAll
import dev.lazyz.world.Camera
import dev.lazyz.world.FrameBuilder
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import java.util.Random
import org.joml.Vector3d

/** Random frames for the strategies that defer shading: everything that is legal, on small rasters. */
internal object LayeredFrames {
    /** A frame of opaque primitives of all kinds, on a random raster and region. */
    fun opaque(seed: Long): Frame {
        val random = Random(seed)
        val raster = raster(random)
        val primitives = ArrayList<Primitive>()
        repeat(random.nextInt(10)) { primitives.addAll(some(random, raster)) }
        if (primitives.isNotEmpty()) primitives.add(primitives[random.nextInt(primitives.size)])
        return Frame(raster, primitives.shuffled(random), region(random, raster))
    }

    /** As [opaque], with about half of the primitives translucent, some of them with alpha 0 or 1. */
    fun translucent(seed: Long): Frame {
        val random = Random(seed xor 0x5EED)
        val frame = opaque(seed)
        val primitives = frame.primitives.map { if (random.nextBoolean()) Glass(it, random) else it }
        return Frame(frame.raster, primitives, frame.region)
    }

    private fun raster(random: Random): Raster {
        val convention = DepthConvention.entries[random.nextInt(2)]
        val test = if (random.nextBoolean()) convention.nearest else DepthTest.entries[random.nextInt(4)]
        return Raster(
            1 + random.nextInt(24),
            1 + random.nextInt(24),
            listOf(Rgba.WHITE, Rgba(0.3f, 0.6f, 0.1f, 0f), Rgba(0.2f, 0.4f, 0.8f, 0.5f))[random.nextInt(3)],
            convention,
            test,
            if (random.nextInt(3) == 0) random.nextInt() ushr 1 else test.behindAll,
        )
    }

    private fun region(random: Random, raster: Raster): Region {
        if (random.nextBoolean()) return raster.region
        val column = random.nextInt(raster.width)
        val row = random.nextInt(raster.height)
        return Region(
            column,
            row,
            column + 1 + random.nextInt(raster.width - column),
            row + 1 + random.nextInt(raster.height - row),
        )
    }

    private fun some(random: Random, raster: Raster): List<Primitive> {
        val builder = FrameBuilder(raster)
        val color = Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat())
        when (random.nextInt(7)) {
            0 -> builder.polygon(color, contour(random, raster, 3))
            1 -> builder.polygon(Waves(color), FillRule.entries[random.nextInt(2)], contour(random, raster, 7))
            2 -> {
                // A hole, or a second contour of the same direction, in the plane of the outer contour or through it
                val outer = contour(random, raster, 4)
                builder.polygon(Waves(color), FillRule.entries[random.nextInt(2)], outer, contour(random, raster, 3))
            }
            3 -> {
                // Two triangles that share an edge, with constant depth, so that there are ties with others
                val depth = random.nextInt(3) / 2.0
                val quad = contour(random, raster, 4)
                for (i in 2 until 12 step 3) quad[i] = depth
                builder.polygon(color, quad.copyOfRange(0, 9))
                builder.polygon(color, quad.copyOfRange(0, 3) + quad.copyOfRange(6, 12))
            }
            4 -> {
                // A sliver
                val x = random.nextDouble() * raster.width
                val y = random.nextDouble() * raster.height
                builder.polygon(
                    color,
                    doubleArrayOf(x, y, 0.0, x + 0.3, y + 0.1, 1.0, x + raster.width, y + raster.height, 0.5),
                )
            }
            5 -> builder.add(Bowl(raster, random))
            else -> return scene(random, color).primitives(raster).toList()
        }
        return builder.build().primitives
    }

    private fun contour(random: Random, raster: Raster, vertices: Int): DoubleArray = DoubleArray(3 * vertices) {
        val unit = random.nextDouble()
        when (it % 3) {
            0 -> (unit * 1.6 - 0.3) * raster.width
            1 -> (unit * 1.6 - 0.3) * raster.height
            else -> unit
        }
    }

    private fun scene(random: Random, color: Rgba): Scene {
        val material = Material(color, shading = Shading.entries[random.nextInt(5)], specular = Rgba.WHITE)
        val center = Vector3d(random.nextDouble() * 2 - 1, random.nextDouble() * 2 - 1, random.nextDouble() * 4 - 2)
        val positions = FloatArray(18) { random.nextFloat() * 6 - 3 }
        val mesh = Mesh(positions, IntArray(6) { it }, material)
        val camera = Camera.perspective(
            Vector3d(0.0, 0.0, 3.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 60.0, 0.5, 20.0,
        )
        return Scene(listOf(Sphere(center, random.nextDouble() * 1.5, material), mesh), viewpoint = camera)
    }

    /**
     * A shader whose colour differs between samples, with alpha below 1 at some of them. It is used for opaque
     * primitives.
     */
    private class Waves(private val color: Rgba) : Shader {
        override fun shade(fragment: Fragment) {
            val wave = (fragment.x * 7 + fragment.y * 13 and 15) / 15f
            val alpha = if (fragment.x % 5 == 0) 0.6f else 1f
            fragment.setColor(color.red * wave, color.green, fragment.worldX / 30f, alpha)
        }
    }

    /**
     * A custom primitive: a disc whose depth is not a linear form, with trivial depth bounds, whose spans come from a
     * cursor only.
     */
    private class Bowl(raster: Raster, random: Random) : Primitive {
        private val width = raster.width
        private val centerX = random.nextInt(raster.width)
        private val centerY = random.nextInt(raster.height)
        private val radius = random.nextInt(20)
        private val base = random.nextInt(Int.MAX_VALUE - (1 shl 24))

        override val rowStart: Int = maxOf(centerY - radius, 0)
        override val rowEnd: Int = minOf(centerY + radius + 1, raster.height)
        override val columnStart: Int get() = 0
        override val columnEnd: Int get() = width

        override fun spans(y: Int, spans: Spans) {
            val reach = radius - StrictMath.abs(y - centerY)
            if (reach >= 0) spans.add(maxOf(centerX - reach, 0), minOf(centerX + reach + 1, width))
        }

        override fun depth(x: Int, y: Int): Int = base + (x - centerX) * (x - centerX) * 1000 + (y - centerY) * 77

        override fun shade(fragment: Fragment) =
            fragment.setColor(fragment.x / 32f, fragment.y / 32f, radius / 20f)
    }

    /** Wraps another primitive, with an opacity that differs between samples. */
    private class Glass(private val whole: Primitive, random: Random) : Primitive by whole {
        private val alpha = listOf(0f, 1f, 0.5f, Float.NaN, random.nextFloat(), random.nextFloat())[random.nextInt(6)]
        private val isEven = random.nextBoolean()

        override val isTranslucent: Boolean get() = true

        override fun shade(fragment: Fragment) {
            whole.shade(fragment)
            val opacity = if (isEven || fragment.x % 3 > 0) alpha else fragment.y % 5 / 4f
            fragment.setColor(fragment.red, fragment.green, fragment.blue, opacity)
        }

        override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null
    }
}

/** A rectangle of samples with constant depth and colour; counts the calls. */
internal class Pane(
    private val region: Region,
    private val depth: Int,
    private val color: Rgba,
    override val heldBytes: Long = 256,
) : Primitive {
    var shadingCalls = 0
        private set
    var lastRow = -1
        private set

    override val rowStart: Int get() = region.rowStart
    override val rowEnd: Int get() = region.rowEnd
    override val columnStart: Int get() = region.columnStart
    override val columnEnd: Int get() = region.columnEnd
    override val isTranslucent: Boolean get() = color.alpha < 1f
    override val depthForm: LinearForm get() = LinearForm.constant(depth)

    override fun spans(y: Int, spans: Spans) {
        lastRow = maxOf(lastRow, y)
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun shade(fragment: Fragment) {
        shadingCalls++
        fragment.setColor(color.red, color.green, color.blue, color.alpha)
    }
}
