package dev.lazyz.sections

import dev.lazyz.Rgba
import dev.lazyz.drawing.Solids
import dev.lazyz.sections.Section
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.spi.Fragment
import dev.lazyz.world.Scene
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.material.MetallicRoughness
import dev.lazyz.world.material.Texture
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import java.util.Random
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What remains of a closed mesh is closed by its caps: areas and volumes are right. */
class SectionTest {
    private fun cut(surfaces: List<Surface>, vararg planes: Section.Plane) =
        Section(planes.toList()).of(Scene(surfaces))

    private fun caps(cut: Section.Cut) = cut.scene.surfaces.filterIsInstance<Polygon>()

    /** The area of all contours of the caps; holes count as negative. */
    private fun area(cut: Section.Cut, normal: Vector3d): Double =
        caps(cut).sumOf { cap -> cap.contours.sumOf { vectorArea(it).dot(normal) } }

    private fun vectorArea(contour: List<Vertex>): Vector3d {
        val sum = Vector3d()
        for (i in contour.indices) sum.add(position(contour[i]).cross(position(contour[(i + 1) % contour.size])))
        return sum.mul(0.5)
    }

    private fun position(vertex: Vertex) = Vector3d(vertex.x, vertex.y, vertex.z)

    /** The volume that the surfaces enclose, by Gauss's theorem. It depends on the place of a surface that is open. */
    private fun volume(cut: Section.Cut, center: Vector3d = Vector3d(10.0, -7.0, 5.0)): Double {
        val meshes = cut.scene.surfaces.filterIsInstance<Mesh>().sumOf { mesh ->
            (0 until mesh.triangleCount).sumOf { i ->
                val (a, b, c) = (0 until 3).map { k ->
                    val at = 3 * mesh.triangles[3 * i + k]
                    Vector3d(mesh.positions.copyOfRange(at, at + 3)).sub(center)
                }
                a.dot(b.cross(c)) / 6
            }
        }
        val polygons = caps(cut).sumOf { cap ->
            cap.contours.sumOf { contour -> vectorArea(contour).dot(position(contour[0]).sub(center)) / 3 }
        }
        return meshes + polygons
    }

    @Test
    fun anInterruptEndsCutting() {
        Thread.currentThread().interrupt()
        assertThrows(InterruptedException::class.java) { cut(listOf(Solids.cube()), Section.Plane.x(0.25)) }
    }

    @Test
    fun rule_10_5_aCubeIsCapped() {
        val half = cut(listOf(Solids.cube()), Section.Plane.x(0.25))
        assertEquals(emptyList<String>(), half.warnings)
        assertEquals(1, caps(half).single().contours.size)
        assertEquals(4.0, area(half, Vector3d(1.0, 0.0, 0.0)), 1e-6)
        assertEquals(5.0, volume(half), 1e-5)
        assertEquals(3.0, volume(cut(listOf(Solids.split(Solids.cube())), Section.Plane.x(0.25).reversed())), 1e-5)

        // A plane across a corner
        val corner = cut(listOf(Solids.cube()), Section.Plane(Vector3d(1.0, 1.0, 1.0), 2.0 / StrictMath.sqrt(3.0)))
        assertEquals(8.0 - 1.0 / 6, volume(corner), 1e-5)
    }

    @Test
    fun rule_10_4_cutsThroughVerticesAndAlongFacesWork() {
        val cube = Solids.cube()

        // Through four edges, and so through vertices of diagonals
        val diagonal = cut(listOf(cube), Section.Plane(Vector3d(1.0, 1.0, 0.0), 0.0))
        assertEquals(4.0, volume(diagonal), 1e-5)
        assertEquals(2 * StrictMath.sqrt(8.0), area(diagonal, Vector3d(1.0, 1.0, 0.0).normalize()), 1e-5)

        // Along a face: all of the cube, or nothing
        val all = cut(listOf(cube), Section.Plane.x(1.0))
        assertSame(cube, all.scene.surfaces.single())
        assertEquals(0, cut(listOf(cube), Section.Plane.x(-1.0)).scene.surfaces.size)
        assertEquals(0, cut(listOf(cube), Section.Plane.x(-5.0)).scene.surfaces.size)

        // Along the step of a solid: the plane is both a face of it and a section
        val step = listOf(cube, Solids.box(-0.5f, 1f, -0.5f, 0.5f, 2f, 0.5f))
        val whole = Mesh(
            step[0].positions + step[1].positions, step[0].triangles + step[1].triangles.map { it + 8 }.toIntArray(),
        )
        assertEquals(8.0, volume(cut(listOf(whole), Section.Plane.y(1.0))), 1e-5)
        assertEquals(1.0, volume(cut(listOf(whole), Section.Plane.y(1.0).reversed())), 1e-5)
        for (plane in listOf(Section.Plane.x(0.5), Section.Plane.x(-0.5), Section.Plane.z(0.5), Section.Plane.z(0.0))) {
            val parts = volume(cut(listOf(whole), plane)) + volume(cut(listOf(whole), plane.reversed()))
            assertEquals(9.0, parts, 1e-5, "$plane")
        }

        // A sphere with vertices on all three planes
        for (plane in listOf(Section.Plane.x(0.0), Section.Plane.y(0.0), Section.Plane.z(0.0))) {
            val half = cut(listOf(Solids.sphere(16, 8)), plane)
            assertEquals(emptyList<String>(), half.warnings)
            assertEquals(volume(half), volume(half, Vector3d(-3.0, 20.0, 1.0)), 1e-5, "closed: $plane")
        }
    }

