package dev.lazyz.scenes.scenefile

import dev.lazyz.scenes.ImageSize
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.light.Light
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Mesh
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Sphere
import dev.lazyz.world.surface.Surface
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull

/** What is written reads back to the same scene, bit for bit. */
class SceneFileProperties {
    @Property(seed = "1995", tries = 300)
    fun everyFieldReadsBack(@ForAll seed: Long) {
        val random = RandomScenes(seed)
        val scene = random.scene()
        val depth = random.depth()
        val size = ImageSize(1 + (seed and 1023).toInt(), 480)
        val loaded = parsed(SceneFile.format(scene, size, depth))
        assertEquals(size, loaded.size)
        assertEquals(depth, loaded.depth)
        assertEquals(emptyList<String>(), loaded.warnings)
        assertEquals(fields(scene), fields(loaded.scene))
    }

    @Property(seed = "1995", tries = 100)
    fun writingAgainGivesTheSameText(@ForAll seed: Long) {
        val text = SceneFile.format(RandomScenes(seed).scene())
        val loaded = parsed(text)
        assertNull(loaded.size)
        assertEquals(text, SceneFile.format(loaded.scene))
    }

    /** All that a scene is made of, as numbers' bits and as text, independent of the writer. */
    private fun fields(scene: Scene): List<Any?> =
        listOf(scene.background, scene.environment, scene.toneMapping, scene.lightIntensity.toBits()) +
            viewpoint(scene) + scene.lights.map(::light) + scene.surfaces.map(::surface)

    private fun surface(surface: Surface): List<Any?> =
        when (surface) {
            is Mesh -> listOf(
                surface.origin, bits(surface.positions),
                surface.triangles.toList(), bits(surface.normals), bits(surface.uvs),
                bits(surface.colors), MaterialFields.of(surface.material),
            )
            is Polygon -> listOf(
                surface.contours.map { contour ->
                    contour.map {
                        listOf(it.x.toBits(), it.y.toBits(), it.z.toBits(), it.u.toBits(), it.v.toBits(), it.color)
                    }
                },
                surface.fillRule, MaterialFields.of(surface.material),
            )
            is Sphere -> listOf(
                surface.center.run { listOf(x().toBits(), y().toBits(), z().toBits()) },
                surface.radius.toBits(), MaterialFields.of(surface.material),
            )
            is Points -> listOf(
                surface.origin, bits(surface.positions),
                surface.size, bits(surface.normals), bits(surface.colors),
                MaterialFields.of(surface.material),
            )
            is Lines -> listOf(
                surface.origin, bits(surface.positions),
                surface.segments.toList(), surface.width, bits(surface.colors),
                MaterialFields.of(surface.material),
            )
            else -> error("not expected: $surface")
        }

    /** The camera for two rasters, by the matrices that set-up uses. */
    private fun viewpoint(scene: Scene): List<Any?> = listOf(0.7, 1.9).map { aspect ->
        val camera = scene.viewpoint.camera(scene, aspect)
        val view = DoubleArray(16).also { camera.viewMatrix().get(it) }
        val projection = DoubleArray(16)
        if (camera.projection != Projection.Screen) camera.projectionMatrix(aspect).get(projection)
        listOf(scene.viewpoint is Camera, (view + projection).map { it.toRawBits() }, camera.near, camera.far)
    }

    private fun light(light: Light): List<Any> = when (light) {
        is Light.Ambient -> listOf("ambient", light.color)
        is Light.Directional -> light.direction.run {
            listOf("directional", x().toBits(), y().toBits(), z().toBits(), light.color)
        }
        is Light.Point -> light.position.run {
            listOf("point", x().toBits(), y().toBits(), z().toBits(), light.color, light.falloff)
        }
        is Light.Spot -> listOf(
            "spot", light.position.run { listOf(x().toBits(), y().toBits(), z().toBits()) },
            light.direction.run { listOf(x().toBits(), y().toBits(), z().toBits()) },
            light.color, light.innerAngle, light.outerAngle, light.falloff,
        )
    }

    private fun bits(floats: FloatArray?): List<Int>? = floats?.map { it.toBits() }
}
