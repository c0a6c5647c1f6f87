package dev.lazyz.scenes.scenefile

import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.io.TempDir

/** Every example of docs/scene-file.md is a whole scene file that reads without a warning. */
class SceneFilePageTest {
    @TempDir
    lateinit var folder: Path

    private val page = Files.readString(Path.of("..", "docs", "scene-file.md"))
    private val examples = Regex("```json\n(.*?)```", RegexOption.DOT_MATCHES_ALL).findAll(page).map {
        it.groupValues[1]
    }.toList()

    @TestFactory
    fun everyExampleIsRead(): List<DynamicTest> = examples.mapIndexed { index, text ->
        dynamicTest("example ${index + 1}") {
            // The files that the examples refer to
            Files.writeString(
                folder.resolve("bracket.stl"),
                """
                solid b
                facet normal 0 0 1
                outer loop
                vertex 0 0 0
                vertex 1 0 0
                vertex 0 1 0
                endloop
                endfacet
                endsolid b
                """.trimIndent(),
            )
            val png = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg=="
            Files.write(folder.resolve("crate.png"), Base64.getDecoder().decode(png))
            val loaded = parsed(text, "docs/scene-file.md", folder)
            assertEquals(emptyList<String>(), loaded.warnings)
            assertTrue(loaded.scene.bounds != null)
        }
    }

    @Test
    fun theKeysOfTheReaderAreOnThePage() {
        val names = SceneFileNames.run {
            listOf(projections, shadings, alphaModes, sides, filters, wraps, fillRules, conventions, depthTests) +
                listOf(lightRigs)
        }
        for (word in names.flatMap { it.keys }) assertTrue("`\"$word\"`" in page, "\"$word\" is not on the page")
    }
}
