package dev.lazyz.strategies.tiled.binning

import dev.lazyz.DepthTest
import dev.lazyz.Region
import dev.lazyz.setup.TriangleBatch
import dev.lazyz.setup.triangleBatch
import dev.lazyz.shared.NotByDefault
import dev.lazyz.strategies.tiled.raster.TileGrid
import dev.lazyz.strategies.tiled.raster.TriangleForms
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Mesh
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue

/** Compares the tiles that a triangle reaches or covers completely with the samples that it covers. */
class CoarseRasterProperties {
    @Property(tries = 40, seed = "1988", edgeCases = EdgeCasesMode.NONE)
    @AddLifecycleHook(NotByDefault::class)
    fun tilesAreWhatTheirSamplesSay(@ForAll seed: Long) {
        val random = Random(seed)
        val batch = batch(random)
        var whole = 0
        for (tileSize in listOf(1, 2, 4, 8)) {
            val grid = TileGrid(Region(0, 0, SIDE, SIDE), tileSize)
            val bandStart = random.nextInt(grid.bands)
            val area = BinArea(grid, bandStart, bandStart + 1 + random.nextInt(grid.bands - bandStart))
            val first = random.nextInt(area.bands)
            val end = first + 1 + random.nextInt(area.bands - first)
            val tiles = CoarseRaster(area, grid)
            for (triangle in 0 until batch.count) {
                val hidden = random.nextInt(area.tiles)
                val found = HashMap<Int, Boolean>()
                if (tiles.begin(batch, triangle, first, end) > 0) {
                    tiles.forEach({ it == hidden }) { tile, isCovered ->
                        assertTrue(found.put(tile, isCovered) == null) { "seed $seed: tile $tile twice" }
                    }
                }
                for (band in area.band(0) until area.band(area.bands)) {
                    for (column in 0 until grid.columns) {
                        val tile = area.tile(band, column)
                        val covered = covered(batch, triangle, grid, band, column)
                        val isAsked = band in area.band(first) until area.band(end) && tile != hidden
                        val what = "seed $seed, tileSize $tileSize, triangle $triangle, band $band, tile $column"
                        if (!isAsked) assertTrue(tile !in found) { what }
                        if (isAsked && covered > 0) assertTrue(tile in found) { what }
                        if (found[tile] == true) assertEquals(tileSize * tileSize, covered) { what }
                        if (found[tile] == true) whole++
                    }
                }
            }
        }
        assertTrue(whole > 100) { "seed $seed: $whole" }
    }

    /** Number of samples of a tile that a triangle covers. */
    private fun covered(batch: TriangleBatch, triangle: Int, grid: TileGrid, band: Int, column: Int): Int {
        val (a, b, c) = List(3) { batch.place(triangle, it) }
        val xy = batch.grid
        val forms = TriangleForms(DepthTest.LESS)
        var covered = 0
        for (y in grid.rowStart(band) until grid.rowEnd(band)) {
            for (x in grid.columnStart(column) until grid.columnEnd(column)) {
                forms.edges(xy[a], xy[a + 1], xy[b], xy[b + 1], xy[c], xy[c + 1], x, y)
                if (forms.e0 or forms.e1 or forms.e2 >= 0) covered++
            }
        }
        return covered
    }

    /**
     * Triangles whose vertices are samples, so that edges pass through many samples; and some with arbitrary vertices.
     */
    private fun batch(random: Random): TriangleBatch {
        val positions = FloatArray(9 * COUNT) { i ->
            val sample = random.nextInt(SIDE + 8) - 4 + if (i / 9 % 4 == 0) random.nextFloat() else 0.5f
            if (i % 3 == 2) 0f else 2 * sample / SIDE - 1
        }
        val camera = Camera.orthographic(Vector3d(0.0, 0.0, 5.0), Vector3d(), Vector3d(0.0, 1.0, 0.0), 2.0, 1.0, 9.0)
        val mesh = Mesh(positions, IntArray(3 * COUNT) { it }, Material())
        return Scene(listOf(mesh), emptyList(), camera).frame(SIDE, SIDE).content.triangleBatch(0)
    }

    private companion object {
        const val SIDE = 32
        const val COUNT = 60
    }
}
