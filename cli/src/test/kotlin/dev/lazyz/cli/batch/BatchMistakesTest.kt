package dev.lazyz.cli.batch

import dev.lazyz.cli.Zrun
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Mistakes in command lines with several pictures, which are reported before anything is rendered. */
class BatchMistakesTest {
    @TempDir
    lateinit var folder: Path

    private val out by lazy { folder.resolve("out") }

    private fun render(vararg args: Any): Zrun = zcli("render", "--size", "48x40", *args)

    /** Only a single picture can be written to standard output, so messages about several do not offer it. */
    @Test
    fun standardOutputIsOnlyOfferedWhereItIsPossible() {
        val several = listOf(
            render("teapot", "city", "-o", "$out/{stem}.gif"),
            render("teapot", "city", "--contact-sheet", "-o", "$out/sheet.gif"),
            render("teapot", "--turntable", "3", "-o", "$out/a.jpg"),
            zcli("trace", "teapot", "-o", "$out/a.jpg"),
        )
        for (run in several) assertFalse("standard output" in run.mistake("-o must end in .").errors, run.errors)
        render("teapot", "-o", "$out/a.gif")
            .mistake("-o must end in .png or .ppm or .dzi or .svg, or be - for standard output")
    }

    @Test
    fun aViewThatIsNamedTwiceIsAMistake() {
        render("teapot", "--views", "iso,top,ISO", "-o", "$out/{view}.png").mistake("--views", "'ISO' is named twice")
        zcli("compare", "teapot", "--views", "iso,iso").mistake("--views", "'iso' is named twice")
        assertFalse(out.exists())
    }

    /** The value of `--stats` needs `=`: otherwise the word is an input. */
    @Test
    fun theFormOfStatisticsIsNotAnInput() {
        for (form in listOf("json", "table", "JSON")) {
            val hint = "did you mean '--stats=${form.lowercase()}'?"
            val message = "'$form' is taken as INPUT, and there is no such file; $hint"
            render("teapot", "--stats", form, "-o", "$out/a.png").mistake(message)
            render("teapot", "-o", "$out/{stem}.png", "--stats", form).mistake(message)
        }
        assertFalse(out.exists())
    }

    /** A missing input is the more likely mistake. */
    @Test
    fun missingInputsAreReportedBeforeNamesOfFiles() {
        render("teapot", "jsno", "-o", "$out/a.png").mistake("there is no built-in scene and no file 'jsno'")
        render("teapot", "city", "-o", "$out/a.png").mistake("two pictures would be written to $out/a.png")
    }

    @Test
    fun onlyNamesWithPlaceholdersCreateFolders() {
        for (options in listOf(listOf("--turntable", "3"), listOf("--contact-sheet"))) {
            render("teapot", *options.toTypedArray(), "-o", "$out/a.png").mistake("there is no folder $out")
            assertFalse(out.exists())
        }
        render("teapot", "--turntable", "2", "-o", "$out/{stem}.gif").done()
        assertTrue(out.resolve("teapot.gif").exists())
    }

    @Test
    fun inputsWithoutAnExtension() {
        val bare = folder.wedge("bare")
        for (input in listOf(bare, "teapot")) {
            render(input, "-o", "$out/{stem}.{ext}.png").mistake("$input has no {ext}", "{name}")
        }
        render("-", "--format", "obj", "-o", "$out/{stem}.png").mistake("standard input has no {stem}", "{index}")
        assertFalse(out.exists())
    }

    @Test
    fun foldersThatCannotBeCreated() {
        render("teapot", "-o", "$out/{stem}/../q.png").mistake("$out/teapot/../q.png", "there is no folder $out/teapot")
        val system = Path.of("/proc/none")
        assumeTrue(system.parent.exists())
        val run = render("teapot", "-o", "$system/{stem}.png")
        assertEquals(ExitCode.MISTAKE, run.code)
        assertTrue("cannot write $system/teapot.png: " in run.errors, run.errors)
    }

    @Test
    fun anEmptyFolderHasNoInputs() {
        val empty = folder.resolve("empty").createDirectory()
        empty.resolve("notes.txt").writeText("not a model")
        val run = render(empty, "teapot", "-o", "$out/{stem}.png")
        assertEquals(ExitCode.MISTAKE, run.code)
        val message = "zcli: error: $empty has no models or scene files, whose names end in .obj, .stl"
        assertTrue(run.errors.startsWith(message), run.errors)
        val one = render(empty, "--format", "stl", "-o", "$out/{stem}.png")
        assertTrue("whose names end in .stl\n" in one.errors, one.errors)
    }

    @Test
    fun aFailureWithAnyNameIsALineOfJson() {
        val broken = folder.resolve("a\uD83D\uDE00.obj").apply { writeText("f 1 2 3\n") }
        val run = render(broken, folder.wedge("b.obj"), "--stats=json", "-o", "$out/{stem}.png")
        assertEquals(ExitCode.MISTAKE, run.code, run.errors)
        assertTrue("a\\ud83d\\ude00.obj" in run.text, run.text)
        assertTrue(out.resolve("b.png").exists(), run.errors)
    }

    @Test
    fun noPictureReplacesAnInput() {
        val model = folder.wedge("a.png")
        val texture = folder.resolve("b.png").apply { writeText("texture") }
        val names = "$folder/{stem}.png"
        render(model, "teapot", "--format", "obj", "-o", names).mistake("-o would replace an input: $model")
        for (option in listOf("--texture", "--matcap")) {
            val message = "-o would replace the input of $option: $texture"
            render("teapot", "b", option, texture, "-o", names).mistake(message)
        }
        render("teapot", "--contact-sheet", "--texture", texture, "-o", texture).mistake("input of --texture")
        assertEquals("texture", texture.readText())
    }

    /** What a model refers to is known when it has been read. */
    @Test
    fun noPictureReplacesATextureOfAModel() {
        val texture = folder.resolve("b.png").apply { writeText("texture") }
        folder.resolve("b.mtl").writeText("newmtl m\nmap_Kd b.png\n")
        folder.resolve("b.obj").writeText("mtllib b.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        val run = render("teapot", folder.resolve("b.obj"), "-o", "$folder/{stem}.png")
        assertEquals(ExitCode.MISTAKE, run.code)
        assertTrue("-o would replace a file that $folder/b.obj refers to: $texture" in run.errors, run.errors)
        assertTrue("1 of 2 inputs failed" in run.errors, run.errors)
        assertEquals("texture", texture.readText())
        assertTrue(folder.resolve("teapot.png").exists())
    }
}
