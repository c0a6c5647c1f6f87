package dev.lazyz.swing

import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LoadLimits
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.FittedViewpoint.View
import java.awt.Color
import java.awt.Dimension
import java.awt.Graphics
import java.awt.Graphics2D
import java.awt.RenderingHints
import java.awt.Transparency
import java.awt.event.ActionEvent
import java.awt.event.ComponentAdapter
import java.awt.event.ComponentEvent
import java.awt.geom.Point2D
import java.awt.image.BufferedImage
import java.nio.file.Path
import java.util.concurrent.Callable
import java.util.function.Consumer
import javax.accessibility.Accessible
import javax.accessibility.AccessibleAction
import javax.accessibility.AccessibleContext
import javax.accessibility.AccessibleRole
import javax.swing.Action
import javax.swing.JComponent
import kotlin.math.roundToInt
import org.joml.Vector3dc

/**
 * A component that shows a model, which users turn with the mouse or the keyboard. It needs no graphics driver: the
 * pictures are those of `zcli render`, bit for bit.
 *
 * ```
 * val view = ModelView().apply { open(Path.of("part.stl")) }
 * view.onPick = { println(it) }
 * frame.add(view)
 * ```
 *
 * In Java:
 *
 * ```java
 * ModelView view = new ModelView();
 * view.open(Path.of("part.stl"));
 * view.setOnPick(point -> System.out.println(point));
 * frame.add(view);
 * ```
 *
 * The left button turns the model, the right one, or the left one with Shift, moves it, and the wheel magnifies what is
 * under the pointer. A click selects the point under it, see [onPick]. What keys do are the [actions], which an
 * application can also put into a menu. A cut has a handle that can be dragged.
 *
 * Pictures are rendered in a thread of its own, at the resolution of the screen: with one sample a pixel, without soft
 * shadows and, for large models, without edges, as long as there is something new to show; and as the [settings] say
 * when nothing has changed for 120 milliseconds. A picture of the second kind is interrupted by the next. The arrays of
 * pixels are used again, so that a new picture takes no memory beyond what the library needs.
 *
 * Like other components, it is used by Swing's thread alone.
 */
