package dev.lazyz.cli.render

import dev.lazyz.cli.ProjectFiles
import dev.lazyz.cli.emptyModel
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureSettings
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `-o` with `.svg`. */
class DrawingTest {
    @TempDir
    lateinit var folder: Path

    private val flange = ProjectFiles.root.resolve("docs/images/flange.obj")
    private val out get() = folder.resolve("out.svg")

    private fun render(vararg args: Any) = zcli("render", *args, "--size", "60x50", "-o", out)

    @Test
    fun linesAreWrittenAsVectors() {
        assertEquals("", render(flange, "--style", "technical", "--quiet").done().text)
        val technical = out.readText()
        assertTrue(technical.startsWith("<svg ") && "class=\"crease\"" in technical && "<image" !in technical)
        render(flange, "--edges", "--quiet").done()
        val shaded = out.readText()
        assertTrue("class=\"crease\"" in shaded && "<image" in shaded)
        for (strategy in listOf("painter", "scanline")) {
            render(flange, "--edges", "--quiet", "--strategy", strategy).done()
            assertEquals(shaded, out.readText(), strategy)
        }
    }

    @Test
    fun drawingsOnPaperAreThoseOfTheLibrary() {
        val paper = listOf("scale" to "2.5:1", "unit" to "in")
        val options = listOf("size" to "60x50", "style" to "technical", "cut" to "z=0") + paper
        val settings = PictureDoor.COMMAND_LINE.read(PictureSettings(), options)
        val expected = ByteArrayOutputStream()
        settings.drawing(Scenes.load(flange)).writeSvg(expected)
        val words = options.flatMap { (name, word) -> listOf("--$name", word) }
        zcli("render", flange, "-o", out, "--quiet", *words.toTypedArray()).done()
        assertEquals(expected.toString(), out.readText())
        assertTrue(Regex("width=\"[0-9.]+mm\"").containsMatchIn(out.readText()))
    }

    @Test
    fun severalInputsAndViewsHaveFiles() {
        val models = Files.createDirectory(folder.resolve("a & <b>"))
        models.wedge("one.obj")
        models.wedge("t&\"w'o.obj")
        val files = "$folder/{stem}_{view}.svg"
        zcli("render", models, "--style", "technical", "--views", "front,top", "--quiet", "-o", files).done()
        val written = Files.list(folder).use { all ->
            all.filter(Files::isRegularFile).map { it.name }.sorted().toList()
        }
        assertEquals(listOf("one_front.svg", "one_top.svg", "t&\"w'o_front.svg", "t&\"w'o_top.svg"), written)
        zcli(
            "render", models.resolve("one.obj"), "--style", "technical", "--view", "top", "--quiet", "-o",
            folder.resolve("alone.svg"),
        ).done()
        assertEquals(folder.resolve("one_top.svg").readText(), folder.resolve("alone.svg").readText())
    }

    @Test
    fun aBlankDrawingIsReported() {
        val empty = folder.emptyModel()
        val run = render(empty, "--style", "technical")
        assertEquals(0, run.code, run.errors)
        assertTrue("warning: nothing is visible" in run.errors, run.errors)
        assertTrue("</svg>" in out.readText())
        assertEquals(1, render(empty, "--style", "technical", "--fail-blank").code)
    }

    @Test
    fun mistakesLeaveNoFile() {
        val model = folder.wedge()
        fun mistake(text: String, vararg args: String) {
            render(model, *args).mistake(text)
            assertFalse(Files.exists(out)) { text }
        }
        mistake("there are no lines to draw: add --edges, --wireframe or --style technical")
        mistake("there are no lines to draw", "--cut", "x=50%")
        mistake("--scale 1:2: under perspective, lengths have no scale", "--edges", "--scale", "1:2")
        mistake("--unit needs --scale", "--edges", "--unit", "mm")
        mistake("'1/2' is not PAPER:MODEL", "--edges", "--scale", "1/2")
        mistake("both numbers must be above 0: 0:1", "--edges", "--scale", "0:1")
        mistake("'mile' is not one of micron, mm", "--edges", "--unit", "mile")
        val pixels = listOf(
            listOf("--depth-out", "$folder/d.pfm"), listOf("--aov", "depth=$folder/d.npy"), listOf("--stats"),
            listOf("--select", "count"), listOf("--explain"), listOf("--stream"), listOf("--memory", "1g"),
            listOf("--turntable", "4"), listOf("--ref", "$model"),
        )
        for (options in pixels) {
            mistake("${options[0]} is for pictures of pixels", "--style", "technical", *options.toTypedArray())
        }
        zcli("render", model, "--style", "technical", "--turntable", "4", "-o", "$folder/{frame}.svg")
            .mistake("--turntable is for pictures of pixels")
        zcli("render", model, "--style", "technical", "--scale", "1:2", "-o", "$folder/a.png")
            .mistake("--scale is for drawings: use -o with .svg")
        zcli("render", model, "--contact-sheet", "--edges", "-o", out).mistake("-o must end in .png")
    }

    @Test
    fun theInputIsNotReplaced() {
        val input = folder.resolve("out.svg").apply { writeText("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n") }
        render(input, "--format", "obj", "--edges").mistake("-o would replace an input")
    }
}
