package dev.lazyz.spark.scaling

import dev.lazyz.spark.triangles.BandSamples
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PartPicturesTest {
    private val pictures = PartPictures(BumpySphere(rings = 20), 256, 128, bandRows = 32)
    private val parts = 8

    /** The keys and colours of all samples, in a hash. */
    private fun hash(pieces: List<Held>): Int {
        val all = pieces.sortedBy { it.key.band }
        assertEquals(all.map { it.key.band }.distinct().size, all.size)
        val seen = ArrayList<Any>()
        for (piece in all) {
            val samples = BandSamples(pictures.setUp.drawing().raster, pictures.setUp.region(piece.key.band))
            samples.add(piece.part.runs)
            samples.forEachRow { y, argb, depth, primitive ->
                seen.add(listOf(y, argb.contentHashCode(), depth.contentHashCode(), primitive.contentHashCode()))
            }
        }
        assertEquals(128, seen.size)
        return seen.hashCode()
    }

    @Test
    fun mergingInAnyOrderGivesThePictureOfOneRendering() {
        val expected = hash(pictures.draw(0, 1, Split.RANGES).value)
        for (split in Split.entries) {
            val drawn = (0 until parts).flatMap { pictures.draw(it, parts, split).value }
            for (fanIn in listOf(2, 3, 8)) {
                val (pieces, rounds) = pictures.merged(drawn, parts, fanIn)
                assertEquals(expected, hash(pieces)) { "$split $fanIn" }
                val tasks = mapOf(2 to listOf(8, 8, 4), 3 to listOf(8, 4), 8 to listOf(4))[fanIn]
                assertEquals(tasks, rounds.map { it.tasks })
            }
        }
    }

    /** What is merged where it was drawn is not sent. */
    @Test
    fun onePartSendsNothing() {
        val round = pictures.merged(pictures.draw(0, 1, Split.RANGES).value, 1).second.single()
        assertEquals(0L, round.bytes)
    }

    @Test
    fun everyTriangleIsInOnePart() {
        val sphere = BumpySphere(rings = 20)
        for (split in Split.entries) {
            val indices = (0 until parts).flatMap { sphere.rows(it, parts, split) }.map { it.getLong(0).toInt() }
            assertEquals((0 until sphere.triangles).toList(), indices.sorted())
            val sizes = (0 until parts).map { sphere.rows(it, parts, split).size }
            assertTrue(sizes.max() < 1.2 * sizes.min()) { "$split $sizes" }
        }
    }
}
