package dev.lazyz.swing

import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import java.awt.Dimension
import java.awt.Graphics
import java.awt.Toolkit
import java.awt.event.InputEvent
import java.awt.event.MouseEvent
import java.lang.management.ManagementFactory
import java.nio.file.Path
import java.util.concurrent.Semaphore
import javax.swing.JFrame
import javax.swing.SwingUtilities
import kotlin.io.path.name
import kotlin.system.exitProcess

/**
 * Measures the time from a movement of the mouse to the painted picture, at 1280 x 800, for the files that the
 * arguments name: `java -cp ... dev.lazyz.swing.ViewTimesKt FILE...`, on a display. Prints lines of comma-separated
 * values: the file, what is dragged, the median on the wall and the mean processor time of a picture, milliseconds. The
 * latter counts all threads of the program, and what else the machine does hardly disturbs it.
 */
fun main(args: Array<String>) {
    println("file,drag,wall-ms,processor-ms")
    for (file in args.map(Path::of)) {
        val times = ViewTimes(file)
        println("${file.name},turn,${times.measured()}")
        times.settings(PictureSettings().with(PictureParameters.EDGES, true))
        println("${file.name},turn with edges,${times.measured()}")
        times.settings(PictureSettings())
        times.cut()
        println("${file.name},turn of a cut model,${times.measured()}")
        println("${file.name},cut,${times.measured { times.cut(it) }}")
        times.close()
    }
    exitProcess(0)
}

private class ViewTimes(file: Path) {
    private val painted = Semaphore(0)
    private val rest = Semaphore(0)
    private val view = object : ModelView() {
        public override fun paintComponent(graphics: Graphics) {
            super.paintComponent(graphics)
            painted.release()
        }
    }
    private val window = JFrame()
    private val threads = ManagementFactory.getThreadMXBean()
    private var x = 600

    init {
        SwingUtilities.invokeAndWait {
            view.preferredSize = Dimension(1280, 800)
            view.onRest = Runnable { rest.release() }
            view.open(file)
            window.contentPane.add(view)
            window.pack()
            window.isVisible = true
        }
        rest.acquire()
        mouse(MouseEvent.MOUSE_PRESSED)
    }

    fun settings(settings: PictureSettings) = SwingUtilities.invokeAndWait { view.settings = settings }

    fun cut() = SwingUtilities.invokeAndWait { view.cut(DraggedCut(0, 50.0, isReversed = false)) }

    fun cut(step: Int) = SwingUtilities.invokeLater { view.cut(DraggedCut(0, 40.0 + step % 20, isReversed = false)) }

    fun close() = SwingUtilities.invokeAndWait(window::dispose)

    /** Returns the times of pictures after [move], once the code is compiled. */
    fun measured(move: (Int) -> Unit = { mouse(MouseEvent.MOUSE_DRAGGED) }): String {
        repeat(WARM) { after(it, move) }
        val start = processorTime()
        val times = List(MEASURED) { after(it, move) }.sorted()
        val processor = (processorTime() - start) / MEASURED
        return "%.1f,%.1f".format(times[MEASURED / 2] / MILLISECOND, processor / MILLISECOND)
    }

    /** The time of all threads but those that compile and collect garbage. */
    private fun processorTime() = threads.allThreadIds.sumOf { maxOf(0L, threads.getThreadCpuTime(it)) }

    private fun after(step: Int, move: (Int) -> Unit): Long {
        painted.drainPermits()
        val start = System.nanoTime()
        move(step)
        painted.acquire()
        return System.nanoTime() - start
    }

    private fun mouse(id: Int) {
        x = if (x > 1200) 10 else x + 5
        val event = MouseEvent(view, id, 0, InputEvent.BUTTON1_DOWN_MASK, x, 400, 1, false, MouseEvent.BUTTON1)
        Toolkit.getDefaultToolkit().systemEventQueue.postEvent(event)
    }

    private companion object {
        const val WARM = 150
        const val MEASURED = 60
        const val MILLISECOND = 1e6
    }
}
