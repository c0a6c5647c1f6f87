package dev.lazyz.conformance.cases

import dev.lazyz.world.light.AmbientVisibility
import dev.lazyz.world.light.EnvironmentMap
import java.util.Random

/** Small pictures of surroundings for generated scenes: sky of two colours, ground, and lamps. Thread safe. */
public object Skies {
    /** How many there are. */
    public const val COUNT: Int = 4
    private const val WIDTH = 8
    private const val LAMP = 4f

    private val maps = List(COUNT) { number -> lazy { EnvironmentMap.of(WIDTH, WIDTH / 2, picture(number)) } }

    /** Returns picture [number], from 0; the same one for each call. */
    @JvmStatic
    public fun map(number: Int): EnvironmentMap = maps[number].value

    private fun picture(number: Int): FloatArray {
        val random = Random(number.toLong())
        val colors = FloatArray(9) { random.nextFloat() }
        return FloatArray(3 * WIDTH * WIDTH / 2) {
            val row = it / 3 / WIDTH
            val color = colors[3 * minOf(row, 2) + it % 3]
            if (random.nextInt(WIDTH) == 0) LAMP * color else color
        }
    }
}

/**
 * A visibility of ambient light that depends on all coordinates of the point and of the normal, and on nothing else:
 * a linear function of both, clamped to 0..1.
 *
 * Among the suite's surfaces, which are within a few units of the origin, it has all values from 0 to 1; a part of the
 * points has exactly 0, and another exactly 1. Immutable and thread safe.
 *
 * @param seed its six lowest bits are the signs of the six factors
 */
public class Hollows(private val seed: Int) : AmbientVisibility {
    override fun at(x: Float, y: Float, z: Float, normalX: Float, normalY: Float, normalZ: Float): Float {
        val place = signed(0, x) + signed(1, y) + signed(2, z)
        val side = signed(3, normalX) + signed(4, normalY) + signed(5, normalZ)
        val sum = 0.5f + place * PLACE + side * SIDE
        return if (sum > 0f) minOf(sum, 1f) else 0f
    }

    private fun signed(bit: Int, value: Float): Float = if (seed ushr bit and 1 == 0) value else -value

    override fun toString(): String = "Hollows($seed)"

    private companion object {
        const val PLACE = 0.125f
        const val SIDE = 0.25f
    }
}
