package dev.lazyz.drawing

import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.drawing.EdgeDrawing.DrawnLine
import dev.lazyz.drawing.EdgeDrawing.LineKind
import dev.lazyz.drawing.EdgeStyle.EdgeSet
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.sections.Section
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Lines as vectors are those that the raster shows. */
class DrawnLineTest {
    private val plain = Material(shading = Shading.CONSTANT)
    private val up = Vector3d(0.0, 1.0, 0.0)
    private val orthographic = Camera.orthographic(Vector3d(3.0, 2.0, 6.0), Vector3d(), up, 4.0, 1.0, 20.0)
    private val perspective = Camera.perspective(Vector3d(3.0, 2.0, 6.0), Vector3d(), up, 35.0, 1.0, 20.0)
    private val pixels = Raster(160, 120)
    private val bars =
        listOf(Solids.box(-1f, -0.7f, -0.4f, 1f, 0.7f, 0.4f), Solids.box(-0.3f, -1.5f, -0.9f, 0.3f, 1.5f, 2f))
    private val bodies: List<List<Mesh>> =
        listOf(bars, listOf(Solids.torus(1.0, 0.4, 24, 12)), listOf(Solids.cube(), Solids.sphere(20, 10)))
            .map { all -> all.map { it.withMaterials { plain } } }

    private fun drawing(surfaces: List<Surface>, style: EdgeStyle = EdgeStyle()) = EdgeDrawing(surfaces, style)

    private fun kinds(surfaces: List<Surface>, style: EdgeStyle = EdgeStyle()) =
        drawing(surfaces, style).lines(pixels, orthographic).map { it.kind }.toSet()

    /** The distance of the middle of a pixel from the nearest of [lines], pixels; of some that are far, infinity. */
    private fun distances(lines: List<DrawnLine>): DoubleArray {
        val nearest = DoubleArray(pixels.width * pixels.height) { Double.POSITIVE_INFINITY }
        for (line in lines) {
            val p = line.points
            for (i in 2 until p.size step 2) {
                val x = p[i] - p[i - 2]
                val y = p[i + 1] - p[i - 1]
                for (row in around(p[i - 1], p[i + 1], pixels.height)) {
                    for (column in around(p[i - 2], p[i], pixels.width)) {
                        val toX = column + 0.5 - p[i - 2]
                        val toY = row + 0.5 - p[i - 1]
                        val square = x * x + y * y
                        val t = if (square == 0.0) 0.0 else ((toX * x + toY * y) / square).coerceIn(0.0, 1.0)
                        val pixel = row * pixels.width + column
                        nearest[pixel] = minOf(nearest[pixel], StrictMath.hypot(toX - t * x, toY - t * y))
                    }
                }
            }
        }
        return nearest
    }

    private fun around(from: Double, until: Double, size: Int): IntRange =
        maxOf(0, minOf(from, until).toInt() - 3)..minOf(size - 1, maxOf(from, until).toInt() + 3)

    @Test
    fun rule_10_2_linesAgreeWithTheirRasterToHalfAPixel() {
        for ((number, body) in bodies.withIndex()) {
            for (camera in listOf(orthographic, perspective)) {
                val style = EdgeStyle(width = 3.0, hidden = HiddenLines.SOLID)
                val image = ZBufferRenderer().render(
                    style.drawnOn(Scene(body, viewpoint = camera)).frame(pixels.width, pixels.height),
                )
                val lines = drawing(body, style).lines(pixels, camera)
                val visible = distances(lines.filter { !it.isHidden })
                val hidden = distances(lines.filter { it.isHidden })
                val thin = style.width * EdgeStyle.HIDDEN_SHARE
                for (i in visible.indices) {
                    val color = image.argb[i]
                    val isBlack = color == Rgba.BLACK.toArgb()
                    val isGrey = color == EdgeStyle.HIDDEN_GREY.toArgb()
                    val place = "(${i % pixels.width}, ${i / pixels.width}) of body $number, $camera"
                    if (isBlack) assertTrue(visible[i] <= style.width / 2 + 0.5) { "black at $place" }
                    if (isGrey) assertTrue(hidden[i] <= thin / 2 + 0.5) { "grey at $place" }
                    if (visible[i] <= style.width / 2 - 0.5) assertTrue(isBlack) { "not black at $place" }
                    if (hidden[i] <= thin / 2 - 0.5) assertTrue(isGrey || isBlack) { "not grey at $place" }
                }
            }
        }
    }

