package dev.lazyz.scenes.pictures

import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.filter.PixelBackground.VerticalGradient
import dev.lazyz.scenes.ImageSize
import dev.lazyz.scenes.LengthUnit
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.FittedViewpoint.View
import dev.lazyz.world.surface.Mesh
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.Base64
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.readText
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.w3c.dom.Element

/** SVG files of [PictureSettings.drawing]. */
class PictureDrawingTest {
    @TempDir
    lateinit var folder: Path

    private val flange = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .map { it.resolve("docs/images/flange.obj") }.first { Files.exists(it) }.let { Scenes.load(it) }
    private val technical = PictureSettings(160, 120).with(PictureParameters.STYLE, PictureStyle.TECHNICAL)
    private val wedge = LoadedScene(
        Scene(
            listOf(
                Mesh(
                    floatArrayOf(0f, 0f, 0f, 4f, 0f, 0f, 0f, 2f, 0f, 0f, 0f, 1f),
                    intArrayOf(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
                ),
            ),
        ),
        emptyList(),
    )

    private fun svg(settings: PictureSettings, loaded: LoadedScene = wedge): String {
        val output = ByteArrayOutputStream()
        settings.drawing(loaded).writeSvg(output)
        return output.toString()
    }

    private fun root(svg: String): Element = DocumentBuilderFactory.newDefaultNSInstance().newDocumentBuilder()
        .parse(ByteArrayInputStream(svg.toByteArray())).documentElement

    /** Paths with a class that contains [name]. */
    private fun paths(svg: String, name: String): List<Element> {
        val all = root(svg).getElementsByTagName("path")
        return List(all.length) { all.item(it) as Element }.filter { name in it.getAttribute("class").split(" ") }
    }

    @Test
    fun aDrawingHasTheseBytes() {
        val settings = technical.with(PictureParameters.VIEW, View.FRONT)
            .with(PictureParameters.HIDDEN_LINES, HiddenLines.DASHED)
            .with(PictureParameters.EDGE_COLOR, Rgba.ofRgb(0x102030))
        val spaces = "xmlns=\"http://www.w3.org/2000/svg\" xmlns:xlink=\"http://www.w3.org/1999/xlink\""
        val round = "stroke-linecap:round;stroke-linejoin:round"
        val expected = """
            <svg $spaces width="160" height="120" viewBox="0 0 160 120">
            <style>
            .background{fill:#ffffff}
            .section,.boundary,.crease,.outline,.facet{fill:none;stroke:#102030;stroke-width:.75;$round}
            .hidden{stroke:#a0a0a0;stroke-width:.45;stroke-dasharray:3.75 2.625}
            </style>
            <rect class="background" x="0" y="0" width="160" height="120"/>
            <path class="crease hidden" d="
            M8 96l0 -72
            M8 96l144 0
            M8 96h0"/>
            <path class="crease" d="
            M152 96l-144 -72 0 72z"/>
            </svg>
        """.trimIndent() + "\n"
        assertEquals(expected, svg(settings))
        val path = folder.resolve("wedge.svg")
        assertNull(settings.drawing(wedge, RenderOptions(threads = 1)).writeSvg(path))
        assertEquals(expected, path.readText())
    }

    @Test
    fun aCutHasItsCapBelowItsLines() {
        val cut = technical.with(PictureParameters.VIEW, View.FRONT)
            .with(PictureParameters.CUT, listOf(checkNotNull(CutPlane.parse("z=0.5"))))
        val (cap, hatch, rest) = svg(cut).substringAfter("<path class=\"cap\" d=\"\n")
            .split(Regex("<path class=\"(hatch|section)\" d=\"\n"))
        assertEquals("M80 96l-72 -36 0 36z\"/>\n", cap)
        val stripes = hatch.lines()
        assertEquals(listOf("M8 95.28l0 .72 .72 0z", "M8 91.68l0 .72 3.6 3.6 .72 0z"), stripes.take(2))
        assertEquals("M74.24 93.12l-1.44 -.72 3.6 3.6 .72 0z\"/>" to 21, stripes[19] to stripes.size)
        val edges = "M8 96h0\nM8 96l72 0\nM80 96l72 0 -144 -72 0 36\"/>\n</svg>\n"
        assertEquals("M80 96l-72 0 0 -36z\"/>\n<path class=\"crease\" d=\"\n$edges", rest)
    }

    @Test
    fun lengthsOnPaperHaveTheUnitOfTheModel() {
        val front = technical.with(PictureParameters.VIEW, View.FRONT)
        fun sides(settings: PictureSettings, loaded: LoadedScene = wedge) =
            root(svg(settings, loaded)).let { it.getAttribute("width") to it.getAttribute("height") }
        assertEquals("160" to "120", sides(front))

        // The wedge is 4 units wide, in 144 of 160 pixels
        val half = front.with(PictureParameters.SCALE, DrawingScale(1.0, 2.0))
        assertEquals("2.222mm" to "1.667mm", sides(half))
        assertEquals("22.222mm" to "16.667mm", sides(half.with(PictureParameters.UNIT, LengthUnit.CENTIMETRE)))
        val inches = LoadedScene(wedge.scene, emptyList(), unit = LengthUnit.INCH)
        assertEquals("112.889mm" to "84.667mm", sides(front.withWord(PictureParameters.SCALE, "1:1"), inches))
        assertEquals("4.444mm" to "3.333mm", sides(half.withWord(PictureParameters.SCALE, "1:1"), wedge))
    }

    @Test
    fun whatHasNoLinesOrNoScaleIsNoDrawing() {
        fun refusal(settings: PictureSettings, loaded: LoadedScene = wedge) =
            assertThrows(NoPictureException::class.java) { settings.drawing(loaded) }.message.orEmpty()
        val none = refusal(PictureSettings())
        assertEquals("there are no lines to draw: add edges, wireframe or style=technical", none)
        val scaled = technical.withWord(PictureParameters.SCALE, "1:2")
        val perspective = refusal(scaled.with(PictureParameters.PROJECTION, Fit.PERSPECTIVE))
        val hint = "under perspective, lengths have no scale; use projection=orthographic"
        assertEquals("scale=1:2: $hint", perspective)
        assertTrue("the paper would be" in refusal(technical.withWord(PictureParameters.SCALE, "1e9:1")))
        assertTrue("the paper would be" in refusal(technical.withWord(PictureParameters.SCALE, "1:1e9")))
        val unit = technical.with(PictureParameters.UNIT, LengthUnit.INCH)
        assertEquals("unit needs scale", refusal(unit))
        val screen = LoadedScene(wedge.scene.withViewpoint(Camera.screen(0.0, 9.0)), emptyList())
        assertTrue("on the screen" in refusal(scaled, screen))
    }

    /** A shaded picture is below the lines, the same as without lines; a technical drawing on white paper has none. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun thePictureWithoutLinesIsBelow() {
        val shaded = PictureSettings(40, 30).with(PictureParameters.EDGES, true)
        val image = root(svg(shaded)).getElementsByTagName("image").item(0) as Element
        val png = Base64.getDecoder().decode(image.getAttribute("xlink:href").substringAfter(','))
        val below = Picture.decode(png)
        val plain = PictureSettings(40, 30).frame(wedge).render(TiledRenderer())
        for (i in plain.argb.indices) assertEquals(Picture.of(plain).color(i % 40, i / 40), below.color(i % 40, i / 40))

        fun parts(settings: PictureSettings, loaded: LoadedScene = flange): List<String> {
            val root = root(svg(settings.with(PictureParameters.SIZE, ImageSize(40, 30)), loaded))
            return listOf("image", "rect").filter { root.getElementsByTagName(it).length > 0 } +
                listOf("cap", "hatch").filter { paths(svg(settings, loaded), it).isNotEmpty() }
        }
        val cut = technical.with(PictureParameters.CUT, listOf(checkNotNull(CutPlane.parse("z=0"))))
        assertEquals(listOf("rect"), parts(technical))
        assertEquals(listOf("rect", "cap", "hatch"), parts(cut))
        assertEquals(listOf("rect", "cap"), parts(cut.with(PictureParameters.CAP_COLOR, Rgba.ofRgb(0xFF0000))))
        assertEquals(listOf("cap", "hatch"), parts(cut.with(PictureParameters.BACKGROUND, Backdrop(Rgba.TRANSPARENT))))
        val blue = Backdrop(Rgba.ofRgb(0xFF))
        assertEquals(listOf("image"), parts(cut.with(PictureParameters.BACKGROUND, blue)))
        val gradient = Backdrop(VerticalGradient(Rgba.WHITE, Rgba.BLACK))
        assertEquals(listOf("image"), parts(technical.with(PictureParameters.BACKGROUND, gradient)))
        assertEquals(listOf("image"), parts(technical.with(PictureParameters.COLOR, Rgba.ofRgb(0xFF0000))))
        assertEquals(listOf("image"), parts(technical.with(PictureParameters.GROUND_SHADOW, true)))
        assertEquals(listOf("image"), parts(technical.with(PictureParameters.EXPOSURE, 1.0)))
    }

    @Test
    fun aRegionHasItsOwnLines() {
        val corner = technical.with(PictureParameters.VIEW, View.FRONT)
            .with(PictureParameters.REGION, Region(0, 0, 100, 40))
        val root = root(svg(corner))
        assertEquals("0 0 100 40", root.getAttribute("viewBox"))
        assertEquals("100", root.getAttribute("width"))
        assertEquals(1, paths(svg(corner), "crease").size)
        val empty = corner.with(PictureParameters.REGION, Region(140, 0, 160, 20)).drawing(wedge)
        assertEquals(Blank.BACKGROUND, empty.writeSvg(ByteArrayOutputStream()))
    }

    @Test
    fun anEmptyDrawingIsAFile() {
        val nothing = LoadedScene(Scene(emptyList()), emptyList())
        assertEquals(Blank.BACKGROUND, technical.drawing(nothing).writeSvg(ByteArrayOutputStream()))
        assertEquals(0, paths(svg(technical, nothing), "crease").size)
        val shaded = PictureSettings(20, 20).with(PictureParameters.EDGES, true)
        assertEquals(Blank.BACKGROUND, shaded.drawing(nothing).writeSvg(ByteArrayOutputStream()))
    }

    /** Numbers of coordinates stay those of the picture, whatever the model has. */
    @Test
    fun numbersThatAreHugeOrNoneAreLeftOut() {
        val p = floatArrayOf(0f, 0f, 0f, 4f, 0f, 0f, 0f, 2f, 0f, 0f, 0f, 1f, Float.NaN, 0f, 0f, 1e30f, 1e30f, 0f)
        val mesh = Mesh(p, intArrayOf(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3, 0, 1, 4, 1, 2, 5))
        val near = technical.with(PictureParameters.EYE, Vector3d(1.0, 1.0, 9.0)).with(PictureParameters.HEIGHT, 3.0)
        val svg = svg(near, LoadedScene(Scene(listOf(mesh)), emptyList()))
        assertTrue(paths(svg, "crease").isNotEmpty() || paths(svg, "boundary").isNotEmpty())
        val numbers = Regex("-?[0-9]*\\.?[0-9]+").findAll(svg.substringAfter("<path")).map { it.value.toDouble() }
        assertTrue(numbers.all { StrictMath.abs(it) < 400 }) { svg }
    }

    @Test
    fun aWireframeHasAllKindsOfEdges() {
        val wire = PictureSettings(60, 50).with(PictureParameters.WIREFRAME, true)
        assertTrue(paths(svg(wire, flange), "facet").isNotEmpty())
        assertTrue(paths(svg(PictureSettings(60, 50).with(PictureParameters.EDGES, true), flange), "facet").isEmpty())
    }
}