    @Test
    fun rule_10_5_openMeshesGetAWarningAndNoCap() {
        val cube = Solids.cube()
        val open = Mesh(cube.positions, cube.triangles.copyOf(cube.triangles.size - 6))
        val half = cut(listOf(open), Section.Plane.y(0.0))
        assertEquals(0, caps(half).size)
        assertTrue("1 contour does not close" in half.warnings.single()) { "${half.warnings}" }

        // Closed only together: one cap
        val lid = Mesh(cube.positions, cube.triangles.copyOfRange(cube.triangles.size - 6, cube.triangles.size))
        val both = cut(listOf(open, lid), Section.Plane.y(0.0))
        assertEquals(emptyList<String>(), both.warnings)
        assertEquals(4.0, area(both, Vector3d(0.0, 1.0, 0.0)), 1e-6)

        // A closed part is capped even if another one is open
        val mixed = Mesh(
            open.positions + Solids.box(2f, -1f, -1f, 3f, 1f, 1f).positions,
            open.triangles + cube.triangles.map { it + 8 }.toIntArray(),
        )
        val rest = cut(listOf(mixed), Section.Plane.y(0.0))
        assertEquals(2.0, area(rest, Vector3d(0.0, 1.0, 0.0)), 1e-6)
        assertEquals(1, rest.warnings.size)
    }

    @Test
    fun rule_10_4_whatDiffersFromThePlaneByRoundingIsOnIt() {
        val random = Random(104)
        repeat(1000) {
            val normal = Vector3d(random.nextGaussian(), random.nextGaussian(), 1.0)
            val plane = Section.Plane(normal, random.nextGaussian())
            val (x, y) = List(2) { 100 * random.nextGaussian() }
            val z = (plane.distance - plane.normal.x() * x - plane.normal.y() * y) / plane.normal.z()
            assertEquals(0.0, plane.height(x, y, z))
            val beside = 1e-9 * (1 + StrictMath.abs(x) + StrictMath.abs(y) + StrictMath.abs(z))
            assertTrue(plane.height(x, y, z + beside) > 0.0 && plane.height(x, y, z - beside) < 0.0)
        }
    }

    /** Two triangles with a side in common, in two meshes and in two orders: the same bits, those of the contract. */
    @Test
    fun rule_10_4_newVerticesDependOnPositionsOnly() {
        val random = Random(105)
        repeat(300) {
            // Ends of different sizes, so that it matters from which end the new vertex is computed
            val size = FloatArray(4) { 1f / (1 shl random.nextInt(28)) }
            val p = FloatArray(12) { size[it / 3] * (random.nextFloat() * 2 - 1) }
            val plane = Section.Plane(Vector3d(random.nextGaussian(), random.nextGaussian(), 1.0), 1e-9)
            val (f, g) = listOf(0, 3).map { plane.height(p[it].toDouble(), p[it + 1].toDouble(), p[it + 2].toDouble()) }
            if (f * g >= 0.0) return@repeat
            val meshes = listOf(intArrayOf(0, 1, 2), intArrayOf(1, 0, 3)).map { Mesh(p, it) }
            val (first, second) = if (p[0] < p[3]) listOf(0, 3) else listOf(3, 0)
            val t = if (first == 0) f / (f - g) else g / (g - f)
            val expected = (0 until 3).map {
                (p[first + it] + t * (p[second + it].toDouble() - p[first + it])).toFloat()
            }
            for (mesh in cut(meshes, plane).scene.surfaces.filterIsInstance<Mesh>()) {
                val vertices = mesh.positions.toList().chunked(3)
                assertTrue(expected in vertices) { "$expected is not in $vertices" }
            }
        }
    }

    @Test
    fun rule_10_4_otherSurfacesAreCut() {
        val square = listOf(Vertex(0.0, 0.0, 0.0), Vertex(2.0, 0.0, 0.0), Vertex(2.0, 2.0, 0.0), Vertex(0.0, 2.0, 0.0))
        val surfaces = listOf(
            Polygon(listOf(square)), Points(floatArrayOf(0f, 0f, 0f, 3f, 0f, 0f)),
            Lines(floatArrayOf(0f, 0f, 0f, 4f, 0f, 0f), intArrayOf(0, 1)), Sphere(Vector3d(), 1.0),
        )
        val rest = cut(surfaces, Section.Plane.x(1.0))
        assertEquals(2.0, vectorArea((rest.scene.surfaces[0] as Polygon).contours.single()).z, 1e-9)
        assertEquals(1, (rest.scene.surfaces[1] as Points).pointCount)
        assertEquals(1.0, (rest.scene.surfaces[2] as Lines).bounds!!.maxX, 1e-9)
        assertSame(surfaces[3], rest.scene.surfaces[3])
        assertEquals(1, rest.warnings.size)
    }

