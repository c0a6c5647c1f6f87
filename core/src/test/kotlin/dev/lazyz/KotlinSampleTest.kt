package dev.lazyz

import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import dev.lazyz.world.material.Material
import dev.lazyz.world.scene
import dev.lazyz.world.surface.Sphere
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** Compiles and runs the ten lines of the README. */
class KotlinSampleTest {
    @Test
    fun tenLines() {
        val world = scene {
            add(Sphere(Vector3d(0.0, 0.0, 0.0), 1.0, Material(Rgba.ofRgb(0xD0452F))))
            add(Sphere(Vector3d(1.2, 0.6, 0.4), 0.5, Material(Rgba.ofRgb(0x2F7FD0))))
        }
        val image = ZBufferRenderer().render(world.frame(640, 480))
        println("${image.visible} samples covered, ${image.counters.shadingCalls} shading calls, ${image.pixelHash()}")
        assertEquals(PINNED, image.pixelHash())
    }

    private companion object {
        /** Equal on every machine. It changes only when the contract or the default lights change. */
        const val PINNED = "937eba9c78aca01403a6fc3f149422e33a283f46f443437de74b74e2bfab3feb"
    }
}
