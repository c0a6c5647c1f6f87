package dev.lazyz.cli.input

import dev.lazyz.cli.output.Mistake
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.NamedCamera
import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Projection
import dev.lazyz.world.Scene
import dev.lazyz.world.View
import dev.lazyz.world.Viewpoint
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PointOfViewTest {
    private val up = Vector3d(0.0, 1.0, 0.0)
    private val perspective = Camera.perspective(Vector3d(0.0, 5.0, 0.0), Vector3d(), up, 40.0, 1.0, 20.0)
    private val orthographic = Camera.orthographic(Vector3d(9.0, 0.0, 0.0), Vector3d(), up, 1.0, 0.0, 20.0)

    private fun loaded(own: Viewpoint, cameras: List<NamedCamera> = emptyList()): LoadedScene {
        val sphere = Sphere(Vector3d(1.0, 2.0, 3.0), 1.0)
        return LoadedScene(Scene(listOf(sphere), emptyList(), own), emptyList(), cameras = cameras)
    }

    private fun seen(own: Viewpoint, asked: PointOfView): Viewpoint = asked.applyTo(loaded(own), UpAxis.Y).viewpoint

    private fun camera(own: Viewpoint, asked: PointOfView): Camera =
        asked.applyTo(loaded(own), UpAxis.Y).camera(40, 30)

    private fun fitted(own: Viewpoint, asked: PointOfView): List<Any> =
        (seen(own, asked) as FittedViewpoint).let { listOf(it.azimuth, it.elevation, it.zoom, it.kind) }

    @Test
    fun scenesKeepTheirCameraUnlessAsked() {
        assertEquals(perspective.toString(), seen(perspective, PointOfView()).toString())
        val own = Camera.fit(1.0, 2.0, 3.0, Fit.ORTHOGRAPHIC, 4.0, 5.0)
        assertEquals(own.toString(), seen(own, PointOfView()).toString())
        val rule = Viewpoint { _, _ -> perspective }
        assertSame(rule, seen(rule, PointOfView()))
    }

    @Test
    fun whatIsNotAskedStaysAsTheFittedCameraHasIt() {
        val own = Camera.fit(1.0, 2.0, 4.0, Fit.ORTHOGRAPHIC, 7.0, 50.0)
        assertEquals(listOf(1.0, 2.0, 3.0, Fit.ORTHOGRAPHIC), fitted(own, PointOfView(zoom = 3.0)))
        val asked = PointOfView(view = View.LEFT, elevation = 7.0, projection = Fit.PERSPECTIVE)
        assertEquals(listOf(-90.0, 7.0, 4.0, Fit.PERSPECTIVE), fitted(own, asked))
        val narrow = seen(own, PointOfView(margin = 1.0)) as FittedViewpoint
        assertEquals(listOf(1.0, 50.0), listOf(narrow.margin, narrow.fieldOfView))
    }

    @Test
    fun aSideReplacesAFixedCameraByOneThatLooksTheSameWayOtherwise() {
        assertEquals(listOf(90.0, 7.0, 1.0, Fit.ORTHOGRAPHIC), fitted(orthographic, PointOfView(elevation = 7.0)))
        assertEquals(listOf(90.0, 1.0, Fit.PERSPECTIVE), fitted(perspective, PointOfView(azimuth = 3.0)).drop(1))
        assertEquals(listOf(90.0, 0.0, 1.0, Fit.ORTHOGRAPHIC), fitted(orthographic, PointOfView(CameraChoice.Fit)))
    }

    @Test
    fun aRuleOfOnesOwnIsReplacedByTheDefault() {
        val rule = Viewpoint { _, _ -> error("not asked") }
        assertEquals(listOf(30.0, 7.0, 1.0, Fit.PERSPECTIVE), fitted(rule, PointOfView(elevation = 7.0)))
    }

    @Test
    fun zoomAndFieldOfViewKeepAFixedCamera() {
        fun angle(asked: PointOfView) =
            camera(perspective, asked).let { (it.projection as Projection.Perspective).verticalFieldOfView to it.eye }
        val half = Math.toDegrees(2 * Math.atan(Math.tan(Math.toRadians(20.0)) / 2))
        assertEquals(half, angle(PointOfView(zoom = 2.0)).first, 1e-12)
        assertEquals(perspective.eye, angle(PointOfView(zoom = 2.0)).second)
        assertEquals(70.0 to perspective.eye, angle(PointOfView(fieldOfView = 70.0)))
        val flat = camera(orthographic, PointOfView(zoom = 4.0))
        assertEquals(0.25, (flat.projection as Projection.Orthographic).height)
    }

    @Test
    fun modelsWithCamerasAreFittedUnlessOneIsAskedFor() {
        val model = loaded(orthographic, listOf(NamedCamera("one", orthographic), NamedCamera("", perspective)))
        fun chosen(choice: CameraChoice?) = PointOfView(choice).applyTo(model, UpAxis.Y).viewpoint.toString()
        assertEquals(Camera.fit().toString(), chosen(null))
        assertEquals(Camera.fit().toString(), chosen(CameraChoice.Fit))
        assertEquals(orthographic.toString(), chosen(CameraChoice.OfScene))
        assertEquals(orthographic.toString(), chosen(CameraChoice.OfModel(0)))
        assertEquals(perspective.toString(), chosen(CameraChoice.OfModel(1)))
        val error = assertThrows(Mistake::class.java) { chosen(CameraChoice.OfModel(2)) }
        assertEquals("--camera 2: the input has 2: 0 (one), 1", error.message)
    }

    @Test
    fun anEyeLooksAtTheMiddleOfTheSceneAndSeesAllOfItsDepth() {
        val camera = camera(Camera.fit(), PointOfView(placement = Placement(eye = Vector3d(1.0, 2.0, 9.0))))
        assertEquals(Vector3d(1.0, 2.0, 3.0), camera.target)
        assertTrue(camera.near in 4.9..5.0 && camera.far in 7.0..7.1, "$camera")

        // An eye in the scene, and one that looks away from it
        for (z in listOf(3.5, 5.0)) {
            val placement = Placement(Vector3d(1.0, 2.0, z), Vector3d(1.0, 2.0, z + 1.0))
            val inside = camera(Camera.fit(), PointOfView(placement = placement))
            assertTrue(inside.near > 0.0 && inside.far > inside.near, "$inside")
        }
    }

    @Test
    fun aTargetMovesAFittedCameraAndTurnsAFixedOne() {
        val target = Vector3d(0.5, 0.0, 3.0)
        val asked = PointOfView(placement = Placement(target = target))
        val before = camera(Camera.fit(), PointOfView())
        val after = camera(Camera.fit(), asked)
        val way = Vector3d(before.eye).sub(before.target)
        assertEquals(0.0, Vector3d(after.eye).sub(target).distance(way), 1e-12)
        val turned = camera(perspective, asked)
        assertEquals(perspective.eye to target, turned.eye to turned.target)
    }

    @Test
    fun positionsTurnWithTheModel() {
        for (axis in UpAxis.entries) {
            val placement = Placement(Vector3d(4.0, 5.0, 9.0), Vector3d(0.0, 1.0, 2.0), Vector3d(0.1, 0.2, 0.3))
            val scene = PointOfView(placement = placement).applyTo(loaded(Camera.fit()), axis)
            val camera = scene.camera(40, 30)
            assertEquals(axis.toWorld(placement.eye!!), camera.eye)
            assertEquals(placement.eye, axis.toModel(camera.eye))
            assertEquals(axis.toWorld(placement.up!!), camera.up)
        }
    }
}
