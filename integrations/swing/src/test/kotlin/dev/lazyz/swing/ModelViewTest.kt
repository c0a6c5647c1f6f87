package dev.lazyz.swing

import dev.lazyz.Region
import dev.lazyz.Rgba
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.Backdrop
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.camera.FittedViewpoint.View
import java.awt.GraphicsConfiguration
import java.awt.Rectangle
import java.awt.event.ActionEvent
import java.awt.event.ComponentEvent
import java.awt.event.InputEvent
import java.awt.event.MouseEvent
import java.awt.event.MouseWheelEvent
import java.awt.geom.AffineTransform
import java.awt.image.BufferedImage
import java.awt.image.ColorModel
import java.nio.file.Path
import java.util.concurrent.Semaphore
import java.util.concurrent.TimeUnit
import java.util.function.Consumer
import javax.accessibility.AccessibleContext
import javax.accessibility.AccessibleRole
import javax.swing.Action
import javax.swing.SwingUtilities
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The component without a window: events are sent to it, and it is painted on an image. */
class ModelViewTest {
    @TempDir
    lateinit var folder: Path

    private val car by lazy {
        folder.resolve("car.obj").apply {
            writeText(
                "v -2 -1 0\nv -0.1 -1 0\nv -1 1 0\nv 0.1 -1 0\nv 2 -1 0\nv 1 1 0\n" +
                    "o car\ng door\nf 1 2 3\ng wheel\nf 4 5 6\n",
            )
        }
    }

    @Test
    fun aPictureAtRestIsThatOfTheSettings() {
        val show = Show().apply { open(car) }
        assertEquals(pixels(PictureSettings(64, 48), Scenes.load(car)), show.pixels())
        show.settings(PictureSettings().with(PictureParameters.BACKGROUND, Backdrop(Rgba.TRANSPARENT)))
        assertEquals(0, show.pixels()[0])
        show.settings(PictureSettings().with(PictureParameters.REGION, Region(0, 0, 3, 3)))
        assertEquals(pixels(PictureSettings(64, 48), Scenes.load(car)), show.pixels())
    }

    @Test
    fun aSceneIsShown() {
        val show = Show(view = ModelView(Scenes.teapot(2)))
        show.size()
        val loaded = LoadedScene(Scenes.teapot(2), emptyList())
        assertEquals(pixels(PictureSettings(64, 48), loaded), show.pixels())
    }

    @Test
    fun draggingTurnsAndTheSettingsMakeTheSamePicture() {
        val show = Show().apply { open(car) }
        val before = show.pixels()
        show.drag(20, 20, 50, 10)
        assertNotEquals(before, show.pixels())
        assertTrue("azimuth 15, elevation 15" in show.view.accessibleContext.accessibleDescription)
        show.drag(20, 20, 30, 20, InputEvent.SHIFT_DOWN_MASK)
        show.wheel(10, 40, -3)
        val settings = checkNotNull(show.view.pictureSettings)
        assertEquals(show.pixels(), pixels(settings, Scenes.load(car)))
        assertTrue(settings.options.any { it.startsWith("--eye=") }, "${settings.options}")
        show.act("Whole model")
        assertEquals(before, show.pixels())
    }

    @Test
    fun keysShowSidesProjectionsAndEdges() {
        val show = Show().apply { open(car) }
        for (view in View.entries) {
            show.act("From ${view.name.lowercase()}")
            assertEquals(pixels(PictureSettings(64, 48).seenFrom(view), Scenes.load(car)), show.pixels(), "$view")
        }
        show.act("Whole model")
        val bare = show.pixels()
        show.act("Edges")
        assertNotEquals(bare, show.pixels())
        show.act("Edges")
        assertEquals(bare, show.pixels())
        show.act("Perspective or orthographic")
        assertNotNull(show.view.pictureSettings?.get(PictureParameters.HEIGHT))
        for (name in listOf("Turn left", "Turn up", "Move right", "Move down", "Larger")) {
            val last = show.pixels()
            show.act(name)
            assertNotEquals(last, show.pixels(), name)
        }
    }

