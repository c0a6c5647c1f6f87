package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource
import org.junit.jupiter.params.provider.ValueSource

/** Lights, shadows, lit spheres, and the style for products. */
class LightOptionsTest {
    @TempDir
    lateinit var folder: Path

    /** A cube of one colour, linear 0.21, that floats above a small one. */
    private val cubes: Path by lazy { model("cubes", "Kd 0.5 0.5 0.5") }

    private fun model(name: String, colour: String): Path {
        folder.resolve("$name.mtl").writeText("newmtl m\n$colour\n")
        val corners = (0 until 8).map { Triple(it and 1, it shr 1 and 1, it shr 2) }
        val text = StringBuilder("mtllib $name.mtl\nusemtl m\n")
        for ((x, y, z) in corners) text.append("v $x ${y + 1} $z\n")
        for ((x, y, z) in corners) text.append("v ${0.45 + 0.1 * x} ${0.1 * y} ${0.45 + 0.1 * z}\n")
        for (first in listOf(1, 9)) {
            for (face in listOf("0 2 3 1", "4 5 7 6", "0 1 5 4", "2 6 7 3", "0 4 6 2", "1 3 7 5")) {
                text.append("f ${face.split(' ').joinToString(" ") { "${it.toInt() + first}" }}\n")
            }
        }
        return folder.resolve("$name.obj").apply { writeText(text.toString()) }
    }

    private fun picture(input: Any, vararg words: String): BufferedImage {
        val out = folder.resolve("out.png")
        zcli("render", input, "--size", "40x30", "--aa", "2", "-o", out, *words).done()
        return out.image
    }

    private fun argb(input: Any, vararg words: String): List<Int> = picture(input, *words).argb()

    /** The pixels of a picture that zcli warns of, because all have one colour. */
    private fun blank(input: Any, vararg words: String): List<Int> {
        val out = folder.resolve("out.png")
        val run = zcli("render", input, "--size", "40x30", "-o", out, *words)
        assertTrue("warning: all pixels have the same colour" in run.errors, run.errors)
        return out.image.argb()
    }

    private fun brightness(pixels: List<Int>): Double = pixels.map { it ushr 8 and 0xFF }.average()

    @Test
    fun presetsReplaceLightsOfTheScene() {
        val scene = folder.resolve("scene.json")
        scene.writeText(
            """{"lazyz": 1, "lights": [{"ambient": {"color": [0, 0.1, 0]}}], "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]}""",
        )
        val own = argb(scene)
        assertTrue(own.any { it ushr 16 and 0xFF == 0 && it and 0xFF == 0 })
        assertTrue(blank(scene, "--light", "flat").all { it == -1 })
        assertTrue(brightness(argb(scene, "--light-intensity", "4")) > brightness(own))
    }

    /** Models with dark materials get more light; a colour that the user chose, and scene files, do not. */
    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun darkModelsAreLegible() {
        val dark = model("dark", "Kd 0.02 0.02 0.02")
        val fixed = brightness(argb(dark, "--background", "black", "--light-intensity", "1"))
        assertTrue(brightness(argb(dark, "--background", "black")) > 1.5 * fixed)
        assertEquals(argb(dark, "--light-intensity", "3"), argb(dark))
        assertEquals(argb(cubes), argb(cubes, "--light-intensity", "1"))
        val color = arrayOf("--color", "282828")
        assertEquals(argb(cubes, *color, "--light-intensity", "1"), argb(cubes, *color))
        val scene = folder.resolve("dark.json")
        scene.writeText(
            """{"lazyz": 1, "surfaces": [{"mesh": {"positions": [0, 0, 0, 1, 0, 0, 0, 1, 0], "triangles": [0, 1, 2]},
                "material": {"baseColor": [0.01, 0.01, 0.01]}}]}""",
        )
        assertEquals(argb(scene, "--light-intensity", "1"), argb(scene))
    }

