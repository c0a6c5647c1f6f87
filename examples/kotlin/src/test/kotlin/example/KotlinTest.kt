package example

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.conformance.assertSamePicture
import dev.lazyz.render
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.flow.FlowRenderer
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Mesh
import java.io.ByteArrayInputStream
import javax.imageio.ImageIO
import kotlinx.coroutines.flow.asFlow
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.flow.toList
import kotlinx.coroutines.runBlocking
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What an application in Kotlin does with Lazy Z. The version of Kotlin is a property of the build. */
class KotlinTest {
    /** Corner `i` of the cube has the bits of `i` as coordinates. */
    private val cube = scene {
        val corners = FloatArray(24) { if ((it / 3 shr it % 3) and 1 == 0) -1f else 1f }
        val faces = listOf(
            listOf(0, 2, 3, 1), listOf(4, 5, 7, 6), listOf(0, 1, 5, 4),
            listOf(2, 6, 7, 3), listOf(0, 4, 6, 2), listOf(1, 3, 7, 5),
        )
        add(Mesh(corners, faces.flatMap { (a, b, c, d) -> listOf(a, b, c, a, c, d) }.toIntArray()))
    }

    @Test
    fun aCubeBecomesAPngFile() {
        val image: Image = TiledRenderer().render(cube.frame(64, 48))
        val read = ImageIO.read(ByteArrayInputStream(image.toPng()))
        assertTrue(image.visible > 500) { "$image" }
        for (y in 0 until 48) for (x in 0 until 64) assertEquals(image.argb[y * 64 + x], read.getRGB(x, y))
    }

    @Test
    fun rowsOfACubeAreAFlow() {
        val frame = cube.frame(64, 48)
        val rows = runBlocking { FlowRenderer().rows(frame).map { it.argb() }.toList() }
        val expected = ZBufferRenderer().render(frame).argb
        assertArrayEquals(expected, rows.flatMap { it.take(64) }.toIntArray())
    }

    @Test
    fun anOwnPrimitiveIsTheSameInEveryRenderer() {
        val raster = Raster(64, 48)
        val discs = listOf(Disc(raster, 20, 20, 15, depth = 1000), Disc(raster, 30, 28, 10, depth = 500))
        val frame = Frame(raster, discs)
        val expected = ZBufferRenderer().render(frame)
        for (renderer in Renderers.builtIn) assertSamePicture(expected, renderer.render(frame), renderer.id)
        val streamed = Image.Collector(frame.region)
        val counters = runBlocking { ZBufferRenderer().render(raster, discs.asFlow(), streamed) }
        assertSamePicture(expected, streamed.toImage(counters))
    }

    @Test
    fun aSceneFileIsRead() {
        val text = """
            {
              "lazyz": 1,
              "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "material": {"baseColor": "#cc4b37"}}]
            }
        """
        val loaded = Scenes.load(text.byteInputStream(), SceneFormat.SCENE)
        val image = ZBufferRenderer().render(loaded.scene.frame(32, 32))
        assertTrue(image.visible > 100) { "$image" }
    }
}
