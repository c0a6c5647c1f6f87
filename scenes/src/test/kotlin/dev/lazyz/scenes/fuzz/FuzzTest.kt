package dev.lazyz.scenes.fuzz

import java.nio.file.Path
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.assertDoesNotThrow
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/**
 * Each loader answers each input with a scene that can be drawn, or with its one exception; soon, and with little
 * memory.
 *
 * A glance in the usual build. How to look for hours stands in `CONTRIBUTING.md`.
 */
class FuzzTest {
    @TempDir
    lateinit var folder: Path

    private val settings = FuzzSettings()

    @TestFactory
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
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
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
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

    /** Cuts small seeds at every byte, and changes a bit of each byte. */
    @TestFactory
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun damagedSeedsAreLoadedOrRefused(): List<DynamicTest> = FuzzTarget.all.map { target ->
        DynamicTest.dynamicTest(target.id) {
            Companions.write(folder)
            val case = LoadAndDraw(target.id, folder)
            for (seed in target.seeds.filter { it.size < SMALL }.ifEmpty { listOf(target.seeds.minBy { it.size }) }) {
                for (at in seed.indices) {
                    val changed = seed.copyOf().also { it[at] = (it[at].toInt() xor 1).toByte() }
                    for (bytes in listOf(changed, seed.copyOf(at))) {
                        assertDoesNotThrow({ "byte $at of ${seed.size}" }) { case.load(bytes) }
                    }
                }
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
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

    private companion object {
        const val SMALL = 450
    }
}
