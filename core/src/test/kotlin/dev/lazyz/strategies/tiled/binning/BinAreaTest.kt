package dev.lazyz.strategies.tiled.binning

import dev.lazyz.Region
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.VisibilityBuffer
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Places of fragments in bands of any length. */
class BinAreaTest {
    private fun band(width: Int, height: Int, size: Int) = TileGrid(Region(100, 7, 100 + width, 7 + height), size)

    @Test
    fun samplesOfLongBandsKeepTheirTileAndPlace() {
        for (size in listOf(8, 64, 512)) {
            for (width in listOf(1, size - 1, size + 1, 262_144, (1 shl 23) - 1, 1 shl 23)) {
                for (height in listOf(1, 3, size)) {
                    val grid = band(width, height, size)
                    val area = BinArea(grid, 0, 1)
                    val (x, y) = width - 1 to height - 1
                    val location = area.locate(100 + x, 7 + y)
                    val place = y * VisibilityBuffer.stride(grid) + x % size
                    assertEquals(listOf(x / size, place), listOf(area.tileOf(location), area.placeOf(location)))
                }
            }
        }
    }

    @Test
    fun bandsOfTooManySamplesAreRefused() {
        val error = assertThrows(IllegalArgumentException::class.java) { BinArea(band((1 shl 23) + 1, 512, 512), 0, 1) }
        assertTrue("smaller tiles" in error.message!!, error.message)
    }
}
