package dev.lazyz.drawing

import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.SampleScenes
import dev.lazyz.drawing.EdgeStyle.EdgeSet
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.filter.SuperSampling
import dev.lazyz.setup.setUp
import dev.lazyz.shared.ProcessorTime
import dev.lazyz.strategies.Renderers
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

/** Visible edges are drawn, hidden ones are not, and all strategies draw the same. */
class EdgeDrawingTest {
    private val plain = Material(shading = Shading.CONSTANT)

    /** Looks along -z: x and y in -2..2 are 100 columns and rows. */
    private val front = Camera.orthographic(
        Vector3d(0.0, 0.0, 10.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 20.0,
    )

    private fun render(surfaces: List<Surface>, style: EdgeStyle, camera: Camera = front, side: Int = 100): Image =
        ZBufferRenderer().render(style.drawnOn(Scene(surfaces, viewpoint = camera)).frame(side, side))

    private fun Image.isBlack(x: Int, y: Int) = argb[y * width + x] == Rgba.BLACK.toArgb()

    /** The columns of row [y] that are black, as ranges. */
    private fun Image.blackColumns(y: Int): List<IntRange> {
        val ranges = ArrayList<IntRange>()
        for (x in (0 until width).filter { isBlack(it, y) }) {
            if (ranges.lastOrNull()?.last == x - 1) ranges[ranges.size - 1] = ranges.last().first..x else ranges += x..x
        }
        return ranges
    }

    private fun square(x0: Float, y0: Float, x1: Float, y1: Float, z: Float): Mesh =
        Mesh(floatArrayOf(x0, y0, z, x1, y0, z, x1, y1, z, x0, y1, z), intArrayOf(0, 1, 2, 0, 2, 3), plain)

    /** A closed solid hides its own back, whether its material is drawn from both sides or not. */
    @Test
    fun rule_10_2_hiddenEdgesOfOneSidedSolidsAreDrawn() {
        val camera = Camera.fit(30.0, 20.0, kind = Fit.ORTHOGRAPHIC)
        for (hidden in HiddenLines.entries) {
            val (both, front) = Sides.entries.map { sides ->
                val scene = Scene(listOf(Solids.cube(plain.withSides(sides))), viewpoint = camera)
                ZBufferRenderer().render(EdgeStyle(hidden = hidden).drawnOn(scene).frame(100, 100))
            }
            assertArrayEquals(both.argb, front.argb) { "$hidden" }
        }
    }

    /** Clockwise, with one side: it shows its back, so neither it nor its outline is drawn, and it hides nothing. */
    @Test
    fun rule_10_2_polygonsThatAreNotDrawnHaveNoEdgesAndHideNothing() {
        val oneSided = plain.withSides(Sides.FRONT)
        val contour = listOf(Vertex(-1.0, -1.0, 1.0), Vertex(-1.0, 1.0, 1.0), Vertex(1.0, 1.0, 1.0))
        val behind = square(-1.8f, -1.5f, 1.8f, 0.02f, -1f)
        val alone = render(listOf(behind), EdgeStyle())
        val broken = contour + Vertex(0.0, Double.NaN, 1.0) + Vertex(1.0, -1.0, 1.0)
        for (polygon in listOf(Polygon(listOf(contour), oneSided), Polygon(listOf(broken), plain))) {
            assertEquals(0, render(listOf(polygon), EdgeStyle()).visible) { "$polygon" }
            assertArrayEquals(alone.argb, render(listOf(behind, polygon), EdgeStyle()).argb) { "$polygon" }
        }

        // From the front it is drawn, and hides
        val shown = Polygon(listOf(contour.reversed()), oneSided)
        assertTrue(render(listOf(shown), EdgeStyle()).isBlack(49, 50))
        assertEquals(listOf(4..24), render(listOf(behind, shown), EdgeStyle()).blackColumns(49).take(1))
    }

    @Test
    fun rule_10_2_anEdgeOfThreeTrianglesIsDrawnIfOneOfThemIs() {
        val positions = floatArrayOf(0.02f, -1f, 0f, 0.02f, 1f, 0f, 1f, 0f, 0f, 1f, 0.3f, -1f, 0.9f, 0.1f, -2f)
        val backs = intArrayOf(0, 1, 2, 0, 1, 3, 0, 1, 4)
        val oneSided = plain.withSides(Sides.FRONT)
        assertEquals(0, render(listOf(Mesh(positions, backs, oneSided)), EdgeStyle()).visible)
        for (front in 0 until 3) {
            val triangles = backs.copyOf()
            triangles[3 * front] = 1
            triangles[3 * front + 1] = 0
            assertTrue(render(listOf(Mesh(positions, triangles, oneSided)), EdgeStyle()).isBlack(50, 30)) { "$front" }
        }
    }

    @Test
    fun rule_10_2_aLineEndsWhereItsMiddleGoesBehindAnOutline() {
        val back = square(-1.8f, -1.5f, 1.8f, 0.02f, -1f)
        val front = square(-0.5f, -1f, 0.52f, 1f, 0f)
        val image = render(listOf(back, front), EdgeStyle(width = 3.0))

        // The upper side of the one behind is in row 49, columns 5 to 95; the other one is in columns 37.5 to 63
        assertEquals(listOf(3..38, 61..95), image.blackColumns(49))
        val hidden =
            render(listOf(back, front), EdgeStyle(width = 3.0, hidden = HiddenLines.SOLID, hiddenColor = Rgba.BLACK))
        assertEquals(listOf(3..95), hidden.blackColumns(49))
        val dashed = render(listOf(back, front), EdgeStyle(hidden = HiddenLines.DASHED, hiddenColor = Rgba.BLACK))

        // Three dashes, of which two continue the visible parts
        assertEquals(listOf(4..43, 47..53, 57..94), dashed.blackColumns(49))
    }

    @Test
    fun rule_10_2_aLineBehindTooManyFacesIsLeftOut() {
        // The line is in columns 5 to 95 of row 49; two squares hide it, in columns 25 to 50 and 37.5 to 63
        val back = square(-1.8f, -1.5f, 1.8f, 0.02f, -1f)
        val fronts = listOf(square(-0.5f, -1f, 0.52f, 1f, 0f), square(-1f, -0.8f, 0f, 0.8f, 0.5f))
        val style = EdgeStyle(hidden = HiddenLines.SOLID, hiddenColor = Rgba.BLACK)
        val all = render(fronts + back, style)
        assertEquals(listOf(4..94), all.blackColumns(49))
        assertEquals(all, render(fronts + back, style.withHiddenBehind(2)))
        val one = render(fronts + back, style.withHiddenBehind(1))
        assertEquals(listOf(4..37, 49..94), one.blackColumns(49))

        // One triangle of a wall hides all of the line, and the squares count nevertheless
        val walled = render(fronts + back + square(-20f, -1.9f, 20f, 40f, 0.2f), style.withHiddenBehind(1))
        val columns = walled.blackColumns(49)
        for (column in listOf(10, 80)) assertTrue(columns.any { column in it }) { "$columns" }
        for (column in listOf(30, 44, 56)) assertTrue(columns.none { column in it }) { "$columns" }

        // Neighbours on a fine mesh do not count twice, and leave no crumbs
        val fine = fronts.map { it.divided(11) }
        assertArrayEquals(one.argb, render(fine + back, style.withHiddenBehind(1)).argb)
        assertArrayEquals(all.argb, render(fine + back, style.withHiddenBehind(2)).argb)
    }

    /** This square as [parts] x [parts] squares. */
    private fun Mesh.divided(parts: Int): Mesh {
        val (x0, y0) = positions[0] to positions[1]
        val (x1, y1) = positions[3] to positions[7]
        return SampleScenes.sheet(parts + 1, material) { column, row, axis ->
            when (axis) {
                0 -> if (column == parts) x1 else x0 + (x1 - x0) * column / parts
                1 -> if (row == parts) y1 else y0 + (y1 - y0) * row / parts
                else -> positions[2]
            }
        }
    }

    @Test
    fun deepPartsAreThoseThatManyContain() {
        val random = Random(1967)
        repeat(300) {
            val all = Intervals()
            repeat(random.nextInt(12)) {
                val from = random.nextInt(20)
                all.add(from / 20.0, (from + 1 + random.nextInt(20 - from)) / 20.0)
            }
            for (most in 1..4) {
                val deep = Intervals().apply { setDeep(all, most) }
                for (place in 0 until 20) {
                    val t = (place + 0.5) / 20
                    val containing = (0 until all.count).count { t > all.from(it) && t < all.until(it) }
                    val isDeep = (0 until deep.count).any { t > deep.from(it) && t < deep.until(it) }
                    assertEquals(containing > most, isDeep) { "$t" }
                }
                for (i in 1 until deep.count) assertTrue(deep.from(i) > deep.until(i - 1))
            }
        }
    }

    @Test
    fun rule_10_2_polygonsHaveEdgesAndHideLines() {
        fun contour(x0: Double, y0: Double, x1: Double, y1: Double) =
            listOf(Vertex(x0, y0, 1.0), Vertex(x1, y0, 1.0), Vertex(x1, y1, 1.0), Vertex(x0, y1, 1.0))
        val frame = Polygon(listOf(contour(-1.0, -1.0, 1.0, 1.0), contour(-0.5, -0.5, 0.5, 0.5)), plain)
        val back = square(-1.8f, -1.5f, 1.8f, 0.02f, -1f)
        val image = render(listOf(back, frame), EdgeStyle())

        // The line behind is seen through the hole
        assertEquals(listOf(4..24, 37..62, 74..94), image.blackColumns(49))
        val glass = Material(baseColor = Rgba.WHITE.withAlpha(0.5f), alphaMode = AlphaMode.BLEND)
        val clear = EdgeStyle().drawnOn(Scene(listOf(back, frame.withMaterials { glass }), viewpoint = front))
        val seen = Renderers.find("tiled")!!.render(clear.frame(100, 100))
        assertEquals(listOf(4..94), seen.blackColumns(49), "what is translucent hides no lines")
    }

    /** The cover begins between the camera and the near plane, and ends beyond it. */
    @Test
    fun rule_10_2_whatIsInFrontOfTheNearPlaneHidesNothing() {
        val back = square(-1.8f, -1.5f, 1.8f, 0.02f, -1f)
        val eye = Vector3d(0.0, 0.0, 10.0)
        val angle = 2 * StrictMath.toDegrees(StrictMath.atan(0.2))
        val perspective = Camera.perspective(eye, Vector3d(), Vector3d(0.0, 1.0, 0.0), angle, 1.0, 20.0)

        // The cover reaches from column 25 to 75, and passes through the near plane in column 50. Under perspective, it
        // passes through that plane where x is 0.04 and the raster is 0.4 wide, in column 60
        val views = listOf(
            Triple(front, Pair(-1.0, 1.0), listOf(4..49, 74..94)),
            Triple(perspective, Pair(-0.06, 0.14), listOf(9..59, 73..90)),
        )
        for ((camera, ends, columns) in views) {
            for (isPolygon in listOf(false, true)) {
                fun cover(nearer: Double, farther: Double) = listOf(
                    Vertex(ends.first, -0.4, nearer), Vertex(ends.second, -0.4, farther),
                    Vertex(ends.second, 0.4, farther), Vertex(ends.first, 0.4, nearer),
                ).let { if (isPolygon) Polygon(listOf(it), plain) else mesh(it) }
                val row = render(listOf(back, cover(9.5, 8.5)), EdgeStyle(), camera).blackColumns(49)
                assertEquals(columns, row) { "$camera, $isPolygon" }

                // All of it is in front of the near plane
                val image = render(listOf(back, cover(9.5, 9.25)), EdgeStyle(), camera)
                assertArrayEquals(render(listOf(back), EdgeStyle(), camera).argb, image.argb) { "$camera, $isPolygon" }
            }
        }
    }

    private fun mesh(quad: List<Vertex>): Mesh = Mesh(
        quad.flatMap { listOf(it.x.toFloat(), it.y.toFloat(), it.z.toFloat()) }.toFloatArray(),
        intArrayOf(0, 1, 2, 0, 2, 3), plain,
    )

    /** A part that stands on another one: the edges on the contact are on a surface that is not theirs. */
    @Test
    fun rule_10_2_facesThatTouchAnEdgeDoNotHideIt() {
        val base = Solids.box(-1.5f, -1f, -1f, 1.5f, 0f, 1f, plain)
        val top = Solids.box(-0.5f, 0f, -0.5f, 0.5f, 1f, 0.5f, plain)
        val camera = Camera.orthographic(Vector3d(3.0, 5.0, 8.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 5.0, 1.0, 20.0)
        val image = render(listOf(base, top), EdgeStyle(width = 1.5), camera, 200)
        val setUp = setUp(Raster(200, 200), camera, emptyList())
        for (step in 0..100) {
            val point = setUp.project(Vector3d(-0.5 + step / 100.0, 0.0, 0.5))!!
            assertTrue(image.isBlack(point.x.toInt(), point.y.toInt())) { "$point" }
        }
    }

    /** The margin is 2^-17 of the longest side of the surfaces' box, 3.6 here. */
    @Test
    fun rule_10_2_aFaceInFrontByMoreThanTheMarginHides() {
        val margin = 3.6 / (1 shl 17)
        for ((gap, columns) in listOf(0.9 * margin to listOf(4..94), 1.1 * margin to listOf(4..36, 63..94))) {
            val back = square(-1.8f, -1.5f, 1.8f, 0.02f, -gap.toFloat())
            val image = render(listOf(back, square(-0.52f, -1f, 0.56f, 1f, 0f)), EdgeStyle())
            val row = image.blackColumns(49).filter { it.last > it.first }
            assertEquals(columns, row) { "$gap" }
        }
    }

    @Test
    fun linesOfTheScreenAreWhereTheirMeshIs() {
        val corners = floatArrayOf(0f, 0f, 0f, 20f, 0f, 0f, 20f, 20f, 0f, 0f, 20f, 0f)
        val there = FloatArray(12) { corners[it] + if (it % 3 == 2) 0.5f else 50f }
        val numbers = intArrayOf(0, 1, 2, 0, 2, 3)
        val expected = render(listOf(Mesh(there, numbers, plain)), EdgeStyle(), Camera.screen())
        val origin = Vector3d(50.0, 50.0, 0.5)
        val actual = render(listOf(Mesh(corners, numbers, plain, origin = origin)), EdgeStyle(), Camera.screen())
        assertTrue(expected.isBlack(60, 49) && !expected.isBlack(60, 60))
        assertArrayEquals(expected.argb, actual.argb)
    }

    /** Parts of the scene are behind the camera and far outside the raster, others are not finite. */
    @Test
    fun awkwardScenesDoNotThrow() {
        val nan = Mesh(floatArrayOf(Float.NaN, 0f, 0f, 1f, 1f, 1f, 1e30f, -1e30f, 1e30f), intArrayOf(0, 1, 2, 1, 2, 1))
        val ground = square(-1e6f, -1e6f, 1e6f, 1e6f, -0.5f)
        val surfaces = listOf(nan, ground, Solids.cube(plain), Solids.torus(3.0, 0.5, 12, 8))
        for (camera in listOf(
            Camera.perspective(Vector3d(0.0, 0.0, 3.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 90.0, 0.01, 50.0),
            Camera.perspective(Vector3d(0.1, 0.2, 0.3), Vector3d(), Vector3d(0.0, 1.0, 0.0), 120.0, 0.1, 50.0),
            front, Camera.screen(),
        )) {
            for (edges in EdgeSet.entries) render(surfaces, EdgeStyle(edges, hidden = HiddenLines.SOLID), camera)
        }
        render(emptyList(), EdgeStyle())
    }

    @Test
    fun rule_10_3_widthsAreThoseOfPixelsWhateverTheSampling() {
        val scene = EdgeStyle(width = 4.0).drawnOn(Scene(listOf(square(-1f, -1f, 1f, 1f, 0f)), viewpoint = front))
        for (factor in listOf(1, 4)) {
            val image = SuperSampling(factor).frame(scene, Raster(100, 100)).render(ZBufferRenderer())
            assertEquals(listOf(23..26, 73..76), image.blackColumns(50))
        }
    }

    /** A machine with many parts inside must not become a black tangle. */
    @Test
    fun hiddenLinesAreGreyUnlessTheCallerChooses() {
        val surfaces = listOf(square(-1.8f, -1.5f, 1.8f, 0.02f, -1f), square(-0.5f, -1f, 0.52f, 1f, 0f))
        val style = EdgeStyle(hidden = HiddenLines.SOLID)
        fun colors(style: EdgeStyle) = render(surfaces, style).argb.toSet() - Rgba.WHITE.toArgb()
        assertEquals(setOf(Rgba.BLACK.toArgb(), 0xFFA0A0A0.toInt()), colors(style))
        val red = Rgba.ofRgb(0xFF0000)
        val chosen = style.withHiddenColor(red).withWidth(2.0).withColor(Rgba.ofRgb(0x0000FF))
        assertEquals(setOf(0xFF0000FF.toInt(), red.toArgb()), colors(chosen))
    }

    /** Dashes and the grid of crumbs are multiples of the width; a width near 0 would make them too many to count. */
    @Test
    fun rule_10_3_widthsBelowOneSampleCountAsOneSample() {
        val surfaces = listOf(Solids.sphere(24, 12), square(-3f, -0.2f, 1.5f, 0.2f, 0.3f))
        for (hidden in HiddenLines.entries) {
            val one = render(surfaces, EdgeStyle(hidden = hidden))
            val thin = render(surfaces, EdgeStyle(width = 1e-5, hidden = hidden))
            assertArrayEquals(one.argb, thin.argb) { "$hidden" }
        }
    }

    /** Where w is always 1, a great distance of the far plane does not make it small. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aDistantFarPlaneTakesNoMoreTime() {
        val torus = Solids.torus(1.2, 0.5, 140, 100)
        val images = ArrayList<Image>()
        val (near, distant) = listOf(20.0, 4e9).map { far ->
            val camera =
                Camera.orthographic(Vector3d(3.0, 5.0, 7.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, far)
            ProcessorTime.of { images += render(listOf(torus), EdgeStyle(EdgeSet.ALL), camera) }
        }
        assertArrayEquals(images[0].argb, images[1].argb)
        assertTrue(distant <= 4 * near) { "$distant ns, not $near" }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun manyPolygonsTakeLinearTime() {
        val random = Random(12)
        fun square(): Polygon {
            val (x, y, z) = List(3) { random.nextDouble() * 3.6 - 1.8 }
            val contour = listOf(Vertex(x, y, z), Vertex(x + 0.04, y, z), Vertex(x + 0.04, y + 0.04, z))
            return Polygon(listOf(contour + Vertex(x, y + 0.04, z)), plain)
        }
        ProcessorTime.assertLinear(16_000, { count -> List(count) { square() } }) { squares, _ ->
            assertTrue(render(squares, EdgeStyle(), side = 200).visible > 0)
        }
    }

    @Test
    fun stylesAreChecked() {
        for (wrong in listOf<() -> EdgeStyle>(
            { EdgeStyle(width = 0.0) }, { EdgeStyle(width = 5000.0) }, { EdgeStyle(creaseAngle = -1.0) },
            { EdgeStyle(color = Rgba.TRANSPARENT) }, { EdgeStyle(hiddenColor = Rgba.TRANSPARENT) },
            { EdgeStyle(hiddenBehind = 0) },
        )) {
            assertThrows(IllegalArgumentException::class.java) { wrong() }
        }
        val fitted = Camera.fit(0.0, 0.0, 1.0, Fit.ORTHOGRAPHIC)
        val scene = Scene(listOf(Solids.cube()), viewpoint = fitted)
        assertEquals(scene.bounds.toString(), EdgeStyle().drawnOn(scene).bounds.toString())
    }
}
