package dev.lazyz.scenes

import dev.lazyz.scenes.writers.writePng
import dev.lazyz.strategies.tiled.Tiled
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The README's code from a model to a picture. */
class ReadmePictureTest {
    @TempDir
    lateinit var folder: Path

    private val root = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { Files.exists(it.resolve("CONTRIBUTING.md")) }
    private val block = root.resolve("README.md").readText()
        .substringAfter("## From a model to a picture").substringAfter("```kotlin\n").substringBefore("\n```").lines()

    @Test
    fun theReadmeShowsTheseLines() {
        val (input, output) = root.resolve("docs/images/flange.obj") to folder.resolve("flange.png")
        val model = Scenes.load(input)
        PictureSettings(640, 480).frame(model).render(Tiled()).writePng(output)
        assertTrue(Files.size(output) > 1000)

        val shown = block.filterNot { it.isBlank() || it.startsWith("import ") }
        val written = listOf(
            """val model = Scenes.load(Path.of("teapot.obj"))""",
            """PictureSettings(640, 480).frame(model).render(Tiled()).writePng(Path.of("teapot.png"))""",
        )
        assertEquals(written, shown)
    }

    @Test
    fun itsImportsAreAll() {
        val imports = block.filter { it.startsWith("import ") }.map { it.removePrefix("import ") }
        val names = listOf(
            PictureSettings::class.qualifiedName, Scenes::class.qualifiedName,
            "dev.lazyz.scenes.writers.writePng", Tiled::class.qualifiedName, Path::class.qualifiedName,
        )
        assertEquals(names, imports)
    }
}
