package dev.lazyz.conformance.probes

import dev.lazyz.Capability
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.RenderOptions.Coherence
import dev.lazyz.Renderer
import dev.lazyz.conformance.cases.ALL_GLASS
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.cases.changed.on
import dev.lazyz.conformance.cases.changed.within
import dev.lazyz.conformance.cases.glazed
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.oracle.Selection
import net.jqwik.api.Arbitrary
import net.jqwik.api.ArbitrarySupplier

/** Whether the renderings of a [Combination] run one after the other or at the same time. */
internal enum class Concurrency { ONE_BY_ONE, AT_ONCE }

/**
 * Several renderings by one renderer, with settings that may differ from the default.
 *
 * @param choices [Choices.COUNT] numbers that determine the settings; 0 is always the default, so that shrinking a
 *   failure keeps only the relevant settings
 */
internal class Combination(cases: List<FrameCase>, private val choices: List<Int>) {
    /** The options of the renderer, without the selector. */
    val options: RenderOptions = RenderOptions(
        Coherence.entries.chosen(0),
        listOf(null, null, null, 0L, 1_000L, 100_000L).chosen(1),
        listOf(1, 2, 3, 5).chosen(2),
        listOf(64, 8, 16, 32, 128, 512).chosen(3),
    )

    val turns: Concurrency = listOf(Concurrency.ONE_BY_ONE, Concurrency.ONE_BY_ONE, Concurrency.AT_ONCE).chosen(4)

    /** The renderings, in order. */
    val steps: List<Step> = cases.mapIndexed { i, case -> Step(case, OPTIONS + i * STEP) }

    private fun <T> List<T>.chosen(number: Int): T = this[choices[number] % size]

    /** One rendering: a frame and its settings. Its choices begin with number [first]. */
    inner class Step(private val case: FrameCase, private val first: Int) {
        /** The query that throws in an extra rendering just before this one, or null for no such rendering. */
        val failing: Question? = (List<Question?>(USUAL) { null } + Question.entries).chosen(first)

        /** Number of queries that are answered before one throws. */
        val answers: Int = choices[first + 1]

        /** The selector's name, or null for none. */
        val selection: String? = (List<String?>(USUAL) { null } + Selection.all.keys).chosen(first + 2)

        /** Whether the primitives arrive one by one, if the renderer can take them so. */
        private val isOneByOne: Boolean = listOf(false, false, true).chosen(first + 9)

        /** Returns [renderer], or how it renders primitives that arrive one by one. */
        fun way(renderer: Renderer): Renderer = if (isOneByOne) renderer.ways().last() else renderer

        /**
         * Returns the frame on a raster whose background is behind everything, in the middle, or in front of
         * everything.
         */
        private fun onItsBackground(): FrameCase {
            val before = Int.MAX_VALUE - Rasters.behindAll(case.frame.raster.depthTest)
            val depth = (List<Int?>(USUAL) { null } + Int.MAX_VALUE / 2 + before).chosen(first + 8) ?: return case
            return case.on(case.frame.raster.withBackgroundDepth(depth))
        }

        /** Returns the frame for a renderer with these [capabilities]. */
        fun caseFor(capabilities: Set<Capability>): FrameCase {
            val case = onItsBackground()

            // Which primitives become glass, as bits: none, all, or a mixture
            val glaze = listOf(0, 0, ALL_GLASS, choices[first + 3] * 657).chosen(first + 3)
            val glazed = if (glaze != 0 && Capability.TRANSPARENCY in capabilities) case.glazed(glaze) else case
            val raster = case.frame.raster
            val (columnStart, columnEnd) = part(raster.width, first + 4)
            val (rowStart, rowEnd) = part(raster.height, first + 6)
            val region = Region(columnStart, rowStart, columnEnd, rowEnd)
            return if (region == raster.region) glazed else glazed.within(region)
        }

        /**
         * Returns the selector; null if none is chosen, if the renderer does not support selectors, or if the oracle
         * would take too long.
         */
        fun selectionFor(capabilities: Set<Capability>): Selection? {
            if (selection == null || Capability.SELECTION !in capabilities) return null
            val frame = caseFor(capabilities).frame
            return Selection.all.getValue(selection).takeIf {
                frame.region.size * frame.primitives.size < FEW_FRAGMENTS
            }
        }

        /**
         * Returns start and end of the region in one dimension, from the choices [number] and the next. Small ones
         * select the whole side.
         */
        private fun part(side: Int, number: Int): Pair<Int, Int> {
            val start = side * maxOf(0, choices[number] - Choices.MOST / 2) / Choices.MOST
            return start to side - (side - start - 1) * maxOf(0, choices[number + 1] - Choices.MOST / 2) / Choices.MOST
        }
    }

    companion object {
        /** Greatest number of frames in a combination. */
        const val MOST_FRAMES: Int = 3

        private const val OPTIONS = 5
        private const val STEP = 10

        /** Number of default values per other value in a list of choices. */
        private const val USUAL = 8
        private const val FEW_FRAGMENTS = 5_000L
    }

    /** Generates the numbers of a [Combination]. */
    internal class Choices : ArbitrarySupplier<List<Int>> {
        override fun get(): Arbitrary<List<Int>> = ints(0, MOST).list().ofSize(COUNT).withoutEdgeCases()

        companion object {
            const val MOST: Int = 99
            const val COUNT: Int = OPTIONS + MOST_FRAMES * STEP
        }
    }

    /** Generates one to three frames of all kinds, most of them larger than those of other rules. */
    internal class Cases : ArbitrarySupplier<List<FrameCase>> {
        override fun get(): Arbitrary<List<FrameCase>> {
            val all = FrameMix.usual()
                .with(FrameKind.POLYGONS_IN_SPACE, 5)
                .with(FrameKind.MESHES, 6)
                .with(FrameKind.NEAR_PLANE, 4)
            val onScreen = FrameKind.entries.filter { it.isInSpace }
                .fold(FrameMix.usual()) { mix, it -> mix.with(it, 0) }
            val frames = mixed(
                5 to Frames.of(all.sized(131, 97).counted(0, 16)),
                2 to Frames.of(all.sized(24, 20).counted(0, 12)),
                1 to Frames.of(onScreen.sized(41, 31).counted(0, 40).layered(12)),
                1 to Frames.of(onScreen.sized(331, 23).counted(0, 12)),
                1 to Frames.of(onScreen.sized(23, 331).counted(0, 12)),
            )
            return frames.list().ofMinSize(1).ofMaxSize(MOST_FRAMES).withoutEdgeCases()
        }
    }
}