    @Test
    fun rule_10_4_newVerticesHaveAttributesInBetween() {
        val triangle = Mesh(
            floatArrayOf(0f, 0f, 0f, 4f, 0f, 0f, 0f, 4f, 0f), intArrayOf(0, 1, 2),
            uvs = floatArrayOf(0f, 0f, 1f, 0f, 0f, 1f), colors = FloatArray(12) { if (it / 4 == 1) 1f else 0f },
        )
        val rest = cut(listOf(triangle), Section.Plane.x(1.0)).scene.surfaces.single() as Mesh
        for (i in 0 until rest.vertexCount) {
            assertEquals(rest.positions[3 * i] / 4, rest.uvs!![2 * i], 1e-6f)
            assertEquals(rest.positions[3 * i] / 4, rest.colors!![4 * i], 1e-6f)
        }
        assertEquals(4, rest.vertexCount)
    }

    @Test
    fun rule_10_5_capsHaveTheColourOfTheModel() {
        val texture = Texture(2, 1, intArrayOf(0xFFFF0000.toInt(), 0xFF000000.toInt()))
        val metal = Material(Rgba(1f, 0.5f, 0.5f), texture).withMetallicRoughness(MetallicRoughness(0.25f, 0.5f))
        val cap = caps(cut(listOf(Solids.cube(metal)), Section.Plane.x(0.0))).single().material
        assertEquals(MetallicRoughness(0.25f, 0.5f), cap.metallicRoughness)
        assertEquals(0.3f, cap.baseColor.red, 0.003f)
        assertEquals(0f, cap.baseColor.green)
    }

    @Test
    fun rule_10_5_aStripeIncludesItsFirstLine() {
        val hatching = Hatching(0.5, 0.25, Rgba(1f, 0f, 0f), Rgba(0f, 1f, 0f, 0.5f))
        fun isStripe(x: Float, y: Float, z: Float): Boolean {
            val fragment = Fragment()
            fragment.moveTo(0, 0)
            fragment.worldX = x
            fragment.worldY = y
            fragment.worldZ = z
            hatching.shade(fragment)
            assertEquals(if (fragment.red == 1f) 1f else 0.5f, fragment.alpha)
            return fragment.red == 1f
        }

        // A stripe is 1/8 wide, and another one follows at 1/2
        val places = mapOf(0f to true, 0.124f to true, 0.125f to false, 0.499f to false, 0.5f to true, -0.001f to false)
        for ((place, expected) in places) {
            assertEquals(expected, isStripe(place, 0f, 0f)) { "$place" }
            assertEquals(expected, isStripe(place - 1f, 2f, -1f)) { "$place" }
        }
        assertTrue(isStripe(-0.5f, 0f, 0f))
    }

    /** A cut opens the view of inner walls, which show their backs. */
    @Test
    fun rule_10_4_whatRemainsShowsBothSides() {
        val cube = Solids.cube(Material(sides = Sides.FRONT))
        val cut = cut(listOf(cube), Section.Plane.x(0.0)).scene.surfaces.filterIsInstance<Mesh>()
        assertEquals(listOf(Sides.BOTH), cut.map { it.material.sides })
        val whole = cut(listOf(cube)).scene.surfaces.filterIsInstance<Mesh>()
        assertEquals(listOf(Sides.FRONT), whole.map { it.material.sides })
    }

    @Test
    fun planesAreChecked() {
        assertThrows(IllegalArgumentException::class.java) { Section.Plane(Vector3d(), 1.0) }
        assertThrows(IllegalArgumentException::class.java) { Section.Plane.x(Double.NaN) }
        assertThrows(IllegalArgumentException::class.java) { Hatching(0.0, 0.5, Rgba.BLACK, Rgba.WHITE) }
    }

    /** A polygon that covers nothing is not cut to one that does. */
    @Test
    fun rule_9_5_polygonsThatAreNotFiniteStayAsTheyAre() {
        val corners = listOf(0.0 to 0.0, 1.0 to 0.0, 1.0 to 1.0, Double.NaN to 1.0)
        val polygon = Polygon(listOf(corners.map { (x, y) -> Vertex(x, y, 0.0) }), Material())
        for (plane in listOf(Section.Plane.x(100.0), Section.Plane.x(0.5))) {
            assertEquals(listOf(polygon), cut(listOf(polygon), plane).scene.surfaces)
        }
    }
}
