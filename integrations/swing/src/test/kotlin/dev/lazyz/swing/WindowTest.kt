package dev.lazyz.swing

import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.shared.VirtualDisplay
import dev.lazyz.strategies.tiled.TiledRenderer
import java.awt.Point
import java.awt.Rectangle
import java.awt.Robot
import java.awt.event.InputEvent
import java.awt.event.KeyEvent
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import javax.swing.JFrame
import javax.swing.SwingUtilities
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The component in a window, with a mouse and a keyboard. Skipped where Xvfb is not installed. */
class WindowTest {
    @Test
    fun mouseAndKeyboardWork(@TempDir folder: Path) {
        val car = folder.resolve("car.obj")
        car.writeText(
            "v -2 -1 0\nv -0.1 -1 0\nv -1 1 0\nv 0.1 -1 0\nv 2 -1 0\nv 1 1 0\n" +
                "o car\ng door\nf 1 2 3\ng wheel\nf 4 5 6\n",
        )
        val display = VirtualDisplay.open()
        assumeTrue(display != null, "there is no Xvfb")
        val (output, code) = checkNotNull(display).use {
            it.run("dev.lazyz.swing.WindowTestKt", "$car", Path.of("target/window.png").toAbsolutePath().toString())
        }
        assertEquals("done\n" to 0, output to code)
    }
}

/** Uses a window with the model of the first argument, and writes a picture of the screen to the second. */
fun main(args: Array<String>): Unit = VirtualDisplay.program { RobotRun(Path.of(args[0]), Path.of(args[1])).run() }

private class RobotRun(private val file: Path, private val picture: Path) {
    private val robot = Robot()
    private val view = ModelView()
    private val model = Scenes.load(file)
    private val corner: Point
    private val screen: BufferedImage
        get() = robot.createScreenCapture(Rectangle(corner.x, corner.y, view.width, view.height))

    init {
        SwingUtilities.invokeAndWait {
            val window = JFrame("a model")
            view.open(file)
            window.contentPane.add(view)
            window.pack()
            window.isVisible = true
        }
        await("the first picture") { view.picture != null }
        corner = view.locationOnScreen
    }

    fun run() {
        // A drag turns, by half a degree a pixel
        move(300, 200)
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        for (step in 1..30) move(300 + 2 * step, 200 - step)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
        awaitWords("azimuth 0, elevation 5")
        val before = checkNotNull(view.pictureSettings).options
        robot.mouseWheel(-2)
        await("the wheel") { checkNotNull(view.pictureSettings).options != before }

        // The screen shows what the settings make, once it rests
        await("the same picture") { screen.argb() == expected() }

        // A click selects, and keys show the front, a cut, and edges
        move(60, 300)
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)
        await("a selection") { view.selection?.seen?.part == "car/door" }
        type(KeyEvent.VK_1)
        awaitWords("azimuth 0, elevation 0;")
        type(KeyEvent.VK_C)
        awaitWords("cut at x=50.0%;")
        type(KeyEvent.VK_E)
        await("edges") { view.pictureSettings?.get(PictureParameters.EDGES) == true }
        ImageIO.write(screen, "png", picture.toFile())
    }

    private fun move(x: Int, y: Int) = robot.mouseMove(corner.x + x, corner.y + y)

    private fun type(key: Int) {
        robot.keyPress(key)
        robot.keyRelease(key)
    }

    private fun awaitWords(words: String) = await(words) { words in view.accessibleContext.accessibleDescription }

    private fun await(what: String, condition: () -> Boolean) =
        VirtualDisplay.await(what, { view.accessibleContext.accessibleDescription }) {
            var holds = false
            SwingUtilities.invokeAndWait { holds = condition() }
            holds
        }

    private fun expected() = checkNotNull(view.pictureSettings).frame(model).render(TiledRenderer()).argb.toList()

    private fun BufferedImage.argb() = getRGB(0, 0, width, height, null, 0, width).toList()
}
