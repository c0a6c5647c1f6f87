package dev.lazyz.conformance.frames.world

import dev.lazyz.Raster
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.Camera
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators
import org.joml.Vector3d

/**
 * Generates cameras that look at the origin, around which the shapes are. Their field of view is about as large as the
 * shapes.
 */
internal object WorldCameras {
    /** A camera without a raster. The wider the raster, the smaller the field of view from top to bottom. */
    class Aim(private val eye: Vector3d, private val lens: Lens) {
        fun on(raster: Raster): Coded<Camera> {
            val part = minOf(1.0, raster.height.toDouble() / raster.width)
            val line = "${code(eye)}, Vector3d(), Vector3d(0.0, 1.0, 0.0)"
            val up = Vector3d(0.0, 1.0, 0.0)
            if (lens.angle > 0.0) {
                val angle = lens.angle * part
                val camera = Camera.perspective(eye, Vector3d(), up, angle, NEAR, FAR)
                return Coded(camera, "Camera.perspective($line, $angle, $NEAR, $FAR)")
            }
            val height = lens.height * part
            val camera = Camera.orthographic(eye, Vector3d(), up, height, NEAR, FAR)
            return Coded(camera, "Camera.orthographic($line, $height, $NEAR, $FAR)")
        }
    }

    /** The vertical field of view in degrees or, if that is 0, the height in world units. */
    enum class Lens(val angle: Double, val height: Double) {
        USUAL(40.0, 0.0),
        PARALLEL(0.0, 4.0),
        WIDE(60.0, 0.0),
        CLOSE(0.0, 3.0),
    }

    /** Half of the cameras look along the z axis, so that surfaces of constant z are parallel to the screen. */
    fun aims(): Arbitrary<Aim> {
        val straight = ints(3, 6).map { Vector3d(0.0, 0.0, it.toDouble()) }
        val oblique = Combinators.combine(ints(-3, 3), ints(-3, 3), ints(2, 5))
            .`as` { x, y, z -> Vector3d(x.toDouble(), y.toDouble(), z.toDouble()) }
        return Combinators.combine(mixed(1 to straight, 1 to oblique), oneOf(*Lens.values())).`as`(::Aim)
    }

    private const val NEAR = 0.5
    private const val FAR = 10.0
}
