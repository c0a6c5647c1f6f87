package dev.lazyz.swing

import dev.lazyz.scenes.pictures.CutPlane
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.world.camera.FittedViewpoint.View
import java.awt.BasicStroke
import java.awt.Color
import java.awt.Graphics2D
import java.awt.event.ActionEvent
import java.awt.event.MouseAdapter
import java.awt.event.MouseEvent
import java.awt.event.MouseWheelEvent
import java.awt.geom.Ellipse2D
import java.awt.geom.Line2D
import java.awt.geom.Point2D
import javax.swing.AbstractAction
import javax.swing.Action
import javax.swing.JComponent
import javax.swing.KeyStroke
import javax.swing.SwingUtilities
import kotlin.math.abs
import kotlin.math.pow
import org.joml.Vector3d

/**
 * A plane at right angles to an axis of the model, which users can move. Immutable.
 *
 * @property axis 0 for x, 1 for y, 2 for z
 * @property percent where it is in the bounds of the model
 * @property isReversed whether what has smaller coordinates is removed, and not what has greater ones
 */
internal class DraggedCut(val axis: Int, val percent: Double, val isReversed: Boolean) {
    val plane: CutPlane =
        checkNotNull(CutPlane.parse("${if (isReversed) "-" else ""}${"xyz"[axis]}=${Math.round(10 * percent) / 10.0}%"))

    fun moved(by: Double): DraggedCut = DraggedCut(axis, (percent + by).coerceIn(0.0, 100.0), isReversed)
}

/** What the mouse and the keyboard do with [view]. */
internal class ViewControls(private val view: ModelView) : MouseAdapter() {
    private var last: MouseEvent? = null
    private var hasMoved = false

    /** Whether the handle of the cut is dragged. */
    private var isCutting = false

    /** The name, the key and the work of each command. */
    private val commands = listOf<Triple<String, String, () -> Unit>>(
        Triple("Turn left", "LEFT") { orbit { it.turned(-STEP, 0.0) } },
        Triple("Turn right", "RIGHT") { orbit { it.turned(STEP, 0.0) } },
        Triple("Turn up", "UP") { orbit { it.turned(0.0, STEP) } },
        Triple("Turn down", "DOWN") { orbit { it.turned(0.0, -STEP) } },
        Triple("Move left", "shift LEFT") { orbit { it.moved(-PART, 0.0) } },
        Triple("Move right", "shift RIGHT") { orbit { it.moved(PART, 0.0) } },
        Triple("Move up", "shift UP") { orbit { it.moved(0.0, PART) } },
        Triple("Move down", "shift DOWN") { orbit { it.moved(0.0, -PART) } },
        Triple("Larger", "typed +") { orbit { it.zoomed(ZOOM, 0.0, 0.0) } },
        Triple("Smaller", "typed -") { orbit { it.zoomed(1 / ZOOM, 0.0, 0.0) } },
        Triple("Whole model", "HOME") { view.showWhole() },
    ) + View.entries.mapIndexed { number, side ->
        Triple("From ${side.name.lowercase()}", "typed ${number + 1}") { view.showWhole(side) }
    } + listOf(
        Triple("Perspective or orthographic", "P") { orbit { it.withOtherProjection() } },
        Triple("Edges", "E", ::toggleEdges),
        Triple("Cut", "C", ::nextCut),
        Triple("Cut from the other side", "X") { cut { DraggedCut(it.axis, it.percent, !it.isReversed) } },
        Triple("Cut less", "PAGE_UP") { cut { it.moved(if (it.isReversed) -CUT_STEP else CUT_STEP) } },
        Triple("Cut more", "PAGE_DOWN") { cut { it.moved(if (it.isReversed) CUT_STEP else -CUT_STEP) } },
        Triple("Select the middle", "SPACE") { view.pick(view.width / 2, view.height / 2) },
    )

    val actions: List<Action> = commands.map { (name, key, work) ->
        object : AbstractAction(name) {
            override fun actionPerformed(event: ActionEvent) = work()
        }.apply { putValue(Action.ACCELERATOR_KEY, checkNotNull(KeyStroke.getKeyStroke(key)) { key }) }
    }

    fun install() {
        view.addMouseListener(this)
        view.addMouseMotionListener(this)
        view.addMouseWheelListener(this)
        for (action in actions) {
            val name = action.getValue(Action.NAME)
            view.getInputMap(JComponent.WHEN_FOCUSED).put(action.getValue(Action.ACCELERATOR_KEY) as KeyStroke, name)
            view.actionMap.put(name, action)
        }
    }

    private fun orbit(change: (Orbit) -> Orbit) {
        view.orbit()?.let { view.see(change(it)) }
    }

    private fun cut(change: (DraggedCut) -> DraggedCut) {
        view.cut?.let { view.cut(change(it)) }
    }

