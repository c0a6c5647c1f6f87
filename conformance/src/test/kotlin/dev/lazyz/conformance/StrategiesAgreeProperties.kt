package dev.lazyz.conformance

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.changed.within
import dev.lazyz.conformance.frames.ConfettiCases
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.frames.ScreenCases
import dev.lazyz.conformance.frames.TiedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.frames.WorldCases
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.shared.NotByDefault
import dev.lazyz.strategies.Renderers
import java.util.Random
import java.util.function.Predicate
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.ArbitrarySupplier
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.lifecycle.AddLifecycleHook
import net.jqwik.api.statistics.Statistics
import org.junit.jupiter.api.Assertions.assertTrue

/**
 * The main promise of the library: all built-in renderers give the same bits, on 2,800 frames, with random options and
 * in random regions. By default half of the frames are rendered, each by the first renderer and by about a quarter of
 * the others; with the effort `rest` all by the rest, and with `full` by all; see [TestEffort].
 *
 * [RendererConformance] compares each with the oracle, on fewer frames. This test compares them with each other.
 */
class StrategiesAgreeProperties {
    @Property(tries = 600, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_onTheScreen(@ForAll(supplier = ScreenCases::class) case: FrameCase, @ForAll salt: Long) =
        agree(case, salt)

    @Property(tries = 450, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_onTies(@ForAll(supplier = TiedCases::class) case: FrameCase, @ForAll salt: Long) = agree(case, salt)

    @Property(tries = 500, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_onPrimitivesOfOnesOwn(@ForAll(supplier = ConfettiCases::class) case: FrameCase, @ForAll salt: Long) =
        agree(case, salt)

    @Property(tries = 600, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_7_1_inScenes(@ForAll(supplier = WorldCases::class) case: FrameCase, @ForAll salt: Long) = agree(case, salt)

    /** Rasters of several tiles and subdivisions, and enough primitives to hide each other. */
    @Property(tries = 50, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    @AddLifecycleHook(NotByDefault::class)
    fun rule_7_1_onLargerFrames(@ForAll(supplier = LargerCases::class) case: FrameCase, @ForAll salt: Long) =
        agree(case, salt)

    @Property(tries = 600, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_5_onTranslucentFrames(@ForAll(supplier = TranslucentCases::class) case: FrameCase, @ForAll salt: Long) =
        agree(case, salt)

    private fun agree(case: FrameCase, salt: Long) {
        if (TestEffort.isDefault && salt % 2 == 0L) return
        val random = Random(salt)
        val part = if (random.nextInt(3) == 0) case.within(region(case.frame, random)) else case
        val renderers = Renderers.builtIn.filter {
            !part.frame.hasTranslucency || Capability.TRANSPARENCY in it.capabilities
        }
        val configured = renderers.map { it.configured(options(random).supportedBy(it)) }.filterIndexed { i, _ ->
            i == 0 || (random.nextInt(4) == 0) == TestEffort.isDefault || TestEffort.isFull
        }
        val images = configured.map { it to it.render(part.frame) }
        val (first, expected) = images.first()
        for ((renderer, image) in images) {
            difference(expected, image)?.let {
                throw AssertionError("$renderer and $first do not agree: $it\nin\n$part")
            }
        }
        count(part.frame, expected, renderers)
    }

    /** Collects statistics of the frames, because a run of empty pictures would prove nothing. */
    private fun count(frame: Frame, image: Image, renderers: List<Renderer>) {
        assertTrue(renderers.isNotEmpty())
        val visible = image.primitive.distinct().count { it >= 0 }
        Statistics.label("several primitives visible").collect(visible > 1)
        Statistics.label("several primitives visible").coverage {
            it.check(true).percentage(Predicate { share -> share > 25.0 })
        }
        Statistics.label("something hidden").collect(image.counters.fragments > image.visible)
        Statistics.label("something hidden").coverage {
            it.check(true).percentage(Predicate { share -> share > 40.0 })
        }
        Statistics.label("nothing visible").collect(visible == 0)
        Statistics.label("nothing visible").coverage {
            it.check(true).percentage(Predicate { share -> share < 45.0 })
        }
        Statistics.label("part of the raster").collect(image.region != frame.raster.region)
    }

    private fun options(random: Random) = RenderOptions(
        Coherence.entries[random.nextInt(Coherence.entries.size)],
        if (random.nextBoolean()) null else random.nextInt(4000).toLong(),
        1 + random.nextInt(3),
        8 shl random.nextInt(3),
    )

    private fun region(frame: Frame, random: Random): Region {
        val columnStart = random.nextInt(frame.width)
        val rowStart = random.nextInt(frame.height)
        return Region(
            columnStart,
            rowStart,
            columnStart + 1 + random.nextInt(frame.width - columnStart),
            rowStart + 1 + random.nextInt(frame.height - rowStart),
        )
    }

    private companion object {
        const val SEED = "1995"
    }
}

/** Frames of more samples and more primitives than the rules need. */
class LargerCases : ArbitrarySupplier<FrameCase> {
    override fun get(): Arbitrary<FrameCase> = Arbitraries.oneOf(
        listOf(Frames.screen(70, 70, 60), Frames.tied(50, 40), Frames.world(70, 30)),
    ).withoutEdgeCases()
}
