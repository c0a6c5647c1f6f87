package dev.lazyz.shading

import dev.lazyz.world.Camera
import dev.lazyz.world.Light
import dev.lazyz.world.Material
import dev.lazyz.world.Projection
import dev.lazyz.world.Shading
import kotlin.math.sqrt

/**
 * The lighting formula of the contract (rule 6.5): ambient light, Lambert's law, and a highlight.
 *
 * All arithmetic is in single precision, in the order written. Sources: Bui Tuong Phong, "Illumination for Computer
 * Generated Pictures", Communications of the ACM 18 (1975); James Blinn, "Models of Light Reflection for Computer
 * Synthesized Pictures", SIGGRAPH 1977.
 */
internal class Lighting(lights: List<Light>, camera: Camera) {
    private val ambient = FloatArray(3)

    /**
     * The other lights, [STRIDE] numbers each: position, or direction to the light (x, y, z), red, green, blue, and 1
     * for a point light or 0 for a directional light.
     */
    private val sources: FloatArray

    private val isPerspective = camera.projection is Projection.Perspective
    private val eyeX = camera.eye.x().toFloat()
    private val eyeY = camera.eye.y().toFloat()
    private val eyeZ = camera.eye.z().toFloat()
    private val backX: Float
    private val backY: Float
    private val backZ: Float

    init {
        val back = camera.toWorldDirection(0.0, 0.0, 1.0)
        backX = back.x.toFloat()
        backY = back.y.toFloat()
        backZ = back.z.toFloat()
        val numbers = ArrayList<Float>()
        for (light in lights) {
            val color = light.color
            when (light) {
                is Light.Ambient -> {
                    ambient[0] += color.red
                    ambient[1] += color.green
                    ambient[2] += color.blue
                }
                is Light.Directional -> {
                    val d = light.direction
                    numbers += listOf(-d.x().toFloat(), -d.y().toFloat(), -d.z().toFloat())
                    numbers += listOf(color.red, color.green, color.blue, 0f)
                }
                is Light.Point -> {
                    val p = light.position
                    numbers += listOf(p.x().toFloat(), p.y().toFloat(), p.z().toFloat())
                    numbers += listOf(color.red, color.green, color.blue, 1f)
                }
            }
        }
        sources = numbers.toFloatArray()
    }

    /**
     * Computes the light at a point. [out] receives in 0..2 the light that the surface's colour is multiplied by, and
     * in 3..5 the light that is added to the product. The normal can have any length; a normal of length 0 is replaced
     * by the direction to the viewer.
     */
    fun illuminate(
        material: Material,
        px: Float,
        py: Float,
        pz: Float,
        normalX: Float,
        normalY: Float,
        normalZ: Float,
        out: FloatArray,
    ) {
        // Unit vector to the viewer
        var vx = backX
        var vy = backY
        var vz = backZ
        if (isPerspective) {
            vx = eyeX - px
            vy = eyeY - py
            vz = eyeZ - pz
            val length = sqrt(vx * vx + vy * vy + vz * vz)
            vx /= length
            vy /= length
            vz /= length
        }

        // Unit normal
        val length = sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ)
        val nx = if (length > 0f) normalX / length else vx
        val ny = if (length > 0f) normalY / length else vy
        val nz = if (length > 0f) normalZ / length else vz

        // Add up the lights in their order
        for (channel in 0 until 3) out[channel] = ambient[channel]
        out[3] = material.emission.red
        out[4] = material.emission.green
        out[5] = material.emission.blue
        val specular = material.specular
        val isShiny = specular.red > 0f || specular.green > 0f || specular.blue > 0f
        for (at in sources.indices step STRIDE) {
            var lx = sources[at]
            var ly = sources[at + 1]
            var lz = sources[at + 2]
            if (sources[at + 6] != 0f) {
                lx -= px
                ly -= py
                lz -= pz
                val distance = sqrt(lx * lx + ly * ly + lz * lz)
                lx /= distance
                ly /= distance
                lz /= distance
            }
            val cosine = nx * lx + ny * ly + nz * lz
            if (!(cosine > 0f)) continue
            for (channel in 0 until 3) out[channel] += sources[at + 3 + channel] * cosine
            if (!isShiny) continue

            // Cosine for the highlight. Phong: between the reflected ray and the viewer; otherwise between the normal
            // and the halfway vector
            val highlight = if (material.shading == Shading.PHONG) {
                2f * cosine * (nx * vx + ny * vy + nz * vz) - (lx * vx + ly * vy + lz * vz)
            } else {
                val hx = lx + vx
                val hy = ly + vy
                val hz = lz + vz
                (nx * hx + ny * hy + nz * hz) / sqrt(hx * hx + hy * hy + hz * hz)
            }
            if (!(highlight > 0f)) continue
            val strength = power(highlight, material.shininess)
            out[3] += sources[at + 3] * specular.red * strength
            out[4] += sources[at + 4] * specular.green * strength
            out[5] += sources[at + 5] * specular.blue * strength
        }
    }

    private companion object {
        const val STRIDE = 7

        /** Raises [base] to a positive integer by squaring, from the exponent's lowest bit up (rule 6.3). */
        fun power(base: Float, exponent: Int): Float {
            var result = 1f
            var square = base
            var rest = exponent
            while (true) {
                if (rest and 1 != 0) result *= square
                rest = rest ushr 1
                if (rest == 0) return result
                square *= square
            }
        }
    }
}