    @Test
    fun aClickSelectsAPoint() {
        val show = Show().apply { open(car) }
        show.act("From front")
        val picked = ArrayList<PickedPoint?>()
        swing { show.view.onPick = Consumer { picked += it } }
        show.click(20, 30)
        show.click(44, 30)
        show.click(1, 1)
        assertEquals(listOf("car/door", "car/wheel", null), picked.map { it?.seen?.part })
        assertEquals(listOf(0, 1), picked.take(2).map { it?.seen?.surface })
        assertEquals(0.0, checkNotNull(picked[0]).position.z(), 1e-6)
        assertEquals(-1.0, checkNotNull(picked[0]).position.x(), 0.3)
        assertNull(show.view.selection)
    }

    @Test
    fun theHandleOfACutCanBeDragged() {
        val show = Show().apply { show(LoadedScene(Scenes.teapot(2), emptyList())) }
        show.act("From front")
        val whole = show.pixels()
        show.act("Cut")
        assertEquals("[x=50.0%]", "${show.view.pictureSettings?.get(PictureParameters.CUT)}")
        val half = show.pixels()
        assertNotEquals(whole, half)

        // The handle is in the middle of the model; a quarter of its width to the left
        val handle = checkNotNull(swing { show.view.place(checkNotNull(show.view.model?.scene?.bounds).center) })
        show.drag(handle.x.toInt(), handle.y.toInt(), handle.x.toInt() - 12, handle.y.toInt())
        val cut = "${show.view.pictureSettings?.get(PictureParameters.CUT)}".substringAfter('=').substringBefore('%')
        assertTrue(cut.toDouble() in 15.0..40.0, cut)
        show.act("Cut from the other side")
        assertTrue("${show.view.pictureSettings?.get(PictureParameters.CUT)}".startsWith("[-x="))
        repeat(3) { show.act("Cut") }
        show.act("From front")
        assertEquals(whole, show.pixels())
    }

    @Test
    fun whatIsWrongWithAFileIsShown() {
        val show = Show().apply { open(folder.resolve("none.obj")) }
        assertTrue("none.obj" in checkNotNull(show.view.failure))
        assertEquals(show.view.failure, show.view.accessibleContext.accessibleDescription)
        show.open(car)
        assertNull(show.view.failure)
        val before = show.pixels()
        show.act("Turn left")
        val turned = show.pixels()
        car.writeText(car.toFile().readText().replace("v 1 1 0", "v 1 3 0"))
        show.after { reload() }
        assertNotEquals(turned, show.pixels())
        assertTrue("azimuth 15" in show.view.accessibleContext.accessibleDescription)
        assertNotEquals(before, show.pixels())
    }

    /** The axis that points up is not known before a file is read. */
    @Test
    fun aFileWithZUpIsReadAgainForTheSameCamera() {
        val wedge = folder.resolve("wedge.stl")
        val corners = listOf("0 0 0", "4 0 0", "0 2 0", "0 0 1")
        val faces = listOf(listOf(0, 2, 1), listOf(0, 1, 3), listOf(0, 3, 2), listOf(1, 2, 3))
        val facets = faces.joinToString("") { face ->
            "facet normal 0 0 0\nouter loop\n" + face.joinToString("") { "vertex ${corners[it]}\n" } +
                "endloop\nendfacet\n"
        }
        wedge.writeText("solid wedge\n${facets}endsolid wedge\n")
        val show = Show().apply { open(wedge) }
        show.act("Turn left")
        val turned = show.pixels()
        show.after { reload() }
        assertTrue(turned == show.pixels())
    }

    @Test
    fun picturesHaveThePixelsOfTheScreen() {
        val show = Show(scale = 2.0).apply { open(car) }
        assertEquals(128, show.view.picture?.width)
        assertEquals(96, show.view.picture?.height)
        val painted = BufferedImage(128, 96, BufferedImage.TYPE_INT_RGB)
        swing { show.view.paint(painted.createGraphics().apply { scale(2.0, 2.0) }) }
        assertEquals(pixels(PictureSettings(128, 96), Scenes.load(car)), rgb(painted))
        show.act("From front")
        show.click(20, 30)
        assertEquals("car/door", show.view.selection?.seen?.part)
    }

