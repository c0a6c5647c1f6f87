package dev.lazyz.scenes.pictures

import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.geometry.Box
import dev.lazyz.lighting.LightRig
import dev.lazyz.scenes.LoadedScene
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What [PictureSettings] and [LoadedScene.lit] say about what is not possible. */
class PictureSettingsFailureTest {
    private val ball = LoadedScene(Scene(listOf(Sphere(Vector3d(), 1.0))), emptyList())

    private fun message(block: () -> Unit) = assertThrows(IllegalArgumentException::class.java, block).message.orEmpty()

    @Test
    fun whatCannotBeShownIsNoPicture() {
        val far = PictureSettings(40, 30).withViewpoint(Camera.fit(fieldOfView = 1e-320))
        assertThrows(NoPictureException::class.java) { far.frame(ball) }
        val fine = PictureSettings(Raster.MAX_SIDE, 1).with(PictureParameters.AA, 2)
        val error = assertThrows(NoPictureException::class.java) { fine.frame(ball) }
        assertTrue("a side has at most" in error.message.orEmpty()) { "${error.message}" }
    }

    /** A service must not report its own bug as a mistake of the client. */
    @Test
    fun otherFailuresStayWhatTheyAre() {
        val faulty = object : Surface {
            override val bounds: Box = Box(0.0, 0.0, 0.0, 1.0, 1.0, 1.0)

            override fun primitives(setUp: SetUp): Sequence<Primitive> = throw IllegalArgumentException("a bug")
        }
        val scene = LoadedScene(Scene(listOf(faulty)), emptyList())
        val error = assertThrows(IllegalArgumentException::class.java) { PictureSettings(40, 30).frame(scene) }
        assertEquals(IllegalArgumentException::class.java, error.javaClass)
    }

    @Test
    fun lightNeedsACameraAndANumberThatIsNotNegative() {
        val missing = message { ball.lit(ball.scene, LightRig.SUN, null) }
        assertTrue("FittedViewpoint" in missing, missing)
        assertTrue("use scene.withViewpoint(scene.camera(width, height))" in missing, missing)

        // The number is checked first
        val negative = message { ball.lit(ball.scene, LightRig.SUN, -1f) }
        assertEquals("intensity of light must be 0 or more: -1.0", negative)
    }
}
