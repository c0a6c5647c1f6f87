package dev.lazyz.lighting

import dev.lazyz.Rgba
import dev.lazyz.geometry.Vectors
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.camera.Projection
import dev.lazyz.world.material.Texture
import kotlin.math.sqrt
import org.joml.Vector3dc

/**
 * Colours a surface by its normal as the camera sees it, with the picture of a lit sphere (a "material capture"): the
 * middle of the picture is what faces the camera, the edge of the sphere what is seen at a grazing angle. Lights and
 * other properties of materials have no effect. Immutable and thread safe.
 *
 * ```
 * val clay = Matcap(Scenes.texture(file), camera, scene.origin)
 * val picture = scene.withMaterials { it.withShader(clay) }
 * ```
 *
 * With perspective, the axes turn with the direction to the point, so that a sphere looks like the picture wherever it
 * is. Source: P.-P. Sloan, W. Martin, A. Gooch and B. Gooch, "The Lit Sphere: A Model for Capturing NPR Shading from
 * Art", Graphics Interface 2001.
 *
 * @property texture the picture, square; the sphere touches its sides, and the corners are not read
 * @property tint multiplies its colours
 * @param camera the camera of the picture
 * @param origin [Scene.origin] of the scene
 */
public class Matcap @JvmOverloads constructor(
    public val texture: Texture,
    camera: Camera,
    origin: Vector3dc = Vectors.ZERO,
    public val tint: Rgba = Rgba.WHITE,
) : Shader {
    private val isPerspective = camera.projection is Projection.Perspective
    private val eye = floats(Vectors.minus(camera.eye, origin))
    private val right = floats(camera.toWorldDirection(1.0, 0.0, 0.0))
    private val upward = floats(camera.toWorldDirection(0.0, 1.0, 0.0))
    private val backward = floats(camera.toWorldDirection(0.0, 0.0, 1.0))

    override fun shade(fragment: Fragment) {
        // The direction to the viewer, along the axes of the camera
        var vx = 0f
        var vy = 0f
        var vz = 1f
        if (isPerspective) {
            val x = eye[0] - fragment.worldX
            val y = eye[1] - fragment.worldY
            val z = eye[2] - fragment.worldZ
            vx = along(right, x, y, z)
            vy = along(upward, x, y, z)
            vz = along(backward, x, y, z)
            val distance = sqrt(vx * vx + vy * vy + vz * vz)
            vx /= distance
            vy /= distance
            vz /= distance
        }

        // The normal, along the axes of the picture: the first is at right angles to the viewer and level
        val nx = along(right, fragment.normalX, fragment.normalY, fragment.normalZ)
        val ny = along(upward, fragment.normalX, fragment.normalY, fragment.normalZ)
        val nz = along(backward, fragment.normalX, fragment.normalY, fragment.normalZ)
        val length = sqrt(nx * nx + ny * ny + nz * nz)
        val level = sqrt(vx * vx + vz * vz)
        val across = (nx * vz - nz * vx) / level
        val upright = (ny * (vz * vz + vx * vx) - vy * (nx * vx + nz * vz)) / level
        val scale = if (length > 0f) REACH / length else 0f
        val color = fragment.texel
        texture.sample(0.5f + scale * across, 0.5f - scale * upright, color)
        fragment.setColor(color[0] * tint.red, color[1] * tint.green, color[2] * tint.blue, tint.alpha)
    }

    private fun along(axis: FloatArray, x: Float, y: Float, z: Float) = axis[0] * x + axis[1] * y + axis[2] * z

    private fun floats(v: Vector3dc) = floatArrayOf(v.x().toFloat(), v.y().toFloat(), v.z().toFloat())

    override fun toString(): String = "Matcap($texture, $tint)"

    private companion object {
        /** Radius of the sphere in the picture, a little smaller so that no texel beyond its edge is read. */
        const val REACH = 0.49f
    }
}
