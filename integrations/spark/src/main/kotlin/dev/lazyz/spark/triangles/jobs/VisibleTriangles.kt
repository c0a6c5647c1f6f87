package dev.lazyz.spark.triangles.jobs

import dev.lazyz.spark.triangles.TriangleChunk
import java.io.Serializable

/**
 * The triangles that are visible in each band. Immutable. Memory: 8 bytes for each triangle and band, at most one for
 * each sample.
 */
internal class VisibleTriangles(bands: List<OfBand>) : Serializable {
    /** The triangles of a band, and what it took to find them. */
    class OfBand(val band: Int, val indices: IntArray, val cost: Cost) : Serializable

    /**
     * What it took to find the triangles of a band.
     *
     * @property moved bytes that have crossed from task to task
     * @property work counters, as [BandPart.work]
     */
    class Cost(val moved: Long, val work: LongArray) : Serializable

    /** Index and band of each visible triangle, in ascending order. */
    private val places = LongArray(bands.sumOf { it.indices.size })
    private val costs: Map<Int, Cost> = bands.associate { it.band to it.cost }

    init {
        var count = 0
        for (of in bands) for (index in of.indices) places[count++] = place(index, of.band)
        places.sort()
    }

    /** Returns what it took to find the triangles of [band]. */
    fun cost(band: Int): Cost = costs.getValue(band)

    /** Returns the triangles of [chunk] that are visible in each band, by the number of the band. */
    fun byBand(chunk: TriangleChunk): Map<Int, TriangleChunk> {
        val numbers = HashMap<Int, ArrayList<Int>>()
        val found = places.binarySearch(place(chunk.index(0), 0))
        var next = if (found < 0) -found - 1 else found
        var number = 0
        while (next < places.size && number < chunk.size) {
            val index = (places[next] ushr Int.SIZE_BITS).toInt()
            when {
                chunk.index(number) < index -> number++
                chunk.index(number) > index -> next++
                else -> numbers.getOrPut(places[next++].toInt()) { ArrayList() } += number
            }
        }
        return numbers.mapValues { (_, some) -> chunk.select(some.toIntArray()) }
    }

    private companion object {
        fun place(index: Int, band: Int): Long = index.toLong() shl Int.SIZE_BITS or band.toLong()
    }
}
