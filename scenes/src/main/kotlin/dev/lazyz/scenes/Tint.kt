package dev.lazyz.scenes

import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader

/**
 * A test pattern: colour and opacity are a hash of a number, the sample's position and the fragment's
 * [Fragment.worldZ], so they are almost always different for two numbers or at two samples.
 *
 * The colours of an image show whether the right primitive was shaded, at the right sample, with the right
 * attributes, and how often alpha was used. This is the only custom shader that can be written to a scene file.
 * Immutable and thread safe.
 *
 * @property number a different number gives different colours
 */
public class Tint(public val number: Int) : Shader {
    override fun shade(fragment: Fragment) {
        val bits = hash(number, fragment.x, fragment.y, fragment.worldZ.toRawBits())
        fragment.setColor(
            (bits and 0xFF) / 255f,
            (bits ushr 8 and 0xFF) / 255f,
            (bits ushr 16 and 0xFF) / 255f,
            (bits ushr 24) / 127f,
        )
    }

    override fun equals(other: Any?): Boolean = other is Tint && number == other.number

    override fun hashCode(): Int = number

    override fun toString(): String = "Tint($number)"

    public companion object {
        /** Mixes four numbers into 31 bits (the finaliser of MurmurHash3, by Austin Appleby, after each). */
        @JvmStatic
        public fun hash(a: Int, b: Int, c: Int, d: Int): Int = mix(mix(mix(mix(a) + b) + c) + d) ushr 1

        private fun mix(value: Int): Int {
            var h = value + 0x7F4A7C15
            h = (h xor (h ushr 16)) * -0x7A143595
            h = (h xor (h ushr 13)) * -0x3D4D51CB
            return h xor (h ushr 16)
        }
    }
}
