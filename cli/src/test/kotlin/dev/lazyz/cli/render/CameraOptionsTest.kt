package dev.lazyz.cli.render

import dev.lazyz.cli.Zrun
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.statIn
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource

/** The options of the group Camera, with real inputs. */
class CameraOptionsTest {
    @TempDir
    lateinit var folder: Path

    /** A triangle with two cameras, one without a far plane. */
    private val cameras: Path by lazy {
        folder.resolve("cameras.gltf").apply {
            val points = "AAAAAAAAAAAAAAAAAACAPwAAAACamZm+AAAAAAAAAEAzMzM/"
            writeText(
                """{"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0,1,2]}],
                "nodes":[{"mesh":0},{"camera":0,"translation":[0.2,0.3,4]},
                {"camera":1,"translation":[0,0,5],"name":"far away"}],
                "cameras":[{"name":"close","type":"perspective","perspective":{"yfov":0.3,"znear":0.5}},
                {"type":"orthographic","orthographic":{"xmag":3,"ymag":2,"znear":0,"zfar":9}}],
                "meshes":[{"primitives":[{"attributes":{"POSITION":0},"material":0}]}],
                "materials":[{"doubleSided":true}],
                "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
                "bufferViews":[{"buffer":0,"byteLength":36}],
                "buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,$points"}]}""",
            )
        }
    }

    private fun render(input: Any, vararg words: String): Zrun =
        zcli("render", input, "--size", "60x45", "--stats=json", "-o", folder.resolve("out.png"), *words)

    private fun hash(input: Any, vararg words: String): String = render(input, *words).done().stat("pixelHash")

    @Test
    fun aModelWithoutCamerasIsShownAsAWholeWithAWarning() {
        val run = render(folder.wedge(), "--camera", "scene")
        assertTrue("zcli: warning: --camera scene: $folder/wedge.obj has no camera" in run.errors, run.errors)
        assertEquals(hash(folder.wedge()), run.stat("pixelHash"))
        assertEquals("", render(folder.wedge(), "--camera", "fit").errors)
        for (input in listOf(cameras, "teapot")) assertEquals("", render(input, "--camera", "scene").errors)
    }

    @Test
    fun theCameraOfEachViewIsPrintedWithItsName() {
        val names = listOf("iso", "top")
        val words = arrayOf<Any>("--views", names.joinToString(","), "--print-camera", "--size", "8")
        val render = zcli("render", folder.wedge(), "plane", "-o", folder.resolve("{stem}_{view}.png"), *words)
        val all = listOf("wedge", "plane").flatMap { input -> names.map { "$input $it" } }
        assertEquals(all, render.errors.trim().lines().map { it.substringBefore(": --projection=") })
        val compare = zcli("compare", folder.wedge(), *words, "--strategy", "zbuffer")
        assertEquals(names, compare.errors.trim().lines().map { it.substringBefore(": --projection=") })
        val single = render(folder.wedge(), "--print-camera").errors
        assertTrue(single.startsWith("--projection="), single)
    }

    @ParameterizedTest
    @ValueSource(
        strings = [
            "", "--view left --elevation 15 --margin 20",
            "--azimuth 33.3 --elevation -71.9 --zoom 1.7", "--fov 75 --aa 2",
            "--projection orthographic --view iso", "--eye 4,3,2.5 --fov 50", "--target 0.1,0.7,0.2 --zoom 3",
            "--eye 4,3,2.5 --target 1,1,0 --camera-up 1,0.3,0 --near 1 --far 20", "--view top --up z",
            "--projection orthographic --height 3 --target 1,0,0", "--azimuth 200 --up=-x", "--up y --eye=-3,-2,1",
            "--up=-y --view right", "--up x --projection orthographic", "--up=-z --margin 0 --zoom 2",
        ],
    )
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun printedOptionsGiveTheSamePictureAgain(options: String) {
        val words = options.split(" ").filter { it.isNotEmpty() }
        val others = listOf("--up", "--aa").flatMap { name ->
            val i = words.indexOfFirst { it == name || it.startsWith("$name=") }
            if (i < 0) emptyList() else words.subList(i, if ('=' in words[i]) i + 1 else i + 2)
        }
        for (input in listOf(folder.wedge(), cameras, "plane", "cycle", "teapot")) {
            val projected = "--fov" in words || "--height" in words
            if (input == "cycle" && projected && "--projection" !in words) continue
            assertReproduced(input, words, others)
        }
    }

