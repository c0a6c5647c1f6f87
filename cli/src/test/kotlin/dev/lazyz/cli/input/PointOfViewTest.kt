package dev.lazyz.cli.input

import dev.lazyz.world.Camera
import dev.lazyz.world.Fit
import dev.lazyz.world.FittedViewpoint
import dev.lazyz.world.Scene
import dev.lazyz.world.Viewpoint
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test

class PointOfViewTest {
    private fun seen(own: Viewpoint, asked: PointOfView): Viewpoint =
        asked.applyTo(Scene(emptyList(), emptyList(), own)).viewpoint

    private fun fitted(own: Viewpoint, asked: PointOfView): List<Any> =
        (seen(own, asked) as FittedViewpoint).let { listOf(it.azimuth, it.elevation, it.zoom, it.kind) }

    private val zoomed = PointOfView(null, null, null, 3.0, null)

    @Test
    fun scenesKeepTheirCameraUnlessAsked() {
        val own = Camera.fit(1.0, 2.0)
        assertSame(own, seen(own, PointOfView(null, null, null, null, null)))
    }

    @Test
    fun whatIsNotAskedStaysAsTheFittedCameraHasIt() {
        val own = Camera.fit(1.0, 2.0, 4.0, Fit.ORTHOGRAPHIC)
        assertEquals(listOf(1.0, 2.0, 3.0, Fit.ORTHOGRAPHIC), fitted(own, zoomed))
        val asked = PointOfView(View.LEFT, null, 7.0, null, Fit.PERSPECTIVE)
        assertEquals(listOf(-90.0, 7.0, 4.0, Fit.PERSPECTIVE), fitted(own, asked))
    }

    @Test
    fun aFixedCameraIsReplacedByOneThatLooksTheSameWay() {
        val up = Vector3d(0.0, 1.0, 0.0)
        val right = Camera.orthographic(Vector3d(9.0, 0.0, 0.0), Vector3d(), up, 1.0, 0.0, 20.0)
        assertEquals(listOf(90.0, 0.0, 3.0, Fit.ORTHOGRAPHIC), fitted(right, zoomed))
        val top = Camera.perspective(Vector3d(0.0, 5.0, 0.0), Vector3d(), up, 40.0, 1.0, 20.0)
        assertEquals(listOf(90.0, 3.0, Fit.PERSPECTIVE), fitted(top, zoomed).drop(1))
    }

    @Test
    fun aRuleOfOnesOwnIsReplacedByTheDefault() {
        val rule = Viewpoint { _, _ -> error("not asked") }
        assertEquals(listOf(30.0, 20.0, 3.0, Fit.PERSPECTIVE), fitted(rule, zoomed))
    }
}
