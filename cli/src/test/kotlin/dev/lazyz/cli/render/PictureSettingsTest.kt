package dev.lazyz.cli.render

import dev.lazyz.Rgba
import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.PictureSettings
import dev.lazyz.scenes.PictureStyle
import dev.lazyz.scenes.Scenes
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.View
import java.nio.file.Path
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** [PictureSettings] give the picture of `zcli render`. */
class PictureSettingsTest {
    @TempDir
    lateinit var folder: Path

    private val usual = PictureSettings(40, 30)

    private fun assertSame(model: Path, settings: PictureSettings, vararg options: String) {
        val out = folder.resolve("out.png")
        zcli("render", model, "--size", "40x30", "-o", out, *options).done()
        val frame = settings.frame(Scenes.load(model))
        assertEquals(out.image.argb(), frame.render(Tiled()).argb.asList(), "$model ${options.asList()}")
    }

    @Test
    fun defaultsAreThoseOfZcli() {
        assertSame(folder.wedge(), usual)
        assertSame(folder.resolve("a.stl").apply { writeBytes(Hills(9).stl()) }, usual)
        val dark = folder.resolve("dark.obj")
        folder.resolve("dark.mtl").writeText("newmtl m\nKd 0.01 0.01 0.01\n")
        dark.writeText("mtllib dark.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        assertSame(dark, usual)
        val scene = folder.resolve("a.json")
        scene.writeText(
            """{"lazyz": 1, "lights": "sun", "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}}],
                "camera": {"perspective": {"eye": [0, 3, 9], "target": [0, 0, 0], "fieldOfView": 20, "near": 1,
                "far": 20}}}""",
        )
        assertSame(scene, usual)
    }

    /** As many as the parameters of the render service, which mean the same: see its `ParametersTest`. */
    @Test
    fun stylesAreThoseOfZcli() {
        val wedge = folder.wedge()
        val scene = folder.resolve("camera.json")
        scene.writeText(
            """{"lazyz": 1, "surfaces": [{"mesh": "wedge.obj"}], "camera": {"perspective": {"eye": [0, 3, 9],
                "target": [0, 0, 0], "fieldOfView": 20, "near": 1, "far": 20}}}""",
        )
        for (model in listOf(wedge, scene)) {
            for (style in PictureStyle.entries) {
                assertSame(model, usual.withStyle(style), "--style", style.name.lowercase())
            }
        }
        val top = usual.withViewpoint(Camera.fit(View.TOP.azimuth, View.TOP.elevation, kind = Fit.ORTHOGRAPHIC))
        assertSame(wedge, top.withStyle(PictureStyle.TECHNICAL), "--style", "technical", "--view", "top")
    }

    @Test
    fun turntablesAreThoseOfZcli() {
        val model = folder.resolve("a.stl").apply { writeBytes(Hills(9).stl()) }
        for (style in listOf(null, PictureStyle.PRODUCT)) {
            val options = if (style == null) emptyArray() else arrayOf("--style", "product")
            val out = "$folder/{frame}.png"
            zcli("render", model, "--size", "40x30", "-o", out, "--turntable", "3", *options).done()
            val turntable = usual.withStyle(style).turntable(Scenes.load(model), 3)
            for (step in 0 until 3) {
                val image = turntable.frame(step).render(Tiled())
                assertEquals(folder.resolve("${step + 1}.png").image.argb(), image.argb.asList(), "$style $step")
            }
        }
    }

    @Test
    fun settingsAreTheOptionsOfZcli() {
        val model = folder.wedge()
        assertSame(model, usual.withViewpoint(Camera.fit(View.ISO.azimuth, View.ISO.elevation)), "--view", "iso")
        assertSame(model, usual.withViewpoint(Camera.fit(5.0, 90.0)), "--view", "top", "--azimuth", "5")
        assertSame(model, usual.withViewpoint(Camera.fit(12.5, -30.0)), "--azimuth", "12.5", "--elevation", "-30")
        assertSame(model, usual.withViewpoint(Camera.fit(kind = Fit.ORTHOGRAPHIC)), "--projection", "orthographic")
        assertSame(model, usual.withViewpoint(Camera.fit(margin = 20.0)), "--margin", "20")
        assertSame(model, usual.withViewpoint(Camera.fit(zoom = 2.5)), "--zoom", "2.5")
        for (up in listOf(UpAxis.Z, UpAxis.MINUS_Z)) assertSame(model, usual.withUp(up), "--up", up.id)
        assertSame(model, usual.withLight(LightRig.THREE_POINT), "--light", "three-point")
        val sunny = usual.withLight(LightRig.SUN).withLightIntensity(0.5f)
        assertSame(model, sunny, "--light", "sun", "--light-intensity", "0.5")
        assertSame(model, usual.withLightIntensity(0.5f), "--light-intensity", "0.5")
        assertSame(model, usual.withBackground(Rgba.TRANSPARENT), "--background", "transparent")
        assertSame(model, usual.withBackground(Rgba.ofRgb(0xFF8800)), "--background", "f80")
        for (factor in listOf(1, 2, 8)) assertSame(model, usual.withSampling(SuperSampling(factor)), "--aa", "$factor")
    }
}