    /** Goes from no cut to the middle of x, y and z, and back. */
    private fun nextCut() {
        val axis = view.cut?.let { it.axis + 1 } ?: 0
        view.cut(if (axis > 2) null else DraggedCut(axis, MIDDLE, isReversed = false))
    }

    private fun toggleEdges() {
        val settings = view.settings
        view.settings =
            if (settings[PictureParameters.EDGES] == true || settings[PictureParameters.WIREFRAME] == true) {
                ViewWorker.EDGES.fold(settings) { all, edges -> all.without(edges) }
            } else {
                settings.with(PictureParameters.EDGES, true)
            }
    }

    /** Where the handle of [cut] is: in the middle of the model, on the plane. Null if that is not in the picture. */
    fun handle(cut: DraggedCut): Point2D? {
        val box = view.model?.scene?.bounds ?: return null
        val low = box.corner(0)[cut.axis]
        val high = box.corner(7)[cut.axis]
        return view.place(box.center.setComponent(cut.axis, low + cut.percent / 100 * (high - low)))
    }

    override fun mousePressed(event: MouseEvent) {
        view.requestFocusInWindow()
        last = event
        hasMoved = false
        val handle = view.cut?.let(::handle)
        isCutting = handle != null && handle.distance(event.point) <= DOT_RADIUS + 2
    }

    override fun mouseDragged(event: MouseEvent) {
        val from = last ?: return
        val right = (event.x - from.x).toDouble()
        val down = (event.y - from.y).toDouble()
        if (!hasMoved && abs(right) + abs(down) < CLICK) return
        hasMoved = true
        last = event
        val height = view.height.toDouble()
        when {
            isCutting -> cut { dragged(it, right, down) }
            SwingUtilities.isLeftMouseButton(event) && !event.isShiftDown ->
                orbit { it.turned(-DEGREES * right, DEGREES * down) }
            else -> orbit { it.moved(-right / height, down / height) }
        }
    }

    override fun mouseReleased(event: MouseEvent) {
        last = null
        if (!hasMoved && !isCutting && SwingUtilities.isLeftMouseButton(event)) view.pick(event.x, event.y)
        isCutting = false
    }

    override fun mouseWheelMoved(event: MouseWheelEvent) {
        val x = (event.x - view.width / 2.0) / view.height
        val y = (view.height / 2.0 - event.y) / view.height
        orbit { it.zoomed(WHEEL.pow(-event.preciseWheelRotation), x, y) }
    }

    /** Returns [cut] after its handle was dragged to the right and down by this many pixels. */
    private fun dragged(cut: DraggedCut, right: Double, down: Double): DraggedCut {
        val from = handle(DraggedCut(cut.axis, cut.percent - 1, cut.isReversed)) ?: return cut
        val to = handle(DraggedCut(cut.axis, cut.percent + 1, cut.isReversed)) ?: return cut
        val x = (to.x - from.x) / 2
        val y = (to.y - from.y) / 2
        val square = x * x + y * y

        // Along the line of sight, the plane does not move in the picture
        return if (square < LEAST_PIXELS) cut.moved(-down) else cut.moved((right * x + down * y) / square)
    }

    companion object {
        /** Degrees of a turn by a key. */
        private const val STEP = 15.0

        /** Degrees of a turn for each pixel. */
        private const val DEGREES = 0.5

        /** The part of the picture by which a key moves the model. */
        private const val PART = 0.1
        private const val ZOOM = 1.25
        private const val WHEEL = 1.15
        private const val CUT_STEP = 2.0
        private const val MIDDLE = 50.0

        /** A mouse that moves less than this, in pixels, clicks. */
        private const val CLICK = 3.0
        private const val LEAST_PIXELS = 0.01
    }
}

/** Half the width of a dot. */
internal const val DOT_RADIUS: Double = 7.0

/** Draws a circle with a dot in it, which can be seen on any background. */
internal fun Graphics2D.drawDot(at: Point2D, color: Color) {
    val circle = Ellipse2D.Double(at.x - DOT_RADIUS, at.y - DOT_RADIUS, 2 * DOT_RADIUS, 2 * DOT_RADIUS)
    this.color = Color.WHITE
    stroke = BasicStroke(4f)
    draw(circle)
    this.color = color
    stroke = BasicStroke(2f)
    draw(circle)
    draw(Line2D.Double(at.x - 1, at.y, at.x + 1, at.y))
}

/** Draws the lines of [text] in the upper left corner. */
internal fun Graphics2D.drawLines(text: String, foreground: Color, background: Color) {
    text.lines().forEachIndexed { line, words ->
        val y = MARGIN + line * fontMetrics.height
        color = background
        fillRect(MARGIN - 2, y, fontMetrics.stringWidth(words) + 4, fontMetrics.height)
        color = foreground
        drawString(words, MARGIN, y + fontMetrics.ascent)
    }
}

private const val MARGIN = 10
