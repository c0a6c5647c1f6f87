package dev.lazyz.cli.view

import dev.lazyz.cli.input.FrameSource
import dev.lazyz.cli.input.ShownInput
import dev.lazyz.cli.input.TimeLimit
import dev.lazyz.cli.output.CommandLine
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Streams
import dev.lazyz.cli.output.Version
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.swing.ModelView
import java.awt.AWTError
import java.awt.Dimension
import java.awt.GraphicsEnvironment
import java.awt.Image
import java.awt.Toolkit
import java.awt.datatransfer.DataFlavor
import java.awt.datatransfer.StringSelection
import java.awt.datatransfer.Transferable
import java.awt.datatransfer.UnsupportedFlavorException
import java.awt.event.ActionEvent
import java.awt.event.WindowAdapter
import java.awt.event.WindowEvent
import java.io.IOException
import java.lang.reflect.InvocationTargetException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.util.concurrent.CountDownLatch
import javax.swing.AbstractAction
import javax.swing.Action
import javax.swing.JFrame
import javax.swing.JMenu
import javax.swing.JMenuBar
import javax.swing.KeyStroke
import javax.swing.SwingUtilities
import javax.swing.Timer
import javax.swing.WindowConstants

/** The work of `zcli view`: a window with [inputs], one after the other. */
internal class ViewJob(private val inputs: List<ShownInput>, private val streams: Streams) {
    /** Opens the window, and waits until it is closed. */
    fun run() {
        for (input in inputs) FrameSource(input, streams).input.requireNamed()
        requireDisplay()
        val closed = CountDownLatch(1)
        try {
            SwingUtilities.invokeAndWait { ViewWindow(inputs, streams, closed::countDown).open() }
        } catch (failure: InvocationTargetException) {
            throw failure.cause ?: failure
        }
        closed.await()
    }

    private fun requireDisplay() {
        if (GraphicsEnvironment.isHeadless()) throw Mistake(NO_DISPLAY)
        try {
            Toolkit.getDefaultToolkit()
        } catch (unreachable: AWTError) {
            throw Mistake("$NO_DISPLAY (${unreachable.message})")
        } catch (headless: LinkageError) {
            // Some systems have a Java without windows
            throw Mistake("$NO_DISPLAY (${headless.message})")
        }
    }

    private companion object {
        const val NO_DISPLAY = "there is no display to open a window on; 'zcli render' makes a picture without one"
    }
}

/** The window. Used by Swing's thread. */
private class ViewWindow(
    private val inputs: List<ShownInput>,
    private val streams: Streams,
    private val closed: () -> Unit,
) {
    private val window = JFrame()
    private val view = ModelView()
    private var number = 0
    private val input get() = inputs[number]

    /** When the files of the model were changed that have been seen. */
    private var changes = emptyMap<Path, FileTime?>()

    fun open() {
        val settings = input.settings
        view.settings = settings
        val size = settings[PictureParameters.SIZE] ?: USUAL_SIZE
        view.preferredSize = Dimension(size.width, size.height)
        view.onRest = Runnable { streams.progress("") }
        window.jMenuBar = menus()
        window.contentPane.add(view)
        window.defaultCloseOperation = WindowConstants.DISPOSE_ON_CLOSE
        val timer = Timer(PERIOD_MILLIS) { reloadIfChanged() }
        window.addWindowListener(
            object : WindowAdapter() {
                override fun windowClosed(event: WindowEvent) {
                    timer.stop()
                    closed()
                }
            },
        )
        show(0)
        window.pack()
        window.isVisible = true
        view.requestFocusInWindow()
        timer.start()
    }

    private fun menus() = JMenuBar().apply {
        val file = JMenu("File")
        if (inputs.size > 1) {
            file.add(action("Next", "N") { show((number + 1) % inputs.size) })
            file.add(action("Previous", "shift N") { show((number + inputs.size - 1) % inputs.size) })
        }
        file.add(action("Copy picture", "ctrl C", ::copyPicture))
        file.add(action("Copy command", "ctrl shift C", ::copyCommand))
        file.add(action("Close", "ctrl W", window::dispose))
        add(file)
        val model = JMenu("Model")
        view.actions.forEach(model::add)
        add(model)
    }

    private fun action(name: String, key: String, work: () -> Unit): Action {
        val action = object : AbstractAction(name) {
            override fun actionPerformed(event: ActionEvent) = work()
        }
        action.putValue(Action.ACCELERATOR_KEY, KeyStroke.getKeyStroke(key))
        return action
    }

    private fun show(next: Int) {
        number = next
        val shown = input
        val source = FrameSource(shown, streams)
        val place = if (inputs.size > 1) " (${number + 1} of ${inputs.size})" else ""
        window.title = "${shown.input}$place - zcli ${Version.text}"
        view.accessibleContext.accessibleName = shown.input
        changes = source.files.associateWith(::changed)
        view.show(shown.input) { TimeLimit.OF_INPUT.hold(shown.timeLimit, shown.input) { source.load() } }
    }

    /** Reads the model again if a file of it has changed. One that was not known before is seen from now on. */
    private fun reloadIfChanged() {
        val files = FrameSource(input, streams).files + view.model?.files.orEmpty()
        val now = files.associateWith(::changed)
        val isChanged = now.any { (file, time) -> file in changes && changes[file] != time }
        changes = changes + now
        if (isChanged) view.reload()
    }

    private fun changed(file: Path): FileTime? = try {
        Files.getLastModifiedTime(file)
    } catch (_: IOException) {
        null
    }

    private fun copyPicture() {
        val picture = view.picture ?: return
        val content = object : Transferable {
            override fun getTransferDataFlavors() = arrayOf(DataFlavor.imageFlavor)

            override fun isDataFlavorSupported(flavor: DataFlavor) = flavor == DataFlavor.imageFlavor

            override fun getTransferData(flavor: DataFlavor): Image =
                if (isDataFlavorSupported(flavor)) picture else throw UnsupportedFlavorException(flavor)
        }
        Toolkit.getDefaultToolkit().systemClipboard.setContents(content, null)
    }

    private fun copyCommand() {
        val settings = view.pictureSettings ?: return
        val output = FrameSource(input, streams).input.baseName ?: "picture"
        val words = listOf("render", input.input) + settings.options + listOf("-o", "$output.png")
        Toolkit.getDefaultToolkit().systemClipboard.setContents(StringSelection(CommandLine.of(words)), null)
    }

    private companion object {
        val USUAL_SIZE = ImageSize(960, 640)
        const val PERIOD_MILLIS = 500
    }
}
