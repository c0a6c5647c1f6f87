package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.options.ParameterOptions
import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.ParameterGroup
import dev.lazyz.scenes.pictures.PictureDoor
import dev.lazyz.scenes.pictures.PictureObserver
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureStyle
import dev.lazyz.shared.PictureWords
import dev.lazyz.strategies.tiled.TiledRenderer
import java.nio.file.Path
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** The options give the pictures and the messages of the library. */
class ParameterOptionsTest {
    @TempDir
    lateinit var folder: Path

    private val usual = ParameterOptions.NONE.withDefault(PictureParameters.SIZE, ImageSize(40, 30))

    private fun assertSame(model: Path, words: Map<String, String>) {
        val options = words.map { (name, word) -> if (word == "true") "--$name" else "--$name=$word" }
        val run = zcli("render", model, "--size", "40x30", "-o", "-", *options.toTypedArray())
        val image = try {
            val settings = PictureDoor.COMMAND_LINE.read(usual, words.toList()).also { it.check() }
            settings.frame(Scenes.load(model), observer = PictureObserver("$model")).render(TiledRenderer())
        } catch (e: IllegalArgumentException) {
            assertTrue(e.message.orEmpty().substringAfter(": ") in run.errors) { "$words: ${e.message}\n${run.errors}" }
            assertEquals(ExitCode.MISTAKE, run.code)
            return
        }
        assertEquals(ExitCode.DONE, run.code) { "$words: ${run.errors}" }
        assertEquals(image.argb.asList(), run.image.argb(), "$model $words")
    }

    @Test
    fun eachParameterIsAnOptionWithTheSamePicturesAndMessages() {
        val model = folder.wedge()
        for ((name, bytes) in PictureWords.files) folder.resolve(name).writeBytes(bytes)
        val names = PictureDoor.COMMAND_LINE.parameters.filter { it.group != ParameterGroup.PAPER }.map { it.name }
        for (words in PictureWords.combinations(names)) {
            // A switch has no value
            if ("" in words.values) continue
            assertSame(
                model,
                words.mapValues { (_, word) ->
                    if (word in
                        PictureWords.files
                    ) {
                        "${folder.resolve(word)}"
                    } else {
                        word
                    }
                }
            )
        }
    }

    @Test
    fun defaultsDependOnTheFile() {
        assertSame(folder.resolve("a.stl").apply { writeBytes(Hills(9).stl()) }, emptyMap())
        val dark = folder.resolve("dark.obj")
        folder.resolve("dark.mtl").writeText("newmtl m\nKd 0.01 0.01 0.01\n")
        dark.writeText("mtllib dark.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        assertSame(dark, emptyMap())
        val scene = folder.resolve("a.json")
        scene.writeText(
            """{"lazyz": 1, "lights": "sun", "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}}],
                "camera": {"perspective": {"eye": [0, 3, 9], "target": [0, 0, 0], "fieldOfView": 20, "near": 1,
                "far": 20}}}""",
        )
        assertSame(scene, emptyMap())
        for (style in listOf("technical", "product")) assertSame(scene, mapOf("style" to style))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun turntablesAreThoseOfTheLibrary() {
        val model = folder.resolve("a.stl").apply { writeBytes(Hills(9).stl()) }
        for (style in listOf(null, PictureStyle.PRODUCT)) {
            val options = if (style == null) emptyArray() else arrayOf("--style", "product")
            val out = "$folder/{frame}.png"
            zcli("render", model, "--size", "40x30", "-o", out, "--turntable", "3", *options).done()
            val settings = if (style == null) usual else usual.with(PictureParameters.STYLE, style)
            val turntable = settings.turntable(Scenes.load(model), 3)
            for (step in 0 until 3) {
                val image = turntable.frame(step).render(TiledRenderer())
                assertEquals(image.argb.asList(), folder.resolve("${step + 1}.png").image.argb(), "$style $step")
            }
        }
    }
}
