package dev.lazyz.cli.batch

import dev.lazyz.cli.Zrun
import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.statIn
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.scenefile.SceneFile
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.createDirectories
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class BatchTest {
    @TempDir
    lateinit var folder: Path

    private val models by lazy {
        folder.resolve("models").createDirectory().also {
            it.wedge("a.obj")
            it.resolve("bad.obj").writeText("v 0 0\nf 1 2 3\n")
            val faces = "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n"
            it.resolve("b.off").writeText("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n$faces")
            it.resolve("notes.txt").writeText("not a model")
        }
    }

    private val out by lazy { folder.resolve("out") }

    private fun render(vararg args: Any): Zrun = zcli("render", "--size", "48x40", *args)

    private fun names() = out.listDirectoryEntries().map { it.name }.sorted()

    @Test
    fun aBadFileAmongGoodOnesIsReportedAndTheOthersAreRendered() {
        val run = render(
            models, "teapot", "--views", "iso,top", "-o", "$out/{index}-{stem}_{view}.png", "--stats=json",
        )
        assertEquals(ExitCode.MISTAKE, run.code)
        val good = listOf("1-a", "2-b", "4-teapot").flatMap { listOf("${it}_iso.png", "${it}_top.png") }
        assertEquals(good, names())
        val expected = Regex("zcli: error: .*bad\\.obj, line 1: .*\nzcli: error: 1 of 4 inputs failed\n")
        assertTrue(expected.matches(run.errors)) { run.errors }

        // One line for each picture, in the order of the inputs; one for the bad file
        val lines = run.text.trim().lines()
        assertEquals(
            listOf("a.obj", "a.obj", "b.off", "b.off", "bad.obj", "teapot", "teapot"),
            lines.map { statIn(it, "input").substringAfterLast('/') },
        )
        assertEquals(listOf("iso", "top"), lines.take(2).map { statIn(it, "view") })
        assertEquals("$out/1-a_iso.png", statIn(lines[0], "output"))
        assertTrue("line 1" in statIn(lines[4], "message"))
        assertFalse("pixelHash" in lines[4])
    }

    /** Each picture, alone, has the same bytes. */
    @Test
    fun picturesAreThoseOfSingleRuns() {
        render(models.resolve("a.obj"), "city", "--views", "iso,front", "-o", "$out/{stem}-{view}.png").done()
        for (input in listOf(models.resolve("a.obj"), "city")) {
            for (view in listOf("iso", "front")) {
                val stem = "$input".substringAfterLast('/').removeSuffix(".obj")
                val alone = folder.resolve("alone.png")
                render(input, "--view", view, "-o", alone).done()
                assertArrayEquals(alone.readBytes(), out.resolve("$stem-$view.png").readBytes(), "$input $view")
            }
        }
        render("city", "-o", folder.resolve("alone.png")).done()
        render("city", "-o", "$out/{stem}_{view}.png").done()
        assertArrayEquals(folder.resolve("alone.png").readBytes(), out.resolve("city_default.png").readBytes())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun filesDoNotDependOnThreads() {
        val jobs = listOf(
            listOf("-o", "{t}/{stem}-{view}.png", "--views", "iso,right"),
            listOf("-o", "{t}/{stem}.gif", "--turntable", "3"),
            listOf("-o", "{t}/{stem}.apng", "--turntable", "3"),
            listOf("-o", "{t}/sheet.png", "--contact-sheet"),
        )
        val inputs = arrayOf(models.resolve("a.obj"), "teapot", "cycle")
        for (job in jobs) {
            val files = listOf(1, 2, 5).map { threads ->
                val target = folder.resolve("$threads")
                val args = job.map { it.replace("{t}", "$target") }
                val names = render(*inputs, *args.toTypedArray(), "--threads", threads, "--stats=json").text.lines()
                val hashes = names.filter { it.isNotEmpty() }.map { statIn(it, "pixelHash") }
                hashes to target.listDirectoryEntries().sorted().map { it.name to it.readBytes().toList() }
            }
            assertEquals(files[0], files[1], "$job")
            assertEquals(files[0], files[2], "$job")
        }
    }

    @Test
    fun usualNamesAreThoseOfTheInputs() {
        val run = render("teapot", "cycle", "--views", "front", "-o", "$out/{name}.png")
        run.done()
        assertEquals(listOf("cycle.png", "teapot.png"), names())
        render(models.resolve("a.obj"), models.resolve("b.off"), "-o", "$out/{name}-{ext}-{index}{{.png").done()
        assertTrue(out.resolve("a.obj-obj-1{.png").exists() && out.resolve("b.off-off-2{.png").exists())
    }

    @Test
    fun aNameWithoutPlaceholdersIsThatOfOnePicture() {
        render("teapot", "-o", "$folder/{{a}.png", "--depth-out", folder.resolve("a.pfm")).done()
        render("teapot", "-o", "$folder/{{{stem}}}{{c}}}}.png").done()
        assertTrue(folder.resolve("{teapot}{c}}.png").exists())
        assertTrue(folder.resolve("{a}.png").exists())
        render("teapot", "--contact-sheet", "-o", "$folder/{{b}.png").done()
        assertTrue(folder.resolve("{b}.png").exists())
        val missing = folder.resolve("{c}.png")
        render("teapot", "--ref", missing).mistake("-o '$folder/{{c}.png'")
    }

    @Test
    fun aLineOfAMessageNamesOneInput() {
        val bad = folder.wedge("c\nd.obj").apply { writeText("v 1") }
        val run = render("a\nb.obj", bad, "-o", "$out/{stem}.png")
        val named = listOf("a?b.obj: no such file", "$folder/c?d.obj, line 1")
        for ((line, words) in run.errors.lines().zip(named)) assertTrue(line.startsWith("zcli: error: $words"), line)
        assertEquals(4, run.errors.lines().size, run.errors)
        val blank = folder.wedge("e\nf.obj")
        val empty = render(blank, "teapot", "--eye", "0,0,9", "--target", "0,0,90", "-o", "$out/{stem}.png")
        assertTrue(empty.errors.startsWith("zcli: warning: e?f: nothing is visible")) { empty.errors }
    }

    @Test
    fun picturesAreWrittenIntoTheFoldersOfTheirInputs() {
        val inputs = listOf("x", "y").map { folder.resolve("tree/$it").createDirectories().wedge("a.obj") }
        render(folder.resolve("tree"), "-o", "{dir}/{stem}.png").done()
        for (input in inputs) assertTrue(input.resolveSibling("a.png").exists())
        render(folder.resolve("tree"), "-o", "$out/{dir}/{stem}.png").done()
        assertTrue(Path.of("$out/${inputs[1].parent}/a.png").exists())
        render("teapot", "-o", "$out/{dir}/{stem}.png").done()
        assertTrue(out.resolve("teapot.png").exists())
        render(*inputs.toTypedArray(), "-o", "$out/{stem}.png").mistake("two pictures", "add {dir} to -o")
    }

    @Test
    fun twoPicturesOfOneNameAreAMistakeBeforeAnythingIsRendered() {
        render("teapot", "city", "-o", "$out/x.png").mistake("x.png", "teapot", "city", "{stem}")
        render("teapot", "city", "-o", "$out/").mistake("use -o '$out/{stem}.png'")
        render("teapot", "--views", "iso,top", "-o", "$out/{stem}.png").mistake("teapot, iso", "teapot, top", "{view}")
        render("teapot", folder.wedge("teapot.obj"), "-o", "$out/{stem}.png").mistake("{dir}")
        render("teapot", "teapot", "-o", "$out/{stem}.png").mistake("{index}")
        assertFalse(out.exists())
    }

    @Test
    fun wordsThatAreNoInputsButLookLikeOtherThingsAreExplained() {
        render("800", "-o", "$out.png").mistake("a size is one word, such as --size 800x600")
        render("a.png", "-o", "$out.png").mistake("write -o a.png")
    }

    @Test
    fun mistakesInTemplates() {
        render("teapot", "-o", "$out/{stam}.png").mistake("unknown placeholder {stam}", "did you mean 'stem'")
        render("teapot", "-o", "$out/{stem.png").mistake("a brace is not closed")
        render("teapot", "-o", "$out/{ext}.png").mistake("{ext}", "{name}")
        render("teapot", "-o", "$out/{frame}.png").mistake("{frame}", "--turntable")
        render("teapot", "city", "-o", "$out/{stem}.gif").mistake(".png or .ppm")
        render("teapot", "city", "-o", "-").mistake("standard output")
        val file = folder.wedge()
        render("teapot", "city", "-o", "$file/{stem}.png").mistake("is not a folder")
    }

    @Test
    fun optionsThatMakeNoSenseTogether() {
        render("teapot", "city", "--depth-out", "x.pfm").mistake("--depth-out is for a single picture")
        render("teapot", "city", "--ref", "x.png").mistake("--ref is for a single picture")
        render("teapot", "city", "--aov", "depth=x.png").mistake("--aov is for a single picture")
        render("teapot", "city", "--aov-picture", "depth=x.png").mistake("--aov-picture is for a single picture")
        render("teapot", "city", "--explain").mistake("--explain is for a single picture")
        render("teapot", "--views", "iso,top", "--view", "left").mistake("--views cannot be combined with --view")
        render("teapot", "--turntable", "3", "--eye", "1,2,3").mistake("--turntable cannot be combined with --eye")
        render("teapot", "--turntable", "3", "--camera", "scene").mistake("--turntable", "--camera")
        render("teapot", "--columns", "3").mistake("--columns needs --contact-sheet")
        render("teapot", "--frames-per-second", "3").mistake("--frames-per-second needs --turntable")
        render("teapot", "--turntable", "3", "-o", "$out/{frame}.png", "--frames-per-second", "9")
            .mistake("--frames-per-second is for one file")
        render("teapot", "--contact-sheet", "-o", "$out/{stem}.png").mistake("no placeholders")
        render("teapot", "--contact-sheet", "-o", "$out/a.ppm").mistake("-o must end in .png")
        render("teapot", "--turntable", "1").mistake("2..3600")
        render("-", "teapot", "--format", "obj").mistake("standard input")
        val flat = folder.resolve("flat.json")
        SceneFile.write(Scene(emptyList(), viewpoint = Camera.screen()), flat)
        render(flat, "--turntable", "3", "-o", "$folder/a.png").mistake("--turntable", "screen")
        assertFalse(out.exists() || folder.resolve("a.png").exists())
    }

    /** A texture that needs more memory than files of this size usually do. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun anInputThatNeedsMoreMemoryThanUsualIsReadAgain() {
        ImageIO.write(BufferedImage(1100, 1100, BufferedImage.TYPE_INT_RGB), "png", folder.resolve("t.png").toFile())
        folder.resolve("t.mtl").writeText("newmtl m\nmap_Kd t.png\n")
        val model = folder.resolve("m.obj")
        model.writeText("mtllib t.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
        render(model, "teapot", "-o", "$out/{stem}.png").done()
        render(model, "-o", folder.resolve("alone.png")).done()
        assertEquals(folder.resolve("alone.png").image.argb(), out.resolve("m.png").image.argb())
        render(model, "teapot", "-o", "$out/{stem}.png", "--max-texels", "100").let {
            assertTrue("--max-texels" in it.errors) { it.errors }
        }
    }
}