    private fun assertReproduced(input: Any, words: List<String>, others: List<String>) {
        val depths = listOf("first.pfm", "again.pfm").map { folder.resolve(it) }
        val first = render(input, "--print-camera", "--depth-out", "${depths[0]}", *words.toTypedArray())
        assertEquals(ExitCode.DONE, first.code, first.errors)
        assertTrue(first.stat("visible").toInt() > 0, "$input: $words")
        val printed = first.errors.trim().split(" ")
        val same = others + printed + listOf("--depth-out", "${depths[1]}")
        val again = render(input, "--print-camera", *same.toTypedArray())
        assertEquals(first.errors, again.errors, "$input: $words")
        assertEquals(statIn(first.text, "pixelHash"), statIn(again.text, "pixelHash"), "$input: $words, $printed")
        assertEquals(-1, Files.mismatch(depths[0], depths[1]), "depths of $input: $words, $printed")
    }

    @Test
    fun printedOptionsOfTheScenesOwnCamerasGiveTheSamePictureAgain() {
        for (choice in listOf("fit", "scene", "0", "1")) {
            for (up in listOf("y", "z", "-x")) {
                assertReproduced(cameras, listOf("--camera", choice, "--up=$up"), listOf("--up=$up"))
            }
        }
    }

    /** A fitted camera cannot come near enough to fill the picture, a camera at a given place need not. */
    @Test
    fun fittedCamerasHaveALimitOfTheFieldOfView() {
        for (angle in listOf("140.5", "179.9")) {
            zcli("render", folder.wedge(), "-o", folder.resolve("wide.png"), "--fov", angle)
                .mistake("--fov must be at most 140", "--eye")
            val eye = arrayOf("--eye", "0.3,0.2,1.5", "--fov", angle, "--print-camera")
            assertTrue("--fov=$angle " in render(folder.wedge(), *eye).errors)
            assertTrue("--fov=$angle " in render(folder.wedge(), *eye, "--zoom", "1").errors)
            assertTrue("--fov=$angle " !in render(folder.wedge(), *eye, "--zoom", "2").errors)
            assertTrue("--fov=$angle " in render("plane", "--fov", angle, "--print-camera").errors)
        }
        render(folder.wedge(), "--fov", "140").done()
    }

    @ParameterizedTest
    @CsvSource(
        delimiter = '|',
        value = [
            "--camera 7|--camera 7: the input has 2: 0 (close), 1 (far away)",
            "--camera nearest|--camera nearest: the input has 2: 0 (close), 1 (far away)",
            "--camera 0 --azimuth 5|--camera with the scene's own camera cannot be combined with --azimuth",
            "--camera scene --margin 5|cannot be combined with --margin",
            "--eye 1,2,3 --view top|--eye cannot be combined with --view",
            "--eye 1,2,3 --margin 3|--eye cannot be combined with --margin",
            "--eye 1,2|'1,2' is not X,Y,Z, such as 1,-2.5,0",
            "--target 1,2,1e999|numbers must be finite",
            "--eye 1,2,3 --target 1,2,3|there is no such camera",
            "--camera-up 0,0,0|there is no such camera: up must be finite and not zero",
            "--margin 46|must be in 0..45 percent: 46",
            "--fov 0|must be between 0 and 180 degrees: 0",
            "--height 0|must be positive",
            "--height 3|--height is for an orthographic camera; use --fov",
            "--fov 30 --projection orthographic|--fov is for a perspective camera; use --height",
            "--near 1e999|must be finite",
            "--near 5 --far 2|there is no such camera: near must be less than far",
            "--near -1|there is no such camera: near must be positive under perspective",
        ],
    )
    fun wrongValuesAreReported(options: String, message: String) {
        render(cameras, *options.split(" ").toTypedArray()).mistake(message)
    }

    @Test
    fun modelsWithoutCamerasHaveNoNumbers() {
        render(folder.wedge(), "--camera", "0").mistake("--camera 0: the input has no cameras with a number or a name")
    }
}
