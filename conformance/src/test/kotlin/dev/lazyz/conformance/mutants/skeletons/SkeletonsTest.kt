package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Capability
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.setup.FrameBuilder
import kotlin.random.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class SkeletonsTest {
    @Test
    fun skeletonsAreRight() {
        for (frame in frames()) {
            val expected = ReferenceRenderer().render(frame)
            for (renderer in Skeletons.correct.map { it() }) {
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
}
