package dev.lazyz.swing

import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.camera.FittedViewpoint.View
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource

/** The camera that goes around a point. */
class OrbitTest {
    private val scene = Scenes.teapot(2)
    private val center = checkNotNull(scene.bounds).center

    private fun pixel(camera: Camera, point: Vector3d) = checkNotNull(camera.pixel(point, 400, 300))

    private fun shown(orbit: Orbit): Camera {
        val loaded = LoadedScene(scene, emptyList())
        val source = Source("teapot") { loaded }
        orbit.on(PictureSettings(400, 300), UpAxis.Y).frame(loaded, observer = source)
        return checkNotNull(source.camera)
    }

    /** A fitted camera, its orbit, and the settings that the orbit makes show a point at the same place. */
    @ParameterizedTest
    @EnumSource(View::class)
    fun anOrbitShowsWhatItsCameraShows(view: View) {
        for (kind in Fit.entries) {
            val fitted = Camera.fit(view.azimuth, view.elevation, kind = kind).camera(scene, 4.0 / 3)
            val again = shown(Orbit.of(fitted, center))
            for (point in listOf(center, Vector3d(center).add(0.5, 0.2, -0.3))) {
                assertTrue(pixel(fitted, point).distance(pixel(again, point)) < 1e-6, "$view $kind $point")
            }
        }
    }

    @ParameterizedTest
    @EnumSource(Fit::class)
    fun zoomingKeepsWhatIsUnderThePointer(kind: Fit) {
        val orbit = Orbit.of(Camera.fit(30.0, 20.0, kind = kind).camera(scene, 4.0 / 3), center)
        val middle = pixel(shown(orbit), center)
        val larger = orbit.zoomed(4.0, (middle.x - 200) / 300, (150 - middle.y) / 300)
        assertTrue(middle.distance(pixel(shown(larger), center)) < 1e-6)
        val aside = Vector3d(center).add(0.1, 0.0, 0.0)
        val before = pixel(shown(orbit), aside).distance(middle)
        val after = pixel(shown(larger), aside).distance(middle)
        assertTrue(after / before in 3.0..5.0, "$before $after")
    }

    @ParameterizedTest
    @EnumSource(Fit::class)
    fun movingAndTurningAreThoseOfThePicture(kind: Fit) {
        val orbit = Orbit.of(Camera.fit(30.0, 20.0, kind = kind).camera(scene, 4.0 / 3), center)
        val before = pixel(shown(orbit), center)
        val moved = pixel(shown(orbit.moved(-0.1, 0.2)), center)
        assertEquals(before.x + 30, moved.x, 1e-6)
        assertEquals(before.y + 60, moved.y, 1e-6)
        assertEquals(45.0, orbit.turned(15.0, 100.0).azimuth, 1e-9)
        assertEquals(90.0, orbit.turned(15.0, 100.0).elevation, 1e-9)
        assertEquals(null, orbit.takeIf { kind == Fit.PERSPECTIVE }?.withOtherProjection()?.fieldOfView)
    }
}
