package dev.lazyz.scenes.fuzz

import java.nio.file.Path
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/**
 * Each loader answers each input with a scene that can be drawn, or with its one exception; soon, and with little
 * memory.
 *
 * A glance in the usual build. How to look for hours stands in `CONTRIBUTING.md`.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class FuzzTest {
    @TempDir
    lateinit var folder: Path

    private val settings = FuzzSettings()

    @TestFactory
    fun everyInputIsLoadedOrRefused(): List<DynamicTest> {
        val targets = settings.targets
        return targets.map { target ->
            DynamicTest.dynamicTest(target.id) {
                Companions.write(folder)
                val fuzzer = Fuzzer(target, settings, folder)
                println("Fuzzing ${fuzzer.run(settings.seconds / targets.size)}")
                assertTrue(fuzzer.findings.isEmpty(), fuzzer.findings.joinToString("\n"))
            }
        }
    }

    @Test
    fun everySeedIsLoaded() {
        Companions.write(folder)
        for (target in FuzzTarget.all) {
            assertTrue(target.seeds.isNotEmpty(), "seeds of $target")
            val case = LoadAndDraw(target.id, folder)
            for ((i, seed) in target.seeds.withIndex()) {
                val loaded = case.load(seed)
                assertTrue(loaded.isScene, "seed $i of $target: ${loaded.messages}")
            }
        }
    }

    @Test
    fun theSameSeedMakesTheSameInputs() {
        for (target in FuzzTarget.all) assertEquals(inputs(target), inputs(target), target.id)
    }

    private fun inputs(target: FuzzTarget): List<Int> {
        val random = Random(1)
        return List(200) { i ->
            val mutations = target.mutations[i % target.mutations.size]
            mutations.mutate(target.seeds[i % target.seeds.size], target.seeds.first(), random).contentHashCode()
        }
    }
}
