package dev.lazyz.conformance.cases

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
