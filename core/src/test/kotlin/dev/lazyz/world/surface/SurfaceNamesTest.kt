package dev.lazyz.world.surface

import dev.lazyz.Raster
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.sections.Section
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Polygon.Vertex
import org.joml.Matrix4d
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Test

/** Parts keep their names, whatever is done to them. */
class SurfaceNamesTest {
    private val positions = floatArrayOf(0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f, 0f, 0f, 0f, 1f)
    private val faces = intArrayOf(0, 2, 1, 0, 1, 3, 1, 2, 3, 2, 0, 3)
    private val uvs = floatArrayOf(0f, 0f, 1f, 0f, 0f, 1f, 1f, 1f)
    private val mesh = Mesh(positions, faces, uvs = uvs, name = "car/wheel")
    private val polygon = Polygon(
        listOf(listOf(Vertex(0.0, 0.0, 0.0), Vertex(1.0, 0.0, 0.0), Vertex(0.0, 1.0, 0.0))),
        name = "car/door",
    )
    private val all = listOf(
        mesh,
        polygon,
        Sphere(Vector3d(), 1.0, name = "ball"),
        Points(positions, name = "cloud"),
        Lines(positions, intArrayOf(0, 1, 2, 3), name = "wire"),
    )
    private val streamed = StreamedMesh(Pieces(mesh, mesh.triangleCount), name = "scan")

    private fun assertKept(change: (Surface) -> Surface, surfaces: List<Surface> = all + streamed) =
        assertEquals(surfaces.map { it.name }, surfaces.map { change(it).name })

    @Test
    fun surfacesKeepTheirNames() {
        assertKept({ surface -> surface.withMaterials { Material(name = "paint") } })
        assertKept({ it.withUpAxis(UpAxis.Z) })
        assertKept({ it.magnified(2) })
        val moved = Matrix4d().translation(1.0, 2.0, 3.0)
        assertKept(
            {
                when (it) {
                    is Mesh -> it.transformed(moved)
                    is Polygon -> it.transformed(moved)
                    is Sphere -> it.transformed(moved)
                    is Points -> it.transformed(moved)
                    else -> (it as Lines).transformed(moved)
                }
            },
            all,
        )
        assertEquals("car/wheel", mesh.withSmoothNormals().name)
        assertEquals("car/wheel", mesh.withTangents().name)
        assertEquals("scan", streamed.withoutColors().name)
    }

    @Test
    fun surfacesGetOtherNames() {
        for (surface in all + streamed) {
            val renamed = surface.withName("other")
            assertEquals("other", renamed.name)
            assertEquals(surface.javaClass, renamed.javaClass)
            assertEquals("${surface.bounds}", "${renamed.bounds}")
        }
    }

    @Test
    fun whatIsCutAndItsCapKeepTheName() {
        val cut = Section(listOf(Section.Plane.x(0.25))).of(Scene(all)).scene
        assertEquals(all.map { it.name } + "car/wheel", cut.surfaces.map { it.name })
    }

    @Test
    fun theObjectAtAPixelHasItsName() {
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 4.0, 1.0, 9.0)
        val left = Matrix4d().translation(-1.5, 0.0, 0.0)
        val unnamed = Sphere(Vector3d(1.0, -1.0, 0.0), 0.5)
        val scene = Scene(listOf(mesh.transformed(left), unnamed, streamed), viewpoint = camera)
        for (surfaces in listOf(scene.surfaces, scene.surfaces.take(2) + mesh.withName("scan"))) {
            for (strategy in listOf(TiledRenderer(), ZBufferRenderer())) {
                val frame = SuperSampling(2).frame(scene.withSurfaces(surfaces), Raster(40, 40))
                val objects = AovFrame(frame, setOf(Aov.OBJECT)).render(strategy)[Aov.OBJECT]
                assertEquals(listOf("car/wheel", "", "scan"), objects.names)
                assertEquals("car/wheel", objects.name(6, 18))
                assertEquals("", objects.name(30, 30))
                assertEquals("scan", objects.name(21, 18))
                assertNull(objects.name(0, 0))
            }
        }
        val streamedFrame = SuperSampling.NONE.frame(scene, Raster(40, 40))
        assertThrows(IllegalArgumentException::class.java) { AovFrame(streamedFrame, setOf(Aov.NORMAL)) }
    }
}