    @Test
    fun screenReadersKnowIt() {
        val show = Show().apply { open(car) }
        val context = show.view.accessibleContext
        assertEquals(AccessibleRole.CANVAS, context.accessibleRole)
        assertTrue(show.view.isFocusable)
        val told = ArrayList<Any?>()
        context.addPropertyChangeListener {
            if (it.propertyName == AccessibleContext.ACCESSIBLE_DESCRIPTION_PROPERTY) told += it.newValue
        }
        val names = List(context.accessibleAction.accessibleActionCount) {
            context.accessibleAction.getAccessibleActionDescription(it)
        }
        assertTrue("Turn left" in names)
        show.after { assertTrue(context.accessibleAction.doAccessibleAction(names.indexOf("Turn left"))) }
        assertTrue("azimuth 15, elevation 20" in "${told.last()}", "$told")
        assertFalse(context.accessibleAction.doAccessibleAction(names.size))
    }

    private fun pixels(settings: PictureSettings, model: LoadedScene): List<Int> =
        settings.frame(model).render(TiledRenderer()).argb.toList()

    /** A view of 64 x 48 units that is on no screen. */
    private class Show(private val scale: Double = 1.0, view: ModelView? = null) {
        private val rest = Semaphore(0)
        val view: ModelView = view ?: object : ModelView() {
            override fun getGraphicsConfiguration(): GraphicsConfiguration? = Screen(scale)
        }

        init {
            swing { this.view.onRest = Runnable { rest.release() } }
            if (view == null) size(false)
        }

        fun size(isAwaited: Boolean = true) {
            swing {
                view.setSize(64, 48)
                view.dispatchEvent(ComponentEvent(view, ComponentEvent.COMPONENT_RESIZED))
            }
            if (isAwaited) await()
        }

        /** Waits for the picture at rest that comes after [action]. */
        fun after(action: ModelView.() -> Unit) {
            rest.drainPermits()
            swing { view.action() }
            await()
        }

        private fun await() = assertTrue(rest.tryAcquire(10, TimeUnit.MINUTES), "no picture")

        fun open(file: Path) = after { open(file) }

        fun show(model: LoadedScene) = after { show(model) }

        fun settings(settings: PictureSettings) = after { this.settings = settings }

        fun act(name: String) = after {
            actions.single { it.getValue(Action.NAME) == name }
                .actionPerformed(ActionEvent(this, 0, null))
        }

        fun drag(x: Int, y: Int, toX: Int, toY: Int, modifiers: Int = 0) = after {
            mouse(MouseEvent.MOUSE_PRESSED, x, y, modifiers)
            mouse(MouseEvent.MOUSE_DRAGGED, toX, toY, modifiers)
            mouse(MouseEvent.MOUSE_RELEASED, toX, toY, modifiers)
        }

        fun click(x: Int, y: Int) = swing {
            mouse(MouseEvent.MOUSE_PRESSED, x, y, 0)
            mouse(MouseEvent.MOUSE_RELEASED, x, y, 0)
        }

        private fun mouse(id: Int, x: Int, y: Int, modifiers: Int) = view.dispatchEvent(
            MouseEvent(view, id, 0, modifiers or InputEvent.BUTTON1_DOWN_MASK, x, y, 1, false, MouseEvent.BUTTON1),
        )

        fun wheel(x: Int, y: Int, steps: Int) = after {
            dispatchEvent(
                MouseWheelEvent(
                    this, MouseEvent.MOUSE_WHEEL, 0, 0, x, y, 0, false, MouseWheelEvent.WHEEL_UNIT_SCROLL, 1, steps,
                ),
            )
        }

        fun pixels(): List<Int> = swing {
            val picture = checkNotNull(view.picture)
            picture.getRGB(0, 0, picture.width, picture.height, null, 0, picture.width).toList()
        }
    }

    private companion object {
        fun rgb(image: BufferedImage): List<Int> =
            image.getRGB(0, 0, image.width, image.height, null, 0, image.width).toList()

        /** Returns what [action] returns, called by Swing's thread. */
        fun <T> swing(action: () -> T): T {
            var result: Result<T>? = null
            SwingUtilities.invokeAndWait { result = runCatching(action) }
            return checkNotNull(result).getOrThrow()
        }
    }

    /** A screen with so many pixels for each unit. */
    private class Screen(private val scale: Double) : GraphicsConfiguration() {
        override fun getDevice() = throw UnsupportedOperationException()

        override fun getColorModel(): ColorModel = ColorModel.getRGBdefault()

        override fun getColorModel(transparency: Int) = colorModel

        override fun getDefaultTransform(): AffineTransform = AffineTransform.getScaleInstance(scale, scale)

        override fun getNormalizingTransform() = AffineTransform()

        override fun getBounds() = Rectangle(0, 0, 64, 48)
    }
}
