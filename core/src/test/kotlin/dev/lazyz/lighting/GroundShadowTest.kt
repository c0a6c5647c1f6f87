package dev.lazyz.lighting

import dev.lazyz.Image
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.filter.SuperSampling
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.FittedViewpoint.Fit
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty

class GroundShadowTest {
    private fun picture(scene: Scene, viewpoint: Camera, background: Rgba, strength: Float = 0.6f): Image {
        val shadow = shadow(scene, strength)
        val all = scene.withSurfaces(scene.surfaces + shadow).withViewpoint(shadow.camera(viewpoint))
        return ZBufferRenderer().render(all.frame(Raster(80, 60, background)))
    }

    private val fromAbove = Camera.fit(0.0, 30.0, zoom = 0.6).camera(scene, 80.0 / 60.0)

    /** Rows from the horizon down at which the ground is seen, in the column [x]. */
    private fun ground(image: Image, x: Int) = (0 until 60).filter { image.primitive(x, it) >= 2 }

    @Test
    fun theGroundIsDarkestBelowTheSceneAndFadesToTheBackground() {
        val image = picture(scene, Camera.fit(0.0, 30.0, zoom = 0.2).camera(scene, 80.0 / 60.0), Rgba.WHITE)
        val middle = ground(image, 40)
        assertTrue(middle.isNotEmpty())
        assertTrue(image.argb.all { it ushr 24 == 0xFF })
        val darkest = middle.minOf { image.argb(40, it) and 0xFF }
        assertTrue(darkest < 225) { "darkest $darkest" }

        // Beside the balls, both ends of each column are borders
        for (x in 0..30) {
            for (y in ground(image, x).let { listOfNotNull(it.firstOrNull(), it.lastOrNull()) }) {
                assertTrue(image.argb(x, y) and 0xFF > 250) { "border of the ground at ($x, $y)" }
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun strengthScalesTheShadow() {
        assertTrue(ground(picture(scene, fromAbove, Rgba.WHITE), 40).isNotEmpty())
        val none = picture(scene, fromAbove, Rgba.WHITE, 0f)
        assertTrue((0 until 80).all { x -> ground(none, x).all { none.argb(x, it) == -1 } })
        val weak = picture(scene, fromAbove, Rgba.WHITE, 0.3f)
        val strong = picture(scene, fromAbove, Rgba.WHITE, 1f)
        assertTrue(strong.argb.indices.all { strong.argb[it] and 0xFF <= weak.argb[it] and 0xFF })
        assertThrows(IllegalArgumentException::class.java) { GroundShadow.of(scene, 1.01f) }
    }

    /** Black with alpha over a colour gives what is rendered in front of the colour. */
    @Test
    fun transparentBackgroundsGetTheShadowAsAlpha() {
        val color = Rgba(0.3f, 0.6f, 0.9f)
        val opaque = picture(scene, fromAbove, color)
        val clear = picture(scene, fromAbove, Rgba.TRANSPARENT)
        val half = picture(scene, fromAbove, color.withAlpha(0.5f))
        for (x in 0 until 80) {
            for (y in ground(clear, x)) {
                assertEquals(0, clear.argb(x, y) and 0xFFFFFF)
                val shadow = (clear.argb(x, y) ushr 24) / 255f
                assertEquals(color.scaled(1f - shadow).blue, Rgba.ofArgb(opaque.argb(x, y)).blue, 0.012f)
                assertEquals(shadow + 0.5f * (1f - shadow), (half.argb(x, y) ushr 24) / 255f, 0.006f)
            }
        }
    }

    /** Without a hard edge: the border is the background, and from there the shadow grows slowly. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun theShadowEndsInsideThePicture() {
        val shadow = shadow(low, strength = 1f)
        for (kind in Fit.entries) {
            for ((elevation, zoom) in listOf(12.0 to 1.0, 40.0 to 1.0, 60.0 to 1.0, 40.0 to 1.4)) {
                val viewpoint = Camera.fit(0.0, elevation, zoom, kind, margin = 12.0).camera(low, 80.0 / 60.0)
                val all = low.withSurfaces(low.surfaces + shadow).withViewpoint(shadow.camera(viewpoint))
                val image = SuperSampling(2).frame(all, Raster(160, 120, Rgba.WHITE)).render(ZBufferRenderer())
                fun code(x: Int, y: Int) = if (image.primitive(x, y) == 0) 0xFF else image.argb(x, y) and 0xFF
                val where = "$kind, elevation $elevation, zoom $zoom"
                val darkest = image.argb.indices.filter { image.primitive[it] > 0 }.minOf { image.argb[it] and 0xFF }
                assertTrue(darkest < 0xF0) { "$darkest, $where" }
                for (x in 0 until 160) for (y in listOf(0, 119)) assertEquals(0xFF, code(x, y)) { "($x, $y), $where" }
                for (y in 0 until 120) for (x in listOf(0, 159)) assertEquals(0xFF, code(x, y)) { "($x, $y), $where" }
                for (x in 0 until 160) assertTrue(code(x, 118) > 0xF8 && code(x, 117) > 0xF0) { "column $x, $where" }
            }
        }
    }

    /** As `docs/light.md` shows. */
    @Test
    fun aRuleInPlaceOfACameraFitsPicturesOfAnyShape() {
        val shadow = shadow(scene)
        val all = scene.withSurfaces(scene.surfaces + shadow)
            .withViewpoint { seen, aspect -> shadow.camera(scene.viewpoint.camera(seen, aspect)) }
        for ((width, height) in listOf(80 to 60, 30 to 90)) {
            assertEquals("${shadow.camera(scene.camera(width, height))}", "${all.camera(width, height)}")
        }
    }

    private companion object {
        /** A ball that floats above its ground, which a second ball determines. */
        val scene = Scene(
            listOf(Sphere(Vector3d(0.0, 2.0, 0.0), 1.0, Material()), Sphere(Vector3d(0.0, 0.1, 0.0), 0.1, Material())),
        )

        /** A ball that lies on the ground, so that its shadow is dark. */
        val low = Scene(listOf(Sphere(Vector3d(0.0, 1.0, 0.0), 1.0, Material())))

        /** By scene and strength: a shadow takes longer than a picture. */
        private val shadows = HashMap<Pair<Scene, Float>, GroundShadow>()

        fun shadow(scene: Scene, strength: Float = 0.6f): GroundShadow =
            shadows.getOrPut(scene to strength) { GroundShadow.of(scene, strength) }
    }
}
