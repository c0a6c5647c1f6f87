package dev.lazyz.raster

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.behindAll
import dev.lazyz.samples
import dev.lazyz.spi.Fragment
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
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
}
