package dev.lazyz.raster

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.behindAll
import dev.lazyz.samples
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.scene
import java.util.Random
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.Provide
import net.jqwik.api.constraints.IntRange
import org.junit.jupiter.api.Assertions.assertEquals

/** Contract rules 4.3 and 5: which fragment is visible. */
class VisibilityProperties {
    @Provide
    fun tests(): Arbitrary<DepthTest> = Arbitraries.of(DepthTest::class.java)

    @Property(seed = "1995", tries = 1000)
    fun rule_5_1_keysSortByDepthAndThenByIndex(
        @ForAll("tests") test: DepthTest,
        @ForAll @IntRange(min = 0) depthA: Int,
        @ForAll @IntRange(min = 0) depthB: Int,
        @ForAll @IntRange(min = -1, max = Int.MAX_VALUE - 1) indexA: Int,
        @ForAll @IntRange(min = -1, max = Int.MAX_VALUE - 1) indexB: Int,
    ) {
        val key = test.key(depthA, indexA)
        assertEquals(depthA, test.depthOf(key))
        assertEquals(indexA, test.indexOf(key))
        val isGreater = test == DepthTest.GREATER || test == DepthTest.GREATER_OR_EQUAL
        val isLast = test == DepthTest.LESS_OR_EQUAL || test == DepthTest.GREATER_OR_EQUAL
        val byDepth = if (isGreater) depthB.compareTo(depthA) else depthA.compareTo(depthB)
        val byIndex = if (isLast) indexB.compareTo(indexA) else indexA.compareTo(indexB)
        val expected = if (byDepth != 0) byDepth else byIndex
        assertEquals(expected, Integer.signum(key.compareTo(test.key(depthB, indexB))))
        assertEquals(byIndex, Integer.signum(key.compareTo(test.key(depthA, indexB))))
    }

    @Property(seed = "1995", tries = 200, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_1_whatIsVisibleIsTheLeastByDepthAndIndex(
        @ForAll random: Random,
        @ForAll("tests") test: DepthTest,
        @ForAll @IntRange(min = 0, max = 12) count: Int,
        @ForAll @IntRange(min = 0, max = 3) quarter: Int,
    ) {
        val background = listOf(test.behindAll, Depth.ofUnit(0.25 * quarter)).random(random)
        val raster = Raster(16, 16, Rgba.BLACK, depthTest = test, backgroundDepth = background)
        val frame = SampleScenes.drawn(random, raster, count)
        val image = ZBufferRenderer().render(frame)
        val covered = frame.primitives.map { it.samples(raster) }
        val fragment = Fragment()
        for (y in 0 until 16) {
            for (x in 0 until 16) {
                // The minimum as defined by rules 5.1 to 5.3
                var index = -1
                var depth = background
                for ((i, primitive) in frame.primitives.withIndex()) {
                    if (!covered[i][x, y]) continue
                    val candidate = primitive.depth(x, y)
                    val passes = when (test) {
                        DepthTest.LESS -> candidate < depth
                        DepthTest.LESS_OR_EQUAL -> candidate <= depth
                        DepthTest.GREATER -> candidate > depth
                        DepthTest.GREATER_OR_EQUAL -> candidate >= depth
                    }
                    if (!passes) continue
                    index = i
                    depth = candidate
                }
                assertEquals(index, image.primitive(x, y)) { "visible at $x, $y" }
                assertEquals(depth, image.depth(x, y)) { "depth at $x, $y" }
                var argb = Rgba.BLACK.toArgb()
                if (index >= 0) {
                    fragment.moveTo(x, y)
                    frame.primitives[index].shade(fragment)
                    argb = fragment.toArgb()
                }
                assertEquals(argb, image.argb(x, y)) { "colour at $x, $y" }
            }
        }
    }

    private fun <T> List<T>.random(random: Random): T = this[random.nextInt(size)]

    @Property(seed = "1995", tries = 30, edgeCases = EdgeCasesMode.NONE)
    fun rule_4_1_bothConventionsShowTheSame(@ForAll random: Random) {
        val scene = SampleScenes.mixed(random)
        val usual = ZBufferRenderer().render(scene.frame(Raster(24, 20)))
        val mirrored =
            ZBufferRenderer().render(scene.frame(Raster(24, 20, convention = DepthConvention.LARGER_IS_NEARER)))
        assertEquals(usual.argb.toList(), mirrored.argb.toList())
        assertEquals(usual.primitive.toList(), mirrored.primitive.toList())
        for (i in usual.depth.indices) assertEquals(0, (Int.MAX_VALUE - mirrored.depth[i] - usual.depth[i]) / 2)
    }

    @Property(seed = "1995", tries = 60, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_1_mergedPartsEqualTheWholePicture(@ForAll random: Random, @ForAll("tests") test: DepthTest) {
        val raster = Raster(16, 12, depthTest = test, backgroundDepth = test.behindAll)
        val frame = SampleScenes.drawn(random, raster, 9)
        val whole = ZBufferRenderer().render(frame)

        // Split by primitives, into three parts
        val part = IntArray(9) { random.nextInt(3) }
        val parts = List(3) { p -> ZBufferRenderer().render(frame.keeping { part[it] == p }) }
        val (a, b, c) = parts.shuffled(random)
        assertEquals(whole, Image.merge(Image.merge(a, b, raster), c, raster))
        assertEquals(whole, Image.merge(a, Image.merge(c, b, raster), raster))
        assertEquals(whole, Image.merge(whole, a, raster))

        // Split by regions, into two parts
        val column = 1 + random.nextInt(15)
        val left = ZBufferRenderer().render(frame.within(Region(0, 0, column, 12)))
        val right = ZBufferRenderer().render(frame.within(Region(column, 0, 16, 12)))
        assertEquals(whole, Image.merge(right, left, raster))
    }
}