public open class ModelView() :
    JComponent(),
    Accessible {
    private val worker = ViewWorker(::accept, ::refuse)
    private val controls = ViewControls(this)
    private var source: Source? = null
    private var shown: Shown? = null

    /** The camera, once the user has changed it; otherwise, the whole model is seen from [side], or as settings say. */
    private var orbit: Orbit? = null
    private var side: View? = null

    /** The cut that can be dragged, or null. */
    internal var cut: DraggedCut? = null
        private set

    /** The point that was selected last, or null. */
    public var selection: PickedPoint? = null
        private set

    /** Is told which point of the model a click selects, or null if it is the background. */
    public var onPick: Consumer<PickedPoint?>? = null

    /** What keys do, with names and keys. */
    public val actions: List<Action> get() = controls.actions

    /** Is told after each picture that has all its samples, and after a [failure]. */
    public var onRest: Runnable? = null

    /**
     * What is chosen about the pictures, as for `zcli render`. Size and region have no effect. What they choose about
     * the camera is for the first picture, and after [showWhole].
     */
    public var settings: PictureSettings = PictureSettings()
        set(value) {
            field = value
            request()
        }

    /** Shows [scene]. */
    public constructor(scene: Scene) : this() {
        show(LoadedScene(scene, emptyList()))
    }

    /** The model in the picture that is shown, or null before the first. */
    public val model: LoadedScene? get() = shown?.model

    /** Why there is no picture of the model that was to be shown, or null. */
    public var failure: String? = null
        private set

    init {
        isFocusable = true
        isOpaque = true
        background = Color.WHITE
        preferredSize = Dimension(PictureSettings.USUAL_SIZE.width, PictureSettings.USUAL_SIZE.height)
        controls.install()
        addComponentListener(
            object : ComponentAdapter() {
                override fun componentResized(event: ComponentEvent) = request()
            },
        )
    }

    /** Reads a file, in the background, and shows it. What is wrong with the file is shown as a text in its place. */
    public fun open(file: Path) {
        val format = settings[PictureParameters.FORMAT]
        val options = settings.loadOptions(LoadLimits())
        show("$file") { if (format == null) Scenes.load(file, options) else Scenes.load(file, format, options) }
    }

    /** Shows the whole of [model]. */
    public fun show(model: LoadedScene): Unit = show("the model") { model }

    /** Shows what [read] returns, which is called in the background. [name] is what it is called in messages. */
    public fun show(name: String, read: Callable<LoadedScene>) {
        orbit = null
        side = null
        cut = null
        selection = null
        source = Source(name, read)
        request()
    }

    /** Reads the model again, and shows it with the same camera and cut. */
    public fun reload() {
        source = source?.let { Source(it.name, it.read) }
        selection = null
        request()
    }

    /** Shows the whole model, as the [settings] say. */
    public fun showWhole(): Unit = see(null)

    /** Shows the whole model from [view]. */
    public fun showWhole(view: View): Unit = see(null, view)

    internal fun see(next: Orbit?, whole: View? = null) {
        orbit = next
        side = whole
        request()
    }

    internal fun cut(next: DraggedCut?) {
        // The camera stays where it is, and does not follow what remains
        orbit = orbit()
        cut = next
        request()
    }

    /**
     * What makes the picture that is shown when it rests, by `pictureSettings.frame(model)`: the [settings] with its
     * size, its camera and its cut. Null before the first picture.
     */
    public val pictureSettings: PictureSettings?
        get() = shown?.let { it.wish.settings.with(PictureParameters.SIZE, it.wish.size) }

    /** A copy of the picture that is shown, or null before the first. */
    public val picture: BufferedImage?
        get() = shown?.image?.let { image ->
            BufferedImage(image.width, image.height, image.type).also { it.raster.setRect(image.raster) }
        }

    /** Pixels of the screen for each unit of a component's size. */
    private val scale: Double get() = graphicsConfiguration?.defaultTransform?.scaleX ?: 1.0

    private fun request() {
        val from = source ?: return
        if (width <= 0 || height <= 0) return
        val pixels = ImageSize((width * scale).roundToInt(), (height * scale).roundToInt())
        val cuts = settings[PictureParameters.CUT].orEmpty() + listOfNotNull(cut?.plane)
        val look = settings.without(PictureParameters.REGION)
        val whole = side?.let { look.withViewpoint(null).seenFrom(it) } ?: look
        val cutUp = if (cuts.isEmpty()) whole else whole.with(PictureParameters.CUT, cuts)
        worker.request(Wish(from, orbit?.on(cutUp, checkNotNull(shown).up) ?: cutUp, pixels))
    }

    private fun accept(next: Shown): BufferedImage? {
        if (next.wish.source !== source) return next.image
        val before = shown?.image
        shown = next
        failure = null
        repaint()
        if (next.isFinal) {
            accessible.changed()
            onRest?.run()
        }
        return before.takeIf { it !== next.image }
    }

    private fun refuse(wish: Wish, message: String) {
        if (wish.source !== source) return
        failure = message
        repaint()
        accessible.changed()
        onRest?.run()
    }

    override fun removeNotify() {
        worker.stop()
        super.removeNotify()
    }

    override fun addNotify() {
        super.addNotify()
        request()
    }

    /** The camera that can be changed, or null if the scene has none. */
    internal fun orbit(): Orbit? = orbit ?: shown?.let { shown ->
        val center = shown.model.scene.bounds?.center
        if (center == null || shown.model.scene.isOnScreen) null else Orbit.of(shown.camera, shown.up.toWorld(center))
    }

    /** Selects what is at a place of the component. */
    internal fun pick(x: Int, y: Int) {
        val from = shown ?: return
        val column = (x * scale).toInt()
        val row = (y * scale).toInt()
        if (!from.frame.pixels.contains(column, row)) return
        selection = PickedPoint.of(from.frame, column, row)
        accessible.changed()
        repaint()
        onPick?.accept(selection)
    }

    /** Where a point of the model is in this component, or null if it cannot be seen. */
    internal fun place(point: Vector3dc): Point2D? {
        val from = shown ?: return null
        val pixel =
            from.camera.pixel(from.up.toWorld(point), from.wish.size.width, from.wish.size.height) ?: return null
        return Point2D.Double(pixel.x / scale, pixel.y / scale)
    }

    override fun paintComponent(graphics: Graphics) {
        val pen = graphics.create() as Graphics2D
        try {
            if (!isCovered()) {
                pen.color = background
                pen.fillRect(0, 0, width, height)
            }
            shown?.let { paintPicture(pen, it.image) }
            pen.setRenderingHint(RenderingHints.KEY_ANTIALIASING, RenderingHints.VALUE_ANTIALIAS_ON)
            cut?.let(controls::handle)?.let { pen.drawDot(it, HANDLE) }
            selection?.let { place(it.position) }?.let { pen.drawDot(it, SELECTION) }
            val text = failure ?: if (shown?.wish?.source === source) null else source?.let { "reading ${it.name} ..." }
            pen.font = font ?: pen.font
            text?.let { pen.drawLines(it, foreground ?: Color.BLACK, background) }
        } finally {
            pen.dispose()
        }
    }

    /** Whether nothing is seen behind the picture. */
    private fun isCovered(): Boolean = shown?.image.let { image ->
        image != null && image.transparency == Transparency.OPAQUE &&
            image.width >= width * scale && image.height >= height * scale
    }

    /** Draws pixel by pixel, whatever the scale of the screen is. */
    private fun paintPicture(pen: Graphics2D, image: BufferedImage) {
        val before = pen.transform
        pen.scale(1 / scale, 1 / scale)
        pen.drawImage(image, 0, 0, null)
        pen.transform = before
    }

    private val accessible by lazy { AccessibleView() }

    override fun getAccessibleContext(): AccessibleContext = accessible

    /** What is shown, in words. */
    internal fun description(): String {
        failure?.let { return it }
        val from = shown ?: return "no model"
        val side = Orbit.of(from.camera, from.camera.target)
        return listOfNotNull(
            from.wish.source.name,
            "seen from azimuth ${side.azimuth.roundToInt()}, elevation ${side.elevation.roundToInt()}",
            cut?.let { "cut at ${it.plane}" },
            selection?.let { "selected: $it" },
        ).joinToString("; ")
    }

    private inner class AccessibleView :
        AccessibleJComponent(),
        AccessibleAction {
        private var told = ""

        override fun getAccessibleRole() = AccessibleRole.CANVAS

        override fun getAccessibleName(): String = super.getAccessibleName() ?: "model"

        override fun getAccessibleDescription(): String = description()

        override fun getAccessibleAction() = this

        override fun getAccessibleActionCount(): Int = actions.size

        override fun getAccessibleActionDescription(number: Int): String? =
            actions.getOrNull(number)?.getValue(Action.NAME)?.toString()

        override fun doAccessibleAction(number: Int): Boolean {
            val action = actions.getOrNull(number) ?: return false
            action.actionPerformed(ActionEvent(this@ModelView, 0, null))
            return true
        }

        fun changed() {
            val before = told
            told = description()
            firePropertyChange(AccessibleContext.ACCESSIBLE_DESCRIPTION_PROPERTY, before, told)
        }
    }

    private companion object {
        private val HANDLE = Color(0xD0, 0x60, 0x00)
        private val SELECTION = Color(0x00, 0x60, 0xD0)
    }
}
