package dev.lazyz.spark.scaling

import dev.lazyz.spark.scaling.PartPictures.RunCompositing
import dev.lazyz.spark.triangles.BandSamples
import dev.lazyz.spark.triangles.PictureSetUp
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class PartPicturesTest {
    private val pictures = PartPictures(BumpySphere(rings = 20), 256, 128, strips = 16, bandRows = 32)
    private val network = Network(1e9, 1e-3)
    private val parts = 8

    /** The keys and colours of all samples, in a hash. */
    private fun hash(setUp: PictureSetUp, pieces: List<RunPiece>): Int {
        val all = pieces.flatMap { it.cells }.sortedBy { it.number }
        assertEquals(all.map { it.number }.distinct().size, all.size)
        val seen = ArrayList<Any>()
        for (cell in all) {
            val samples = BandSamples(setUp.drawing().raster, setUp.region(cell.number))
            samples.add(cell.part.runs)
            samples.forEachRow { y, argb, depth, primitive ->
                seen.add(listOf(y, argb.contentHashCode(), depth.contentHashCode(), primitive.contentHashCode()))
            }
        }
        assertEquals(128, seen.size)
        return seen.hashCode()
    }

    @Test
    fun mergingInAnyOrderGivesThePictureOfOneRendering() {
        val expected = hash(pictures.bandSetUp, listOf(pictures.draw(0, 1, Split.RANGES).bands))
        for (split in Split.entries) {
            val drawn = List(parts) { pictures.draw(it, parts, split).bands }
            val bands = drawn.map { one -> one.cells.associate { it.number to RunPiece(listOf(it)) } }
            for (fanIn in listOf(2, 3, 8)) {
                val tree = MergeSimulation(RunCompositing(pictures.bandSetUp, ArrayList()), network)
                    .tree(bands, pictures.bandSetUp.bands, fanIn)
                assertEquals(expected, hash(pictures.bandSetUp, tree.pieces)) { "$split $fanIn" }
            }
            val strips = drawn.map(pictures::strips)
            for (factors in listOf(listOf(2, 2, 2), listOf(8), listOf(4, 2), listOf(2, 4))) {
                val swap =
                    MergeSimulation(RunCompositing(pictures.stripSetUp, ArrayList()), network).swap(strips, factors)
                assertEquals(expected, hash(pictures.stripSetUp, swap.pieces)) { "$split $factors" }
            }
        }
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
