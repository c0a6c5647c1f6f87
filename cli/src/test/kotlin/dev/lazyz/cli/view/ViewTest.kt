package dev.lazyz.cli.view

import dev.lazyz.cli.ChildZcli
import dev.lazyz.cli.WEDGE
import dev.lazyz.cli.image
import dev.lazyz.cli.run
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import dev.lazyz.shared.VirtualDisplay
import dev.lazyz.swing.ModelView
import java.awt.Robot
import java.awt.Toolkit
import java.awt.Window
import java.awt.datatransfer.DataFlavor
import java.awt.event.InputEvent
import java.awt.event.KeyEvent
import java.awt.image.BufferedImage
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.TimeUnit
import javax.swing.JFrame
import javax.swing.SwingUtilities
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The window of `zcli view`. */
class ViewTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun withoutADisplayThereIsAMessage() {
        val child = ChildZcli(folder)
        val process = child.start(listOf("view", "teapot"), listOf("-Djava.awt.headless=true"))
        assertEquals(2, child.code(process))
        assertTrue("there is no display to open a window on" in child.errors, child.errors)
        val lost = child.start(listOf("view", "teapot"), listOf("-Djava.awt.headless=false")) {
            environment()["DISPLAY"] = "localhost:9999"
        }
        assertEquals(2, child.code(lost))
        assertTrue("there is no display to open a window on" in child.errors, child.errors)
    }

    @Test
    fun mistakesAreFoundBeforeThereIsAWindow() {
        zcli("view", folder.resolve("none.obj")).mistake("none.obj: no such file")
        zcli("view", "teapot", "--aa", "3").mistake("--aa")
        zcli("view").mistake("missing argument")
    }

    @Test
    fun aWindowShowsFilesAndCopiesPictureAndCommand() {
        val display = VirtualDisplay.open()
        assumeTrue(display != null, "there is no Xvfb")
        val (output, code) =
            checkNotNull(display).use { it.run("dev.lazyz.cli.view.ViewTestKt", "${folder.wedge()}", "$folder") }
        assertEquals("done\n" to 0, output to code)
    }
}

/** Uses the window of `zcli view` for the file of the first argument and a teapot; the second is a folder. */
fun main(args: Array<String>): Unit = VirtualDisplay.program { ViewRun(args[0], Path.of(args[1])).run() }

private class ViewRun(private val file: String, private val folder: Path) {
    private val robot = Robot()
    private val errors = ByteArrayOutputStream()
    private val ended = CompletableFuture.supplyAsync {
        val words = arrayOf("view", file, "teapot", "--size", "300x200", "--light", "sun")
        run(words, "".byteInputStream(), OutputStream.nullOutputStream(), PrintStream(errors))
    }
    private val window: JFrame by lazy {
        await("a window") { windows().isNotEmpty() }
        windows().single()
    }

    private fun windows() = Window.getWindows().filterIsInstance<JFrame>().filter { it.isShowing }

    fun run() {
        await("the first title") { "wedge.obj (1 of 2) - zcli" in window.title }
        val view = window.contentPane.getComponent(0) as ModelView
        await("the first picture") { view.picture != null }
        val corner = view.locationOnScreen
        robot.mouseMove(corner.x + 150, corner.y + 100)
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK)
        for (step in 1..10) robot.mouseMove(corner.x + 150 + 3 * step, corner.y + 100)
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK)

        // The command that is copied makes the picture that is copied
        val first = copied()
        assertEquals(300, first.width)

        // A file that changes is read again, and seen by the same camera
        Path.of(file).writeText(WEDGE.replace("v 4 0 0", "v 3 0 0"))
        await("a new picture") { copiedPicture().argb() != first.argb() }
        copied()
        type(KeyEvent.VK_N)
        await("the next title") { "teapot (2 of 2) - zcli" in window.title }
        copied()
        type(KeyEvent.VK_W, KeyEvent.VK_CONTROL)
        assertEquals(0, ended.get(5, TimeUnit.MINUTES), "$errors")
        assertEquals("", "$errors")
    }

    /** Copies picture and command until both agree, which they do when the picture rests. */
    private fun copied(): BufferedImage {
        var picture = copiedPicture()
        await("the same picture") {
            picture = copiedPicture()
            val command = copiedCommand()
            val words = command.split(" ").drop(1)
            val output = folder.resolve("again.png")
            zcli(*(words.take(words.indexOf("-o") + 1) + "$output").toTypedArray()).done()
            output.image.argb() == picture.argb()
        }
        return picture
    }

    private fun copiedPicture(): BufferedImage = copy(DataFlavor.imageFlavor, KeyEvent.VK_CONTROL) as BufferedImage

    private fun copiedCommand(): String =
        copy(DataFlavor.stringFlavor, KeyEvent.VK_CONTROL, KeyEvent.VK_SHIFT) as String

    private fun copy(flavor: DataFlavor, vararg modifiers: Int): Any {
        val board = Toolkit.getDefaultToolkit().systemClipboard
        await("a copy") {
            type(KeyEvent.VK_C, *modifiers)
            board.isDataFlavorAvailable(flavor)
        }
        return board.getData(flavor)
    }

    private fun type(key: Int, vararg modifiers: Int) {
        modifiers.forEach(robot::keyPress)
        robot.keyPress(key)
        robot.keyRelease(key)
        modifiers.forEach(robot::keyRelease)
        robot.waitForIdle()
    }

    private fun BufferedImage.argb() = getRGB(0, 0, width, height, null, 0, width).map { it or (0xFF shl 24) }

    private fun await(what: String, condition: () -> Boolean) {
        VirtualDisplay.await(what, { "$errors" }, condition)
        SwingUtilities.invokeAndWait {}
    }
}
