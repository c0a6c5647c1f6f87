package dev.lazyz.cli.render

import dev.lazyz.cli.ChildZcli
import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.zcli
import dev.lazyz.cli.zcliReading
import java.io.File
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** `--stream` shows models that are larger than memory. */
class StreamTest {
    @TempDir
    lateinit var folder: Path

    private val model get() = folder.resolve("hills.stl")
    private val out get() = folder.resolve("out.png")

    private fun pixels(vararg options: Any): List<Int> {
        zcli("render", model, "-o", out, "--size", "80x60", *options).done()
        return out.image.argb()
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun thePictureIsThatOfTheWholeModel() {
        model.writeBytes(Hills(70).stl())
        for (options in listOf(
            listOf("--shading", "flat"), listOf("--shading", "flat", "--color", "steelblue", "--view", "top"),
            listOf("--shading", "constant", "--aa", "2", "--region", "20,11,33x40", "--background", "grey"),
            listOf("--shading", "flat", "--up", "-x", "--background", "red,blue", "--aa-filter", "mitchell"),
        )) {
            val whole = pixels(*options.toTypedArray())
            for (strategy in listOf("tiled", "zbuffer", "hybrid", "hierarchical")) {
                assertEquals(whole, pixels("--stream", "--strategy", strategy, *options.toTypedArray()), "$options")
            }
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun standardInputIsCopied() {
        val text = "solid s\n" + List(9) { number ->
            "facet normal 0 0 0\nouter loop\nvertex 0 0 $number\nvertex 1 $number 0\nvertex $number 1 2\nendloop\nendfacet\n"
        }.joinToString("") + "endsolid s\n"
        model.writeText(text)
        val whole = pixels("--shading", "flat")
        val piped = zcliReading(
            text, "render", "-", "--format", "stl", "--stream", "--spool", folder, "-o", out, "--size", "80x60",
            "--shading", "flat",
        )
        piped.done()
        assertEquals(whole, out.image.argb())
        assertEquals(setOf("hills.stl", "out.png"), folder.listDirectoryEntries().map { it.name }.toSet())
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun whatNeedsTheWholeModelIsRefused() {
        model.writeBytes(Hills(3).stl())
        for ((words, problem) in listOf(
            "--edges" to "--edges needs the whole model", "--wireframe" to "--wireframe",
            "--style technical" to "--style technical", "--style product" to "--style product",
            "--cut z=50%" to "--cut", "--ambient-occlusion" to "--ambient-occlusion",
            "--ground-shadow" to "--ground-shadow",
            "--aov depth=a.pfm" to "--aov",
            "--strategy lazy" to "with --stream use one of tiled, zbuffer, hybrid, hierarchical",
            "--select count" to "--select", "--color #ff000080 --strategy zbuffer" to "with --stream only tiled blends",
            "--coherence incremental --strategy scanline" to "'scanline' needs",
            "--turntable 4" to "--stream is for a single picture", "--views iso,top" to "--stream",
            "--spool nowhere" to "nowhere is not a folder",
        )) {
            val result = zcli("render", model, "-o", out, "--stream", *words.split(' ').toTypedArray())
            result.mistake(problem)
            assertTrue(!out.exists(), words)
        }
        zcli("render", "teapot", "--stream", "-o", out).mistake("teapot is a built-in scene")
        zcli("render", model, "--spool", folder, "-o", out).mistake("--spool needs --stream, or --memory")
        zcli("render", model, model, "--spool", folder).mistake("--spool needs --stream, or --memory")
        zcli("render", "-", "--stream", "-o", out).mistake("specify the format of standard input")
        folder.resolve("a.off").writeText("OFF\n0 0 0\n")
        zcli("render", folder.resolve("a.off"), "--stream", "-o", out).mistake("only STL, PLY and OBJ can", "a.off")
        folder.resolve("a.obj").writeText("v 0 0 0\nf 1 2 1\n")
        zcli("render", folder.resolve("a.obj"), "--stream", "-o", out).mistake("line 2", "number 2 of 1 vertices")
        assertTrue(!out.exists())
    }

    @Test
    fun itIsExplained() {
        model.writeBytes(Hills(3).stl())
        val result = zcli("render", model, "-o", out, "--stream", "--explain")
        assertEquals(0, result.code)
        assertTrue("18 primitives are read part by part\nchosen: tiled, because" in result.errors, result.errors)
    }

    /** Without --stream the model is refused. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aModelLargerThanTheHeapIsShown() {
        model.writeBytes(Hills(900).stl())
        val options = listOf("--shading", "flat", "--aa", "1", "--size", "80x60")
        val whole = pixels(*options.toTypedArray())
        assertEquals(2, run("-Xmx64m", "render", "hills.stl", "-o", "small.png", *options.toTypedArray()))
        val advice = "add --stream, which reads it in parts (each triangle then has its own normal); or raise -Xmx"
        assertTrue(advice in folder.resolve("errors.txt").readText(), folder.resolve("errors.txt").readText())
        for (other in listOf("--edges", "--strategy=lazy", "--max-decoded=1g")) {
            assertEquals(2, run("-Xmx64m", "render", "hills.stl", "-o", "small.png", other))
            assertTrue("--stream" !in folder.resolve("errors.txt").readText(), other)
        }
        val code = run("-Xmx64m", "render", "hills.stl", "--stream", "-o", "small.png", *options.toTypedArray())
        assertEquals(0, code, folder.resolve("errors.txt").readText())
        assertEquals(whole, folder.resolve("small.png").image.argb())
    }

    /** The same for files of shared vertices, which are also sent to standard input. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun objAndPlyFilesLargerThanTheHeapAreShown() {
        val options = arrayOf("--shading", "flat", "--aa", "1", "--size", "80x60", "-o", "small.png")
        for (name in listOf("hills.obj", "hills.ply")) {
            val file = folder.resolve(name)
            file.writeText(if (name == "hills.ply") Hills(500).ply() else Hills(500).obj())
            zcli("render", file, "-o", out, *options.sliceArray(0..5)).done()
            val whole = out.image.argb()
            assertEquals(2, run("-Xmx64m", "render", name, *options), name)
            val errors = folder.resolve("errors.txt").readText()
            assertTrue("add --stream, which" in errors, errors)
            assertEquals(0, run("-Xmx64m", "render", name, "--stream", *options), name)
            assertEquals(whole, folder.resolve("small.png").image.argb(), name)
            val format = name.takeLast(3)
            val code = run("-Xmx64m", "render", "-", "--format", format, "--stream", *options, input = file.toFile())
            assertEquals(0, code, folder.resolve("errors.txt").readText())
            assertEquals(whole, folder.resolve("small.png").image.argb(), name)
        }
    }

    private fun run(javaOption: String, vararg args: String, input: File? = null): Int {
        val child = ChildZcli(folder)
        return child.code(child.start(args.asList(), listOf(javaOption)) { if (input != null) redirectInput(input) })
    }
}
