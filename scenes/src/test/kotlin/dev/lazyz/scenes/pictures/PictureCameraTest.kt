package dev.lazyz.scenes.pictures

import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.NamedCamera
import dev.lazyz.scenes.pictures.PictureParameters.AZIMUTH
import dev.lazyz.scenes.pictures.PictureParameters.CAMERA
import dev.lazyz.scenes.pictures.PictureParameters.CAMERA_UP
import dev.lazyz.scenes.pictures.PictureParameters.ELEVATION
import dev.lazyz.scenes.pictures.PictureParameters.EYE
import dev.lazyz.scenes.pictures.PictureParameters.FOV
import dev.lazyz.scenes.pictures.PictureParameters.MARGIN
import dev.lazyz.scenes.pictures.PictureParameters.PROJECTION
import dev.lazyz.scenes.pictures.PictureParameters.TARGET
import dev.lazyz.scenes.pictures.PictureParameters.VIEW
import dev.lazyz.scenes.pictures.PictureParameters.ZOOM
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.FittedViewpoint.View
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.camera.Viewpoint
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PictureCameraTest {
    private val usual = PictureSettings()
    private val up = Vector3d(0.0, 1.0, 0.0)
    private val perspective = Camera.perspective(Vector3d(0.0, 5.0, 0.0), Vector3d(), up, 40.0, 1.0, 20.0)
    private val orthographic = Camera.orthographic(Vector3d(9.0, 0.0, 0.0), Vector3d(), up, 1.0, 0.0, 20.0)

    private fun loaded(own: Viewpoint, cameras: List<NamedCamera> = emptyList()): LoadedScene {
        val sphere = Sphere(Vector3d(1.0, 2.0, 3.0), 1.0)
        return LoadedScene(Scene(listOf(sphere), emptyList(), own), emptyList(), cameras = cameras)
    }

    private fun applied(asked: PictureSettings, model: LoadedScene, up: UpAxis = UpAxis.Y): Scene =
        PictureCamera(asked).applyTo(model.scene.withUpAxis(up), model, up, null)

    private fun seen(own: Viewpoint, asked: PictureSettings): Viewpoint =
        applied(asked, loaded(own)).viewpoint

    private fun camera(own: Viewpoint, asked: PictureSettings): Camera =
        applied(asked, loaded(own)).camera(40, 30)

    private fun fitted(own: Viewpoint, asked: PictureSettings): List<Any> =
        (seen(own, asked) as FittedViewpoint).let { listOf(it.azimuth, it.elevation, it.zoom, it.kind) }

    @Test
    fun picturesSayWhetherAPartOfTheModelIsOutside() {
        val model = Mesh(floatArrayOf(0f, 0f, 0f, 4f, 0f, 0f, 0f, 2f, 0f, 0f, 0f, 1f), INDICES)
        fun isCropped(words: String, surface: Surface = model): Boolean {
            val loaded = LoadedScene(Scene(listOf(surface)), emptyList())
            val pairs = words.split(' ').filter { it.isNotEmpty() }
                .map { it.substringBefore('=') to it.substringAfter('=') }
            return PictureDoor.COMMAND_LINE.read(PictureSettings(40, 30), pairs).frame(loaded).isCropped
        }
        for (view in listOf("iso", "top", "left")) {
            for (projection in listOf("perspective", "orthographic")) {
                val fitted = "view=$view projection=$projection margin=0"
                assertFalse(isCropped(fitted), fitted)
                assertTrue(isCropped("$fitted zoom=1.2"), fitted)
                assertFalse(isCropped("$fitted region=0,0,3x3"), fitted)
                assertFalse(isCropped(fitted, Sphere(Vector3d(1.0, 2.0, 3.0), 5.0)), fitted)
            }
        }

        // One side at a time, by the planes of cameras from outside
        val seen = "eye=2,1,20 target=2,1,0 projection=orthographic"
        assertFalse(isCropped("$seen height=3.2"))
        assertTrue(isCropped("$seen height=1.9"), "above and below")
        assertTrue(isCropped("$seen height=3.2 near=19.5"), "before")
        assertTrue(isCropped("$seen height=3.2 far=19.5"), "behind")
        assertTrue(isCropped("eye=3,1,20 target=3,1,0 projection=orthographic height=4"), "on the left")
        assertTrue(isCropped("eye=1,1,20 target=1,1,0 projection=orthographic height=4"), "on the right")
        assertFalse(isCropped("eye=2,1,20 target=2,1,0 fov=12"))
        assertTrue(isCropped("eye=2,1,20 target=2,1,0 fov=5"))
    }

    @Test
    fun scenesKeepTheirCameraUnlessAsked() {
        assertEquals(perspective.toString(), seen(perspective, usual).toString())
        val own = Camera.fit(1.0, 2.0, 3.0, Fit.ORTHOGRAPHIC, 4.0, 5.0)
        assertEquals(own.toString(), seen(own, usual).toString())
        val rule = Viewpoint { _, _ -> perspective }
        assertSame(rule, seen(rule, usual))
    }

    @Test
    fun whatIsNotAskedStaysAsTheFittedCameraHasIt() {
        val own = Camera.fit(1.0, 2.0, 4.0, Fit.ORTHOGRAPHIC, 7.0, 50.0)
        assertEquals(listOf(1.0, 2.0, 3.0, Fit.ORTHOGRAPHIC), fitted(own, usual.with(ZOOM, 3.0)))
        val asked = usual.with(VIEW, View.LEFT).with(ELEVATION, 7.0).with(PROJECTION, Fit.PERSPECTIVE)
        assertEquals(listOf(-90.0, 7.0, 4.0, Fit.PERSPECTIVE), fitted(own, asked))
        val narrow = seen(own, usual.with(MARGIN, 1.0)) as FittedViewpoint
        assertEquals(listOf(1.0, 50.0), listOf(narrow.margin, narrow.fieldOfView))
    }

    @Test
    fun aSideReplacesAFixedCameraByOneThatLooksTheSameWayOtherwise() {
        assertEquals(listOf(90.0, 7.0, 1.0, Fit.ORTHOGRAPHIC), fitted(orthographic, usual.with(ELEVATION, 7.0)))
        assertEquals(listOf(90.0, 1.0, Fit.PERSPECTIVE), fitted(perspective, usual.with(AZIMUTH, 3.0)).drop(1))
        assertEquals(
            listOf(90.0, 0.0, 1.0, Fit.ORTHOGRAPHIC),
            fitted(orthographic, usual.with(CAMERA, CameraChoice.FIT)),
        )
    }

    @Test
    fun aRuleOfOnesOwnIsReplacedByTheDefault() {
        val rule = Viewpoint { _, _ -> error("not asked") }
        assertEquals(listOf(30.0, 7.0, 1.0, Fit.PERSPECTIVE), fitted(rule, usual.with(ELEVATION, 7.0)))
    }

    @Test
    fun zoomAndFieldOfViewKeepAFixedCamera() {
        fun angle(asked: PictureSettings) =
            camera(perspective, asked).let { (it.projection as Projection.Perspective).verticalFieldOfView to it.eye }
        val half = Math.toDegrees(2 * Math.atan(Math.tan(Math.toRadians(20.0)) / 2))
        assertEquals(half, angle(usual.with(ZOOM, 2.0)).first, 1e-12)
        assertEquals(perspective.eye, angle(usual.with(ZOOM, 2.0)).second)
        assertEquals(70.0 to perspective.eye, angle(usual.with(FOV, 70.0)))
        val flat = camera(orthographic, usual.with(ZOOM, 4.0))
        assertEquals(0.25, (flat.projection as Projection.Orthographic).height)
    }

    @Test
    fun modelsWithCamerasAreFittedUnlessOneIsAskedFor() {
        val model = loaded(orthographic, listOf(NamedCamera("one", orthographic), NamedCamera("", perspective)))
        fun chosen(choice: CameraChoice?): String {
            val asked = if (choice == null) usual else usual.with(CAMERA, choice)
            return applied(asked, model).viewpoint.toString()
        }
        assertEquals(Camera.fit().toString(), chosen(null))
        assertEquals(Camera.fit().toString(), chosen(CameraChoice.FIT))
        assertEquals(orthographic.toString(), chosen(CameraChoice.SCENE))
        assertEquals(orthographic.toString(), chosen(CameraChoice.ofModel(0)))
        assertEquals(perspective.toString(), chosen(CameraChoice.ofModel(1)))
        val error = assertThrows(NoPictureException::class.java) { chosen(CameraChoice.ofModel(2)) }
        assertEquals("camera=2: the input has 2: 0 (one), 1", error.message)
        assertEquals(orthographic.toString(), chosen(CameraValues().read("one")))
        val unknown = assertThrows(NoPictureException::class.java) { chosen(CameraValues().read("One")) }
        assertEquals("camera=One: the input has 2: 0 (one), 1", unknown.message)
    }

    @Test
    fun anEyeLooksAtTheMiddleOfTheSceneAndSeesAllOfItsDepth() {
        val camera = camera(Camera.fit(), usual.with(EYE, Vector3d(1.0, 2.0, 9.0)))
        assertEquals(Vector3d(1.0, 2.0, 3.0), camera.target)
        assertTrue(camera.near in 4.9..5.0 && camera.far in 7.0..7.1, "$camera")

        // An eye in the scene, and one that looks away from it
        for (z in listOf(3.5, 5.0)) {
            val asked = usual.with(EYE, Vector3d(1.0, 2.0, z)).with(TARGET, Vector3d(1.0, 2.0, z + 1.0))
            val inside = camera(Camera.fit(), asked)
            assertTrue(inside.near > 0.0 && inside.far > inside.near, "$inside")
        }
    }

    @Test
    fun aTargetMovesAFittedCameraAndTurnsAFixedOne() {
        val target = Vector3d(0.5, 0.0, 3.0)
        val asked = usual.with(TARGET, target)
        val before = camera(Camera.fit(), usual)
        val after = camera(Camera.fit(), asked)
        val way = Vector3d(before.eye).sub(before.target)
        assertEquals(0.0, Vector3d(after.eye).sub(target).distance(way), 1e-12)
        val turned = camera(perspective, asked)
        assertEquals(perspective.eye to target, turned.eye to turned.target)
    }

    @Test
    fun positionsTurnWithTheModel() {
        for (axis in UpAxis.entries) {
            val places = listOf(Vector3d(4.0, 5.0, 9.0), Vector3d(0.0, 1.0, 2.0), Vector3d(0.1, 0.2, 0.3))
            val asked = usual.with(EYE, places[0]).with(TARGET, places[1]).with(CAMERA_UP, places[2])
            val camera = applied(asked, loaded(Camera.fit()), axis).camera(40, 30)
            assertEquals(axis.toWorld(places[0]), camera.eye)
            assertEquals(places[0], axis.toModel(camera.eye))
            assertEquals(axis.toWorld(places[2]), camera.up)
        }
    }

    private companion object {
        val INDICES = intArrayOf(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3)
    }
}
