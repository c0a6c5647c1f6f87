package dev.lazyz.cli.render

import dev.lazyz.cli.ChildZcli
import dev.lazyz.cli.statIn
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/**
 * `--memory` holds in JVMs with a heap of that size: each picture is the one without a limit, or refused before it is
 * rendered. `dev.lazyz.jmh.memory.MemoryGrid` tries more.
 */
class MemoryOptionTest {
    @TempDir
    lateinit var folder: Path

    private val model get() = folder.resolve("hills.stl")

    private class Outcome(val code: Int, val errors: String, val text: String)

    /** Renders with a heap of [mebibytes], and with --memory of that size. */
    private fun render(mebibytes: Int, output: String, words: List<String>): Outcome {
        val child = ChildZcli(folder)
        val all = listOf("render") + words + listOf("-o", output, "--memory", "${mebibytes}m", "--stats=json")
        val process = child.start(all, listOf("-Xmx${mebibytes}m"))
        val text = String(process.inputStream.readAllBytes())
        return Outcome(child.code(process), child.errors, text)
    }

    /**
     * Words of the command, and amounts of memory in MiB. With the effort `rest` the middle ones are tested.
     */
    private val pictures = listOf(
        listOf("teapot") to listOf(16, 40),
        listOf("hills.stl") to listOf(32, 128),
        listOf("hills.stl", "--stream", "--aa", "1", "--size", "2000x1500") to listOf(48, 112),
        listOf("city", "--size", "12000x300", "--aa", "1") to listOf(24, 64),
    ).let { if (System.getProperty("lazyz.effort") == "full") it else it.subList(1, 3) }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun eachPictureIsTheSameOrRefused() {
        model.writeBytes(Hills(400).stl())
        var rendered = 0
        var refused = 0
        for ((words, amounts) in pictures) {
            val free = zcli("render", *absolute(words), "-o", folder.resolve("free.ppm"), "--stats=json")
            val expected = statIn(free.text, "pixelHash")
            for (amount in amounts) {
                val output = "out$amount." + listOf("png", "ppm", "dzi")[(rendered + refused) % 3]
                val outcome = render(amount, output, words)
                if (outcome.code == 0) {
                    assertEquals(expected, statIn(outcome.text, "pixelHash"), "$words with $amount MiB")
                    rendered++
                } else {
                    assertEquals(2, outcome.code, outcome.errors)
                    assertTrue(", and --memory allows " in outcome.errors, outcome.errors)
                    assertTrue(!folder.resolve(output).exists(), "no partial file")
                    refused++
                }
            }
        }
        assertTrue(rendered >= pictures.size && refused >= 1, "$rendered rendered, $refused refused")
    }

    private fun absolute(words: List<String>): Array<String> =
        words.map { if (it == "hills.stl") "$model" else it }.toTypedArray()

    /** The amount that a message says to use, MiB. */
    private fun named(errors: String): Int =
        checkNotNull(Regex("Use --memory (\\d+)m").find(errors)) { errors }.groupValues[1].toInt()

    /** A plan has few enough passes over the model to end soon. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun theMemoryThatIsNamedForATranslucentModelIsEnoughToEndSoon() {
        model.writeBytes(Hills(220).stl())
        val words = listOf("hills.stl", "--stream", "--color", "#ff000080", "--size", "500")
        val refused = render(60, "a.png", words)
        assertEquals(2, refused.code, refused.errors)
        val outcome = render(named(refused.errors), "a.png", words)
        assertEquals(0, outcome.code, outcome.errors)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun adviceFitsTheCause() {
        val out = folder.resolve("a.png")
        model.writeBytes(Hills(30).stl())
        val stream = zcli("render", model, "--stream", "--region", "0,0,1x1", "--memory", "48m", "-o", out)
        stream.mistake("parts of the model", "--memory allows 48.0 MiB", "Use --memory ")
        assertTrue("--size" !in stream.errors, stream.errors)

        val small = ChildZcli(folder)
        val process = small.start(listOf("render", "city", "--size", "3000", "--memory", "512m"), listOf("-Xmx16m"))
        assertEquals(2, small.code(process))
        assertTrue("Start Java with -Xmx" in small.errors && "and use --memory" in small.errors, small.errors)

        val hills = folder.resolve("hills.obj").apply { writeText(Hills(200).obj()) }
        val reading = zcli("render", hills, "--memory", "24m", "-o", out)
        reading.mistake("reading ", "Or add --stream; each triangle then has its own normal, and materials")
        val lists = zcli("render", model, "--memory", "12m", "--shading", "flat", "--strategy", "lists", "-o", out)
        assertEquals(2, lists.code)
        assertTrue("--stream" !in lists.errors, lists.errors)
        zcli("render", model, "--max-spool", "1m", "-o", out).mistake("--max-spool needs --stream, or --memory")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aModelIsReadPartByPartWherePicturesAreTheSame() {
        model.writeBytes(Hills(700).stl())
        val out = folder.resolve("a.png")
        val words = listOf("hills.stl", "--shading", "flat", "--aa", "1", "--size", "400")
        val whole = statIn(zcli("render", *absolute(words), "-o", out, "--stats=json").text, "pixelHash")
        val outcome = render(112, "b.png", words + "--explain")
        assertEquals(0, outcome.code, outcome.errors)
        assertTrue("the model stays in its file" in outcome.errors, outcome.errors)
        assertEquals(whole, statIn(outcome.text, "pixelHash"))

        val smooth = zcli("render", model, "--memory", "112m", "-o", folder.resolve("c.png"))
        smooth.mistake("reading", "--memory allows 112.0 MiB", "--stream; each triangle then has its own normal")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun thePlanIsExplained() {
        val result = render(64, "a.png", listOf("teapot", "--explain"))
        assertEquals(0, result.code, result.errors)
        for (part in listOf("memory: 64.0 MiB may be used", "rows of tiles", "output -o", "plan: tiled", "disk: ")) {
            assertTrue(part in result.errors, result.errors)
        }
        val out = folder.resolve("b.png")
        zcli("render", "teapot", "--memory", "1m", "-o", out).mistake("--memory allows 1.0 MiB")
        zcli("render", "teapot", "city", "--memory", "1g").mistake("--memory is for a single picture")
        assertEquals(2, zcli("render", "teapot", "--memory", "much", "-o", out).code)
    }

    @Test
    fun temporaryFilesAreLimited() {
        val text = "solid s\n" + "facet normal 0 0 0\nouter loop\nvertex 0 0 1\nvertex 1 0 0\nvertex 0 1 2\n" +
            "endloop\nendfacet\nendsolid s\n"
        model.writeBytes(text.toByteArray())
        val words = arrayOf("--stream", "--spool", folder, "-o", folder.resolve("a.png"), "--size", "40x30")
        zcli("render", model, *words, "--max-spool", "36").done()
        zcli("render", model, *words, "--max-spool", "35").mistake("more than 35 bytes", "--max-spool", "hills.stl")
    }
}
