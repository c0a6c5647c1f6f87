package dev.lazyz.conformance.strangers

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.DepthConvention
import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.Spans
import dev.lazyz.world.FrameBuilder
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class StrangersGalleryTest {
    @Test
    fun idsAreUnique() {
        assertEquals(StrangersGallery.all.size, StrangersGallery.all.map { it.id }.toSet().size)
    }

    @Test
    fun basesAreRight() {
        for (frame in frames()) {
            val expected = bruteForce(frame)
            for (renderer in StrangersGallery.correct.map { it() }) {
                if (frame.hasTranslucency && Capability.TRANSPARENCY !in renderer.capabilities) continue
                val image = renderer.render(frame)
                assertEquals(expected, image) { "${renderer.id}: $frame" }
                assertEquals(expected.counters.primitives, image.counters.primitives)
            }
        }
    }

    private fun frames(): List<Frame> {
        val random = Random(1)
        return List(40) { number ->
            val convention = DepthConvention.entries[number % 2]
            val test = DepthTest.entries[number / 2 % 4]
            val background = Rgba(0.2f, 0.3f, 0.4f, 0.5f)
            val raster = Raster(1 + random.nextInt(90), 1 + random.nextInt(90), background, convention, test)
            val builder = FrameBuilder(raster)
            repeat(random.nextInt(30)) { builder.polygon(color(random, number >= 30), triangle(random)) }
            val frame = builder.build()
            if (number % 3 == 0) frame.within(part(raster, random)) else frame
        }
    }

    private fun color(random: Random, mayBeTranslucent: Boolean): Rgba {
        val alpha = if (mayBeTranslucent) random.nextFloat() else 1f
        return Rgba(random.nextFloat(), random.nextFloat(), random.nextFloat(), alpha)
    }

    private fun triangle(random: Random): DoubleArray {
        val level = random.nextInt(3) / 2.0
        return DoubleArray(9) {
            if (it % 3 < 2) {
                random.nextDouble() * 120 - 20
            } else if (level < 0.7) {
                level
            } else {
                random.nextDouble()
            }
        }
    }

    private fun part(raster: Raster, random: Random): Region {
        val left = random.nextInt(raster.width)
        val top = random.nextInt(raster.height)
        val width = 1 + random.nextInt(raster.width - left)
        return Region(left, top, left + width, top + 1 + random.nextInt(raster.height - top))
    }

    /** All fragments of each sample, sorted by key. */
    private fun bruteForce(frame: Frame): Image {
        val collector = Image.Collector(frame.region)
        val argb = IntArray(frame.width)
        val depth = IntArray(frame.width)
        val indices = IntArray(frame.width)
        for (y in frame.region.rowStart until frame.region.rowEnd) {
            for (i in 0 until frame.width) {
                val x = frame.region.columnStart + i
                val keys = keys(frame, x, y)
                val least = keys.firstOrNull() ?: frame.raster.run { depthTest.key(backgroundDepth, -1) }
                depth[i] = frame.raster.depthTest.depthOf(least)
                indices[i] = frame.raster.depthTest.indexOf(least)
                argb[i] = blended(frame, x, y, keys.map { frame.primitives[frame.raster.depthTest.indexOf(it)] })
            }
            collector.row(y, argb, depth, indices)
        }
        return collector.toImage(Counters.Builder().apply { primitives = frame.primitives.size.toLong() }.build())
    }

    private fun keys(frame: Frame, x: Int, y: Int): List<Long> {
        val raster = frame.raster
        return frame.primitives.withIndex().filter { (_, primitive) -> covers(primitive, x, y) }
            .map { (index, primitive) -> raster.depthTest.key(primitive.depth(x, y), index) }
            .filter { it < raster.depthTest.key(raster.backgroundDepth, DepthTest.BACKGROUND) }.sorted()
    }

    private fun covers(primitive: Primitive, x: Int, y: Int): Boolean {
        val spans = Spans()
        primitive.spans(y, spans)
        return (0 until spans.count).any { x in spans.start(it) until spans.end(it) }
    }

    private fun blended(frame: Frame, x: Int, y: Int, primitives: List<Primitive>): Int {
        val background = frame.raster.background
        val shaded = primitives.map { primitive -> Fragment().also { it.moveTo(x, y) }.also(primitive::shade) }
        val end = primitives.indexOfFirst { !it.isTranslucent }
        val backdrop = if (end < 0) background else shaded[end].run { Rgba(red, green, blue, alpha) }
        val sums = FloatArray(4)
        var through = 1f
        for (fragment in shaded.take(if (end < 0) shaded.size else end).filter { it.alpha > 0f } + null) {
            val color = fragment?.run { Rgba(red, green, blue, alpha) } ?: backdrop
            if (fragment == null && sums[3] == 0f) return backdrop.toArgb()
            val weight = through * color.alpha
            sums[0] += weight * color.red
            sums[1] += weight * color.green
            sums[2] += weight * color.blue
            sums[3] += weight
            through *= 1f - color.alpha
        }
        return Rgba(sums[0] / sums[3], sums[1] / sums[3], sums[2] / sums[3], sums[3]).toArgb()
    }
}
