package dev.lazyz.scenes.builtin

import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureWrap

/** Textures of walls with windows: four by four windows, in pale colours that the house tints. */
internal object Facade {
    /** Height of a storey, and width of a window including the wall beside it, in metres. */
    const val FLOOR = 3.2

    private const val WINDOWS = 4

    /** Width and height of wall that one texture covers, in metres. */
    const val TILE = FLOOR * WINDOWS

    private const val CELL = 16
    private const val SIDE = CELL * WINDOWS

    private class Style(val wall: Int, val ledge: Int, val glass: List<Int>, val columns: IntRange, val rows: IntRange)

    private val styles = listOf(
        Style(0xE6DCCB, 0xCFC3AF, listOf(0x5B6C7C, 0x66788A, 0x4F5E6C), 4..11, 4..13),
        Style(0xC98E70, 0xDCC7B0, listOf(0x4C5A66, 0x58676F, 0xE2C987), 4..11, 4..11),
        Style(0xB9C4CC, 0x93A2AE, listOf(0x6F8CA3, 0x7E9BB0, 0x617C92), 0..13, 2..13),
        Style(0xD8D4CE, 0xBDB8B1, listOf(0x55606B, 0x616D78, 0xD8C38C), 2..13, 6..11),
    )

    fun texture(kind: Int, random: SplitMix): Texture {
        val style = styles[kind]
        val panes = IntArray(WINDOWS * WINDOWS) { style.glass[random.below(style.glass.size)] }
        val texels = IntArray(SIDE * SIDE) {
            val x = it % SIDE
            val y = it / SIDE
            val isWindow = x % CELL in style.columns && y % CELL in style.rows
            val rgb = when {
                isWindow -> panes[y / CELL * WINDOWS + x / CELL]
                y % CELL >= CELL - 2 -> style.ledge
                else -> style.wall
            }
            rgb or (0xFF shl 24)
        }
        return Texture(
            SIDE, SIDE, texels, TextureFilter.BILINEAR, TextureWrap.REPEAT, TextureWrap.REPEAT, "facade-$kind",
        )
    }
}
