package dev.lazyz.conformance.fuzz

import dev.lazyz.Renderer
import dev.lazyz.conformance.mutants.wrappers.BasicMistakes
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.hierarchical.HierarchicalRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.nio.file.Path
import java.util.Random
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readLines
import net.jqwik.api.sessions.JqwikSession
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class DifferentialFuzzingTest {
    private fun fuzzing(actual: Renderer, frames: Long = FRAMES) =
        DifferentialFuzzing({ ZBufferRenderer() }, { actual }).frames(frames)

    @Test
    fun renderersThatAgreeAreFoundToAgree() {
        val report = fuzzing(HierarchicalRenderer()).run()
        assertTrue(report.isEqual, report.toText())
        assertEquals(FRAMES, report.frames)
        assertTrue("hierarchical against zbuffer: $FRAMES frames, 0 of them from the corpus" in report.toText())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun differenceIsFoundMadeSmallAndKept(@TempDir folder: Path) {
        val report = fuzzing(BasicMistakes.lastWinsTies()).corpus(folder).run()
        assertFalse(report.isEqual)
        val smallest = report.differences.minBy { it.length }
        assertTrue("is the first of" in smallest && "recipe KIND=" in smallest, smallest)
        assertTrue(smallest.lines().size < 12, smallest)

        // Its scene file exists, too, and can be read
        val kept = folder.resolve("differences").listDirectoryEntries()
        assertEquals(report.differences.size, kept.count { "$it".endsWith(".txt") })
        for (file in kept.filter { "$it".endsWith(".json") }) Scenes.load(file)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun corpusIsWhatTheNextRunBeginsWith(@TempDir folder: Path) {
        fuzzing(HierarchicalRenderer()).corpus(folder).run()
        val recipes = folder.resolve("recipes.txt").readLines()
        assertTrue(recipes.size > FRAMES / 2, "$recipes")

        // A known difference is found again, although nothing new is tried
        val again = fuzzing(BasicMistakes.lastWinsTies(), recipes.size.toLong()).corpus(folder).run()
        assertEquals(again.frames, again.remembered)
        assertFalse(again.isEqual)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun exceptionOfOneIsADifference() {
        val report = fuzzing(BasicMistakes.needsTwoColumns(), 5 * FRAMES).run()
        assertTrue(report.differences.any { "the second java.lang.IllegalStateException" in it }, report.toText())
    }

    @Test
    fun recipeIsMadeAgainFromItsText() {
        val random = Random(1)
        repeat(100) {
            val recipe = Recipe.any(random).changed(random).varied(random)
            assertEquals(recipe, Recipe.parse("$recipe"))
        }
        assertEquals(null, Recipe.parse("# no recipe"))
    }

    /** So that the search is guided to pairs of, for example, a normal map and a spot. */
    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun traitsOfScenesAreKnown() {
        val random = Random(1)
        val recipes = generateSequence { Recipe.any(random) }
            .filter { it[Ingredient.KIND] == "MESHES" && it[Ingredient.SECOND_KIND] == "LINES" && it.cost < 100_000 }
        val traits = HashSet<String>()
        JqwikSession.run { for (it in recipes.take(20)) traits.addAll(it.traits(it.frame().value())) }
        for (trait in listOf("KIND=MESHES", "MESH", "LINES", "SPOT", "SECOND_UVS")) assertTrue(trait in traits, trait)
    }

    @Test
    fun framesBecomeUnlikeEachOther() {
        val pairs = TraitPairs()
        assertEquals(3, pairs.add(setOf("a", "b", "c")))
        assertEquals(2, pairs.add(setOf("a", "b", "d")))
        assertTrue(pairs.rarity(setOf("c", "d")) > pairs.rarity(setOf("a", "b")))
        assertEquals(5, pairs.size)
    }

    private companion object {
        const val FRAMES = 12L
    }
}
