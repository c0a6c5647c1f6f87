package dev.lazyz.cli.render

import dev.lazyz.DepthTest
import dev.lazyz.Image
import dev.lazyz.Raster.DepthConvention
import dev.lazyz.Rgba
import dev.lazyz.cli.zcli
import dev.lazyz.scenes.DepthRules
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.Tint
import dev.lazyz.scenes.scenefile.SceneFile
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Scene files that determine every sample: positions in pixels, rules of depth, the test pattern. */
class ScreenSceneTest {
    @TempDir
    lateinit var folder: Path

    private val size = ImageSize(24, 16)

    private fun triangle(depth: Double, number: Int) = Polygon(
        listOf(listOf(Vertex(1.0, 1.0, depth), Vertex(23.0, 8.5, 1 - depth), Vertex(2.25, 15.0, depth))),
        Material(shader = Tint(number)),
    )

    private val scene = Scene(listOf(triangle(0.25, 1), triangle(0.75, 2)), viewpoint = Camera.screen())
        .withBackground(Rgba(0.25f, 0.5f, 0.125f, 0.75f))

    private val depth = DepthRules(DepthConvention.LARGER_IS_NEARER, DepthTest.LESS_OR_EQUAL, Int.MAX_VALUE)

    private val file: Path by lazy { folder.resolve("screen.json").also { SceneFile.write(scene, it, size, depth) } }

    private fun picture(rules: DepthRules): Image =
        ZBufferRenderer().render(scene.frame(rules.raster(size.width, size.height, scene.background)))

    private fun hash(vararg words: Any): Any? =
        zcli("render", file, "--stats=json", "-o", folder.resolve("out.png"), *words).done().stat("pixelHash")

    @Test
    fun pictureIsThatOfTheFile() {
        assertTrue(picture(depth).visible > 100)
        assertEquals(picture(depth).pixelHash(), hash())
        assertEquals(picture(depth).pixelHash(), hash("--strategy", "scanline"))
        zcli("compare", file).done()
    }

    @Test
    fun depthConventionOfTheCommandLineReplacesTheFiles() {
        val usual = picture(DepthRules()).pixelHash()
        assertNotEquals(usual, picture(depth).pixelHash())
        for (order in listOf("smaller", "larger")) assertEquals(usual, hash("--depth-convention", order))
    }

    @Test
    fun screenHasOneSampleAPixel() {
        val run = zcli("render", file, "--aa", "2", "-o", folder.resolve("out.png"))
        run.mistake("--aa 2: a scene that is given on the screen has one sample a pixel; use --aa 1")
    }

    @Test
    fun screenHasNoUpAxis() {
        val run = zcli("render", file, "--up", "z", "-o", folder.resolve("out.png"))
        run.mistake("--up: a scene given on the screen cannot be rotated")
    }
}
