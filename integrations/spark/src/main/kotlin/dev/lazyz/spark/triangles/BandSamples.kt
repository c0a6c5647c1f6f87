package dev.lazyz.spark.triangles

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Region

/**
 * The nearest fragment so far of each sample of a band: its key, which is made of depth and submission index (contract
 * rule 5.3), and its colour. Not thread safe. Memory: 12 bytes a sample.
 */
internal class BandSamples(private val raster: Raster, val region: Region) {
    private val background = raster.depthTest.key(raster.backgroundDepth, DepthTest.BACKGROUND)
    private val keys = LongArray(region.size.toInt()) { background }
    private val argb = IntArray(region.size.toInt())

    /** Adds a fragment, which counts if its key is smaller. */
    fun add(x: Int, y: Int, key: Long, color: Int) {
        val at = (y - region.rowStart) * region.width + x - region.columnStart
        if (key < keys[at]) {
            keys[at] = key
            argb[at] = color
        }
    }

    /** Adds all [fragments]. */
    fun add(fragments: FragmentRuns): Unit = fragments.forEach(region) { x, y, key, color -> add(x, y, key, color) }

    /** Returns all visible fragments, with colours or without. */
    fun toRuns(isShaded: Boolean): FragmentRuns {
        val runs = FragmentRuns.Builder(isShaded)
        for (i in keys.indices) if (keys[i] != background) runs.add(i, keys[i], argb[i])
        return runs.build()
    }

    /** The submission indices of the visible primitives, each once. */
    fun visible(): IntArray {
        val all = IntArray(keys.count { it != background })
        var count = 0
        for (key in keys) if (key != background) all[count++] = raster.depthTest.indexOf(key)
        all.sort()
        return all.distinct().toIntArray()
    }

    /** Passes the rows to [take], with the background where nothing is visible. The arrays are used again. */
    fun forEachRow(take: (y: Int, argb: IntArray, depth: IntArray, primitive: IntArray) -> Unit) {
        val paper = raster.background.toArgb()
        val colors = IntArray(region.width)
        val depth = IntArray(region.width)
        val primitive = IntArray(region.width)
        for (y in region.rowStart until region.rowEnd) {
            val start = (y - region.rowStart) * region.width
            for (x in 0 until region.width) {
                val key = keys[start + x]
                colors[x] = if (key == background) paper else argb[start + x]
                depth[x] = raster.depthTest.depthOf(key)
                primitive[x] = raster.depthTest.indexOf(key)
            }
            take(y, colors, depth, primitive)
        }
    }
}
