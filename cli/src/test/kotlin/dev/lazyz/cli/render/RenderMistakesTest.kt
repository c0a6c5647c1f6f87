package dev.lazyz.cli.render

import dev.lazyz.cli.WEDGE
import dev.lazyz.cli.Zrun
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.cli.zcliReading
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assumptions.assumeFalse
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** Every mistake of a user causes one message and exit code 2, and leaves no file. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class RenderMistakesTest {
    @TempDir
    lateinit var folder: Path

    private fun render(vararg options: Any): Zrun = zcli("render", folder.wedge(), *options)

    private fun assertOnlyInput() = assertEquals(listOf("wedge.obj"), folder.listDirectoryEntries().map { it.name })

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "--size|0x0|width and height must be in 1..262144: 0x0",
            "--size|262145x1|1..262144",
            "--size|99999999999999999999x1|1..262144",
            "--size|640x|is not WIDTHxHEIGHT",
            "--region|10,10|'10,10' is not X,Y,WIDTHxHEIGHT, such as 100,50,320x240",
            "--region|-1,0,5x5|column and row must be in 0..262143: -1,0,5x5",
            "--region|0,0,0x5|width and height must be in 1..262144: 0,0,0x5",
            "--region|99999999999,0,5x5|column and row must be",
            "--region|0,0,641x480|--region 0,0,641x480 reaches beyond the whole picture, which is 640x480",
            "--region|262143,262143,262144x262144|reaches beyond the whole picture",
            "--memory-budget|much|'much' is not an amount of memory, such as 65536, 64k or 16MiB",
            "--coherence|adaptiv|did you mean 'adaptive'?",
            "--select|farthst|did you mean 'farthest'?",
            "--select|kth|nearest, farthest, kth:K, count, blend",
            "--select|kth:0|K of kth:K must be a whole number, 1 or more: kth:0",
            "--threads|0|must be at least 1: 0",
            "--tile-size|48|must be a power of two in 8..512: 48",
            "--zoom|0|must be in 0.001..1000: 0",
            "--zoom|NaN|'NaN' is not a number",
            "--zoom|1e999|0.001..1000",
            "--zoom|0x1p3|is not a number",
            "--elevation|90.5|must be in -90..90 degrees: 90.5",
            "--azimuth|Infinity|is not a number",
            "--azimuth|1e7|-1000000..1000000 degrees",
            "--view|frnt|did you mean 'front'?",
            "--projection|ortographic|did you mean 'orthographic'?",
            "--shading|blin-phong|did you mean 'blinn-phong'?",
            "--strategy|zbufer|no strategy 'zbufer'; did you mean 'zbuffer'?",
            "--strategy|quantum|See 'zcli strategies'",
            "--background|redd|'redd' is not a colour",
            "--background|#12345|hexadecimal",
            "--up|w|'w' is not one of x, -x, y, -y, z, -z",
            "--depth-convention|bigger|smaller, larger",
            "--format|objj|did you mean 'obj'?",
            "--stats=xml|--stats=json|'xml' is not one of table, json",
            "--sise|4x4|no such option --sise. Did you mean --size?",
            "--depth-out|depth.png|--depth-out must end in .pfm",
            "--depth-out|-|'-', standard input or output, is not possible here: name a file",
        ],
    )
    fun valuesOutOfRange(option: String, value: String, message: String) {
        render("-o", folder.resolve("x.png"), option, value).mistake(message)
        assertOnlyInput()
    }

    @Test
    fun inputs() {
        val out = arrayOf("-o", folder.resolve("x.png"))
        zcli("render", folder.resolve("none.obj"), *out).mistake("none.obj: no such file")
        zcli("render", "teapot", "--format", "obj", *out)
            .mistake("teapot: no such file; with --format, INPUT is always a file")
        for (option in listOf("--ref", "--texture", "--matcap")) {
            zcli("render", "teapot", option, "-", *out)
                .mistake(option, "'-', standard input or output, is not possible here")
        }
        zcli("render", folder, *out).mistake("has no models or scene files")
        folder.wedge()
        zcli("trace", folder, *out).mistake("is a folder, and this command takes one file")
        zcli("trace", folder.resolve("none").createDirectory(), *out).mistake("has no models or scene files")
        Files.delete(folder.resolve("none"))
        zcli("render", "teapto", *out).mistake("no built-in scene and no file 'teapto'", "did you mean 'teapot'?")
        zcli("render", "", *out).mistake("no built-in scene and no file ''")
        zcli("render", folder.wedge("wedge.xyz"), *out).mistake("'.xyz' of", "--format obj|stl|ply")
        Files.delete(folder.resolve("wedge.xyz"))
        zcli("render", "-", *out).mistake("specify the format of standard input", "--format obj|stl|ply")
        zcliReading(WEDGE, "render", "-", "--format", "obj").mistake("specify the output file: -o")
        zcli("render", "teapot", "city", *out).mistake("two pictures would be written to", "{stem}")
        zcli("render", "nul\u0000.obj", *out).mistake("not a file name")
        render(*out).done()
    }

    @Test
    fun badFilesAreNamed() {
        val bad = folder.resolve("bad.obj").apply { writeText("v 1 2\nf 1 2 3\n") }
        zcli("render", bad, "-o", folder.resolve("x.png")).mistake("bad.obj, line 1")
        zcliReading("nonsense", "render", "-", "--format", "glb", "-o", "-").mistake("standard input")
        assertEquals(listOf("bad.obj"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    fun filesThatMayNotBeRead() {
        val locked = folder.wedge()
        locked.toFile().setReadable(false)
        assumeFalse(Files.isReadable(locked), "the superuser may read everything")
        zcli("render", locked, "-o", folder.resolve("x.png")).mistake("permission denied")
    }

    @Test
    fun outputs() {
        val endings = "-o must end in .png or .ppm or .dzi or .svg, or be - for standard output"
        render("-o", folder.resolve("x.jpg")).mistake(endings)
        render("-o", folder.resolve("png")).mistake("-o must end in .png")
        render("-o", folder.resolve(".png")).mistake("-o must end in .png")
        render("-o", "").mistake("-o must end in .png")
        render("-o", folder.resolve("none/x.png")).mistake("there is no folder", "none")
        render("-o", folder.resolve("wedge.obj/x.png")).mistake("there is no folder", "wedge.obj")
        render("-o", folder.resolve("x.png"), "--depth-out", folder.resolve("none/x.pfm")).mistake("there is no folder")
        assertOnlyInput()
        folder.resolve("folder.png").createDirectory()
        render("-o", folder.resolve("folder.png")).mistake("it is a folder")
    }

    @Test
    fun foldersThatMayNotBeWritten() {
        val locked = folder.resolve("locked").createDirectory()
        locked.toFile().setWritable(false)
        assumeFalse(Files.isWritable(locked), "the superuser may write everywhere")
        render("-o", locked.resolve("x.png")).mistake("no permission to write in")
    }

    @Test
    fun anOldFileStaysWhenTheNewOneFails() {
        val old = folder.resolve("old.png").apply { writeText("old") }
        val bad = folder.resolve("bad.obj").apply { writeText("f 1 2 3\n") }
        zcli("render", bad, "-o", old).mistake("bad.obj")
        render("-o", old, "--size", "262144x262144", "--strategy", "zbuffer").mistake("pixels")
        assertEquals("old", old.readText())
        check(!folder.resolve("x.png").exists())
    }
}