    @Test
    fun linesHaveTheKindOfTheirEdges() {
        assertEquals(setOf(LineKind.OUTLINE), kinds(listOf(Solids.sphere(20, 10))))
        assertEquals(setOf(LineKind.CREASE), kinds(listOf(Solids.cube())))
        val flat = Mesh(floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f), intArrayOf(0, 1, 2))
        assertEquals(setOf(LineKind.BOUNDARY), kinds(listOf(flat)))
        val corners = listOf(Vertex(0.0, 0.0, 0.0), Vertex(1.0, 0.0, 0.0), Vertex(0.0, 1.0, 0.0))
        assertEquals(setOf(LineKind.BOUNDARY), kinds(listOf(Polygon(listOf(corners)))))
        val all = kinds(listOf(Solids.sphere(20, 10)), EdgeStyle(EdgeSet.ALL))
        assertEquals(setOf(LineKind.OUTLINE, LineKind.FACET), all)

        val cut = Section(listOf(Section.Plane.x(0.2))).of(Scene(listOf(Solids.cube()))).scene.surfaces
        val lines = drawing(cut).lines(pixels, orthographic)
        assertEquals(setOf(LineKind.SECTION, LineKind.CREASE), lines.map { it.kind }.toSet())
        val section = lines.single { it.kind == LineKind.SECTION }.points
        assertEquals(18, section.size, "a closed square, whose sides cross diagonals of faces")
        assertEquals(section.take(2), section.takeLast(2))
    }

    @Test
    fun hiddenLinesAreThereIfTheyAreDrawn() {
        val visible = drawing(bars).lines(pixels, perspective)
        assertTrue(visible.none { it.isHidden })
        val both = drawing(bars, EdgeStyle(hidden = HiddenLines.DASHED)).lines(pixels, perspective)
        assertTrue(both.any { it.isHidden })
        val same = both.filter { !it.isHidden }
        assertEquals(visible.size, same.size)
        for ((first, second) in visible.zip(same)) assertArrayEquals(first.points, second.points)
    }

    /** The cap of x = 0.2 shows its front to a camera on the right. */
    @Test
    fun rule_10_4_capsShowTheirFrontOrNothing() {
        val hatching = Hatching(0.25, 0.2, Rgba.BLACK, Rgba.WHITE)
        val section = Section(listOf(Section.Plane.x(0.2))) { hatching.material() }
        val cut = section.of(Scene(listOf(Solids.cube()))).scene.surfaces
        assertEquals(listOf(false, true), cut.map { it is Polygon && it.isCap })
        val left = Camera.orthographic(Vector3d(-3.0, 2.0, 6.0), Vector3d(), up, 4.0, 1.0, 20.0)
        assertEquals(0, drawing(cut).caps(pixels, left).size)

        // Seen along x, 30 pixels are a unit: the square has 60 x 60 of them. Along y + z, it has 4 units
        val right = Camera.orthographic(Vector3d(6.0, 0.0, 0.0), Vector3d(), up, 4.0, 1.0, 20.0)
        val cap = drawing(cut).caps(pixels, right).single()
        val square = cap.contours.single()
        assertEquals(
            listOf(50.0, 110.0, 30.0, 90.0),
            listOf(0, 1).flatMap { k ->
                val places = square.filterIndexed { i, _ -> i % 2 == k }
                listOf(places.min(), places.max())
            }
        )
        assertEquals(16, cap.stripes.size)

        // At the borders of a stripe, x + y + z is a whole number of periods, or a fifth more
        for (stripe in cap.stripes) {
            for (i in stripe.indices step 2) {
                val place = (0.2 + (60 - stripe[i + 1]) / 30 + (80 - stripe[i]) / 30) / 0.25
                assertEquals(0.1, place - StrictMath.floor(place + 1e-6), 0.1 + 1e-6)
            }
        }

        // So far away, the next whole number is the same one
        val surface = cut.filterIsInstance<Polygon>().single()
        val far = CapView(ViewSpace(pixels, right), Vector3d(-1e18, 0.0, 0.0)).of(surface)
        assertEquals(0, checkNotNull(far).stripes.size)
        Thread.currentThread().interrupt()
        assertThrows(InterruptedException::class.java) { drawing(cut).caps(pixels, right) }
    }
}
