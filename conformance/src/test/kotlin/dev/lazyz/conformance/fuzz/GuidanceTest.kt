package dev.lazyz.conformance.fuzz

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.RowSink
import dev.lazyz.conformance.ChildJvm
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.lists.ListsRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.lang.management.ManagementFactory
import java.nio.file.Path
import java.time.Duration
import java.util.Random
import net.jqwik.api.sessions.JqwikSession
import org.jacoco.agent.AgentJar
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class GuidanceTest {
    /** With -Dlazyz.fuzz.frames=N, measures what guidance gains. */
    @Test
    fun probesOfTheAgentGuide(@TempDir folder: Path) {
        val agent = folder.resolve("jacocoagent.jar").also { AgentJar.extractTo(it.toFile()) }
        val options = listOf("-javaagent:$agent=output=none,includes=dev.lazyz.strategies.*")
        val frames = Integer.getInteger("lazyz.fuzz.frames")
        val strategies = if (frames == null) listOf("scanline") else listOf("tiled", "scanline", "bsp", "raycast")
        for (strategy in strategies) {
            for (isGuided in if (frames == null) listOf(true) else listOf(false, true)) {
                val process = ChildJvm.start(options, FuzzedFrames::class, strategy, "${frames ?: 12}", "$isGuided")
                val text = process.inputStream.readAllBytes().decodeToString()
                assertEquals(0, process.waitFor(), text)
                assertTrue(Regex("[1-9][0-9,]* probes; no picture differs").containsMatchIn(text), text)
                if (frames != null) println(if (isGuided) "guided: $text" else "not guided: $text")
            }
        }
    }

    /** Of the two rare conditions, the first is a branch that is seen to be reached. */
    @Test
    fun mistakeBehindTwoRareConditionsIsFound() {
        fun run(isGuided: Boolean, frames: Long): DifferentialReport {
            val probes = NamedProbes()
            return DifferentialFuzzing({ ZBufferRenderer() }, { TwoConditions(probes) })
                .probes(probes, isGuided).mostSamples(SMALL).frames(frames).time(Duration.ofDays(1)).run()
        }
        val guided = run(isGuided = true, 60)
        assertFalse(guided.isEqual, guided.toText())
        val unguided = run(isGuided = false, FRAMES)
        assertTrue(unguided.isEqual && unguided.probes == 1, unguided.toText())
    }

    @Test
    fun mistakeThatNeedsTheFrameBeforeIsReducedToTwoFrames() {
        val report = DifferentialFuzzing({ ZBufferRenderer() }, { Remembers() })
            .mostSamples(SMALL).frames(60).time(Duration.ofDays(1)).run()
        assertFalse(report.isEqual)
        for (difference in report.differences) assertTrue("in the last of 2 frames" in difference, difference)
        assertTrue(report.differences.any { "Raster(1, 2, " in it }, report.toText())
    }

    @Test
    fun mistakeThatDoesNotOccurAgainIsReported() {
        val unlucky = object : PlainRenderer() {
            var frames = 0

            override fun render(frame: Frame, sink: RowSink): Counters =
                if (++frames == 5) error("once") else super.render(frame, sink)
        }
        val report = DifferentialFuzzing({ ZBufferRenderer() }, { unlucky }).mostSamples(SMALL).frames(9).run()
        assertTrue("but not again with the same frames" in report.differences.single(), report.toText())
    }

    /** So that what was rare in it is still there. */
    @Test
    fun variedFrameIsMostlyTheSame() {
        val random = Random(1)
        val recipe = generateSequence { Recipe.any(random) }.first { it.cost < SMALL && "REGION" !in "$it" }
        JqwikSession.run {
            val lines = recipe.frame().value().code.lines().toSet()
            val shares = List(20) {
                recipe.varied(random).frame().value().code.lines().count { it in lines } / lines.size.toDouble()
            }
            assertTrue(shares.count { it > 0.5 } > 8, "$shares")
        }
    }

    private companion object {
        /** Samples times primitives. */
        const val SMALL = 10_000L
        const val FRAMES = 600L
    }
}

/** What tests reach, by numbers. */
private class NamedProbes : Probes {
    private val all = HashSet<Int>()
    private val last = HashSet<Int>()
    override val reached: Int get() = all.size

    fun reach(number: Int) = last.add(number)

    override fun forget() = last.clear()

    override fun take(): Int = last.count { all.add(it) }
}

/** Throws for thirteen primitives in front of a background that hides some, with a depth test that is seldom used. */
private class TwoConditions(private val probes: NamedProbes) : PlainRenderer() {
    override fun render(frame: Frame, sink: RowSink): Counters {
        val isRare = with(frame.raster) {
            convention == DepthConvention.LARGER_IS_NEARER && depthTest == DepthTest.LESS_OR_EQUAL &&
                backgroundDepth !in listOf(0, Int.MAX_VALUE)
        }
        if (isRare) {
            probes.reach(1)
            check(frame.primitives.size != 13) { "thirteen" }
        }
        return super.render(frame, sink)
    }
}

/** Wrong for wide frames after narrow ones. */
private class Remembers : PlainRenderer() {
    private var wasNarrow = false

    override fun render(frame: Frame, sink: RowSink): Counters {
        val isWrong = wasNarrow && frame.width > frame.height
        wasNarrow = frame.width < frame.height
        check(!isWrong) { "wide after narrow" }
        return super.render(frame, sink)
    }
}

/** A program that compares a strategy with another on some frames. */
internal object FuzzedFrames {
    @JvmStatic
    fun main(args: Array<String>) {
        val (id, frames, isGuided) = args
        val report = DifferentialFuzzing({ ListsRenderer() }, { Renderers.builtIn.first { it.id == id } })
            .probes(AgentProbes.find(), isGuided.toBoolean()).frames(frames.toLong()).time(Duration.ofDays(1)).run()
        val system = ManagementFactory.getOperatingSystemMXBean() as com.sun.management.OperatingSystemMXBean
        println("${report.toText().trim()}, ${system.processCpuTime / 1_000_000_000} s of processor time")
    }
}
