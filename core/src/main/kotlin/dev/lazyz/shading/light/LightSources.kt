package dev.lazyz.shading.light

import dev.lazyz.world.light.Light
import dev.lazyz.world.light.Light.Falloff
import kotlin.math.sqrt
import org.joml.Vector3dc

/**
 * The lights of a scene as numbers in single precision: the sum of the ambient lights, and the others in their order.
 * Immutable and thread safe.
 */
internal class LightSources(lights: List<Light>) {
    /** Red, green and blue of the ambient light. */
    @JvmField val ambient: FloatArray = FloatArray(3)

    /** Number of the other lights. */
    @JvmField val count: Int

    /** [STRIDE] numbers for each of the other lights, see the constants. */
    @JvmField val numbers: FloatArray

    init {
        val all = ArrayList<Float>()
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
                    all += listOf(-d.x().toFloat(), -d.y().toFloat(), -d.z().toFloat())
                    all += listOf(color.red, color.green, color.blue, DISTANT)
                    all += List(STRIDE - FALLOFF) { 0f }
                }
                is Light.Point -> {
                    all += position(light.position)
                    all += listOf(color.red, color.green, color.blue)
                    all += if (light.falloff == Falloff.NONE) UNIFORM else VARYING
                    all += falloff(light.falloff) + listOf(0f, 0f, 0f, 0f, 1f)
                }
                is Light.Spot -> {
                    val d = light.direction
                    val outer = cosine(light.outerAngle)
                    val scale = 1.0 / maxOf(LEAST_EDGE, cosine(light.innerAngle) - outer)
                    all += position(light.position)
                    all += listOf(color.red, color.green, color.blue, VARYING)
                    all += falloff(light.falloff)
                    all += listOf(d.x().toFloat(), d.y().toFloat(), d.z().toFloat())
                    all += listOf(scale.toFloat(), (-outer * scale).toFloat())
                }
            }
        }
        numbers = all.toFloatArray()
        count = numbers.size / STRIDE
    }

    /** Returns component [channel], 0..2, of the colour of light number [light]. */
    fun color(light: Int, channel: Int): Float = numbers[STRIDE * light + COLOR + channel]

    /**
     * Passes the unit vector from the point ([px], [py], [pz]) to light number [light] to [use], and the factor of the
     * light's colour there.
     */
    inline fun from(light: Int, px: Float, py: Float, pz: Float, use: (Float, Float, Float, Float) -> Unit) {
        val numbers = numbers
        val at = STRIDE * light
        var lx = numbers[at]
        var ly = numbers[at + 1]
        var lz = numbers[at + 2]
        var strength = 1f
        val kind = numbers[at + KIND]
        if (kind != DISTANT) {
            lx -= px
            ly -= py
            lz -= pz
            val distance = sqrt(lx * lx + ly * ly + lz * lz)
            lx /= distance
            ly /= distance
            lz /= distance
            if (kind == VARYING) strength = strength(at, lx, ly, lz, distance)
        }
        use(lx, ly, lz, strength)
    }

    /** Returns falloff times the factor of the cone, for the light whose numbers start at [at]; for [from] only. */
    fun strength(at: Int, lx: Float, ly: Float, lz: Float, distance: Float): Float {
        var strength = 1f
        if (numbers[at + FALLOFF] != 0f) {
            val part = distance * numbers[at + FALLOFF + 1]
            val window = 1f - part * part * (part * part)
            if (!(window > 0f)) return 0f
            strength = minOf(window, 1f) / (distance * distance)
        }
        val cosine = -(numbers[at + CONE] * lx + numbers[at + CONE + 1] * ly + numbers[at + CONE + 2] * lz)
        val edge = cosine * numbers[at + CONE + 3] + numbers[at + CONE + 4]
        if (!(edge > 0f)) return 0f
        return if (edge < 1f) strength * (edge * edge) else strength
    }

    private fun position(p: Vector3dc) = listOf(p.x().toFloat(), p.y().toFloat(), p.z().toFloat())

    private fun falloff(falloff: Falloff) =
        listOf(if (falloff.isInverseSquare) 1f else 0f, (1.0 / falloff.range).toFloat())

    private fun cosine(degrees: Double) = StrictMath.cos(degrees * (StrictMath.PI / 180.0))

    companion object {
        /** Offset of red, green and blue. Before it is the position, or the direction to a distant light. */
        const val COLOR: Int = 3

        /** Offset of the kind: [DISTANT], [UNIFORM] or [VARYING]. */
        const val KIND: Int = 6

        /** Offset of 1 for inverse squares or 0, and 1 / range. */
        private const val FALLOFF = 7

        /** Offset of the cone: its axis, and the factor and the summand that make the soft edge of the cosine. */
        private const val CONE = 9
        const val STRIDE: Int = 14

        /** A directional light. */
        const val DISTANT: Float = 0f

        /** A point light of the same strength everywhere. */
        const val UNIFORM: Float = 1f

        /** A light whose strength depends on the place. */
        const val VARYING: Float = 2f

        /** The smallest difference of the cosines of a cone's soft edge, as in `KHR_lights_punctual`. */
        private const val LEAST_EDGE = 0.001
    }
}