    /** Occlusion makes materials physically based, which have another tone curve, whatever other options are given. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun exposureZeroChangesNothing() {
        val scene = folder.resolve("ball.json")
        scene.writeText("""{"lazyz": 1, "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]}""")
        val occluded = argb(scene, "--ambient-occlusion")
        assertEquals(occluded, argb(scene, "--ambient-occlusion", "--exposure", "0"))
        assertEquals(occluded, argb(scene, "--ambient-occlusion", "--tone-map", "neutral"))
    }

    @Test
    fun aLitSphereReplacesColours() {
        val image = BufferedImage(32, 32, BufferedImage.TYPE_INT_RGB)
        for (x in 0 until 32) for (y in 0 until 32) image.setRGB(x, y, if (y < 16) 0xFF0000 else 0x0000FF)
        val file = folder.resolve("sphere.png").also { ImageIO.write(image, "png", it.toFile()) }
        val front = argb(cubes, "--matcap", "$file", "--elevation", "45", "--aa", "1").toSet()
        assertTrue(0xFFFF0000.toInt() in front && 0xFF0000FF.toInt() in front)
        val tinted = argb(cubes, "--matcap", "$file", "--elevation", "45", "--aa", "1", "--color", "00f").toSet()
        assertTrue(0xFF000000.toInt() in tinted && 0xFF0000FF.toInt() in tinted)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun productIsOcclusionShadowAndMargin() {
        val product = argb(cubes, "--style", "product")
        assertEquals(product, argb(cubes, "--ambient-occlusion", "--ground-shadow", "--margin", "12"))
        assertNotEquals(product, argb(cubes, "--style", "product", "--margin", "2"))
    }

    /** What is computed at pixels for speed is computed at samples if that is asked for. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun occlusionIsShadedOnceAPixel() {
        val calls = listOf(arrayOf("--shading-rate", "sample"), emptyArray()).map { words ->
            val out = folder.resolve("out.png")
            zcli("render", cubes, "--size", "40x30", "-o", out, "--stats=json", "--ambient-occlusion", *words)
                .done().stat("shadingCalls").toInt()
        }
        assertTrue(calls[1] * 10 < calls[0]) { "$calls" }
    }

    /** Planes that the user chose cut the model, and the ground does not change that. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun thePlanesOfTheUserStay() {
        val planes = arrayOf("--eye", "0.5,1,9", "--near", "8.4", "--far", "20", "--aa", "1")
        val cut = argb(cubes, *planes)
        val shadowed = argb(cubes, *planes, "--ground-shadow")
        for (i in cut.indices) if (cut[i] != -1 && shadowed[i] ushr 24 == 0xFF) assertEquals(cut[i], shadowed[i])
    }

    /** A floor of the model is not hidden by the ground. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aFloorAtTheLowestPointIsVisible() {
        val floor = folder.resolve("floor.obj")
        floor.writeText("v -1 0 -1\nv 1 0 -1\nv 1 0 1\nv -1 0 1\nf 4 3 2 1\n")
        for (azimuth in listOf("10", "33", "77")) {
            val words = arrayOf("--azimuth", azimuth, "--color", "f00", "--light", "flat")
            val without = argb(floor, *words)
            val with = argb(floor, *words, "--ground-shadow")
            val red = without.indices.filter { without[it] == 0xFFFF0000.toInt() }
            assertTrue(red.size > 100 && red.all { with[it] == without[it] }) { azimuth }
        }
    }

    /** Numbers near the end of single precision are rendered; only shadows are not computed for them. */
    @ParameterizedTest
    @ValueSource(strings = ["v 1e38 0 0\nv -3e38 0 0\nv 0 3e38 0", "v 3e38 0 0\nv 0 0 0\nv 0 1 0"])
    fun shadowsOfModelsThatAreTooLargeAreAMistake(corners: String) {
        val huge = folder.resolve("huge.obj")
        huge.writeText("$corners\nf 1 2 3\n")
        val out = folder.resolve("huge.png")
        assertEquals(ExitCode.DONE, zcli("render", huge, "--size", "40x30", "-o", out).code)
        for (words in listOf("--ground-shadow", "--ambient-occlusion", "--style=product", "--ground-shadow --fov=9")) {
            zcli("render", huge, "-o", out, *words.split(' ').toTypedArray())
                .mistake("$huge: ", "reaches more than 1.0E38 world units from its origin", "scale the model down")
        }
    }

    /** Surfaces that are rendered as opaque have shadows. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun opaqueSurfacesHaveShadows() {
        val glass = model("pane", "Kd 0.5 0.5 0.5\nd 0.5")
        val dark = argb(glass, "--ground-shadow", "--opaque").filter { it != -1 }.size
        assertTrue(dark > argb(glass, "--ground-shadow").filter { it != -1 }.size + 20)
    }

    /** The planes contain the ground, and the printed camera gives the picture again. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun thePrintedCameraGivesThePictureWithItsShadow() {
        val out = folder.resolve("a.png")
        val depth = folder.resolve("a.pfm")
        val common = arrayOf("--size", "40x30", "--ground-shadow", "--depth-out", depth)
        val first = zcli("render", cubes, "-o", out, *common, "--print-camera")
        val before = out.image.argb() to depth.toFile().readBytes().toList()
        val words = first.errors.lines().first { it.startsWith("--projection") }.trim().split(' ')
        zcli("render", cubes, "-o", out, *common, *words.toTypedArray()).done()
        assertEquals(before.first, out.image.argb())
        assertEquals(before.second, depth.toFile().readBytes().toList())
    }

    @ParameterizedTest
    @CsvSource(
        "--light moonlight, 'moonlight'",
        "--light-intensity -1, '0'",
        "--light-intensity NaN, ''",
        "--matcap nowhere.png, nowhere.png",
        "--matcap cubes.obj --light sun, --light",
        "--matcap cubes.obj --ambient-occlusion, --ambient-occlusion",
        "--matcap cubes.obj --shading flat, --shading",
        "--matcap cubes.obj --exposure 1, --exposure",
        "--style product --shading gouraud, --shading gouraud",
    )
    fun mistakesAreExplained(words: String, expected: String) {
        val run = zcli("render", cubes, "-o", folder.resolve("never.png"), *words.split(' ').toTypedArray())
        assertEquals(ExitCode.MISTAKE, run.code) { run.errors }
        assertTrue(expected in run.errors) { run.errors }
    }

    @Test
    fun scenesOnTheScreenHaveNoShadows() {
        val scene = folder.resolve("screen.json")
        scene.writeText(
            """{"lazyz": 1, "camera": {"screen": {}}, "surfaces": [{"polygon": {"contours":
                [[[1, 1, 0.5], [9, 1, 0.5], [5, 9, 0.5]]]}}]}""",
        )
        val run = zcli("render", scene, "-o", folder.resolve("never.png"), "--ground-shadow")
        assertEquals(ExitCode.MISTAKE, run.code) { run.errors }
        assertTrue("given on the screen" in run.errors) { run.errors }
    }

    /** Lines look the same in large and in small pictures: they cover the same part of them. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun linesGrowWithThePicture() {
        val parts = listOf("160", "640", "1280").map { side ->
            val pixels = argb(cubes, "--style", "technical", "--size", side, "--aa", "4")
            pixels.sumOf { 255.0 - (it and 0xFF) } / (255.0 * pixels.size)
        }
        assertTrue(parts.max() < 1.6 * parts.min()) { "$parts" }
    }
}
