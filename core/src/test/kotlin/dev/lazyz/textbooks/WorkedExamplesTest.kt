package dev.lazyz.textbooks

import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.ProjectFiles
import dev.lazyz.Raster.DepthConvention.LARGER_IS_NEARER
import dev.lazyz.strategies.Renderers
import dev.lazyz.textbooks.WorkedExample.Companion.text
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The worked examples of `docs/textbooks.md`: all strategies give the arrays that are on the page. */
class WorkedExamplesTest {
    private val page = ProjectFiles.root.resolve("docs/textbooks.md")

    @Test
    fun allStrategiesGiveTheBufferAfterEachStep() {
        for (example in WorkedExamples.all) {
            for (renderer in Renderers.builtIn) {
                for ((step, expected) in example.depths.withIndex()) {
                    val image = renderer.render(example.frame(step))
                    val place = "${renderer.id}, ${example.name} after $step steps"
                    assertEquals(expected, text(example.depthsOf(image)), place)
                    if (step == example.shapes.size) assertEquals(example.owners, text(example.ownersOf(image)), place)
                }
            }
        }
    }

    @Test
    fun theOrderOfDrawingDecidesOnlyTies() {
        val example = WorkedExamples.row
        for (renderer in Renderers.builtIn) {
            // As textbooks do that compare with <= instead of <: the last one wins a tie
            val lastWins = renderer.render(example.frame(test = DepthTest.LESS_OR_EQUAL))
            assertEquals("A A C C B B B B", text(example.ownersOf(lastWins)), renderer.id)
            assertEquals(example.depths.last(), text(example.depthsOf(lastWins)), renderer.id)

            val frame = example.frame()
            val backwards = renderer.render(Frame(frame.raster, frame.primitives.reversed()))
            assertEquals(example.depths.last(), text(example.depthsOf(backwards)), renderer.id)
            assertEquals(listOf(2, 2, 0, 0, 1, 1, 1, 1), backwards.primitive.toList(), renderer.id)
        }
    }

    @Test
    fun theOtherDirectionOfDepthShowsTheSame() {
        for (example in WorkedExamples.all) {
            for (renderer in Renderers.builtIn) {
                // A buffer that is cleared to 0, and in which greater is nearer
                val image = renderer.render(example.frame(convention = LARGER_IS_NEARER))
                val place = "${renderer.id}, ${example.name}"
                assertEquals(example.owners, text(example.ownersOf(image)), place)
                assertEquals(example.depths.last(), text(example.depthsOf(image, LARGER_IS_NEARER)), place)
            }
        }
    }

    @Test
    fun thePageShowsTheseArrays() {
        val shown = page.readText()
        var from = 0
        for (example in WorkedExamples.all) {
            val at = shown.indexOf("images/${example.name}.svg", from)
            assertTrue(at >= 0) { "$page must show images/${example.name}.svg" }
            from = at
            for (block in listOf(example.depths.last(), example.owners)) {
                val found = shown.indexOf(block.prependIndent("    "), from)
                assertTrue(found >= 0) { "$page must show, in this order,\n$block" }
                from = found
            }
        }
    }

    @Test
    fun thePicturesShowTheseArrays() {
        for (example in WorkedExamples.all) {
            val file = ProjectFiles.root.resolve("docs/images/${example.name}.svg")
            val drawn = StepsPicture.of(example)
            if (System.getProperty("lazyz.update") == "true") file.writeText(drawn)
            assertTrue(file.exists() && file.readText() == drawn) {
                "$file is not up to date: run this test with -Dlazyz.update=true"
            }
        }
    }
}
