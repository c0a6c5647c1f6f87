package dev.lazyz.scenes.stl

import dev.lazyz.geometry.Box
import dev.lazyz.scenes.loading.FarOrigin
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.streaming.FacetColors
import dev.lazyz.scenes.streaming.FacetFile
import dev.lazyz.scenes.streaming.FacetSpool
import dev.lazyz.scenes.streaming.FileBytes
import dev.lazyz.scenes.streaming.PartBox
import dev.lazyz.scenes.streaming.StreamedInput
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.surface.StreamedMesh.MeshSource
import java.nio.ByteBuffer
import java.util.stream.IntStream
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Reads stereolithography files of any size part by part. The triangles and their colours are those of [StlParser]
 * without smooth normals; for the limits, each corner is a vertex. A binary file is read where it is, an ASCII file is
 * converted once to a [FacetSpool].
 */
internal object StlStreaming {
    /** Opens [input], whose first bytes [source] has. */
    fun open(source: Source, input: StreamedInput): MeshSource {
        val isBinary = StlBinary.isBinary(source.bytes, input.file.size)
        val mesh = if (isBinary) binary(source, input) else ascii(source, input)
        if (mesh.triangleCount == 0) source.warn("there are no facets, so there is nothing to see")
        return mesh
    }

    private fun ascii(source: Source, input: StreamedInput): FacetFile {
        source.requireNoMark()
        val spool = FarOrigin.reading(
            source.loading,
            read = { origin -> spooled(source, input, origin) },
            bounds = { it.bounds },
        )
        return spool.finish()
    }

    private fun spooled(source: Source, input: StreamedInput, origin: Vector3dc): FacetSpool {
        val spool = input.spool(source, origin)
        input.bytes().use { bytes ->
            val lines = TextLines(ByteWindow(source, bytes))
            StlAscii(source, origin, lines).read {
                CornerSink { x, y, z ->
                    source.loading.streamedVertices(source, 1)
                    spool.add(x, y, z)
                }
            }
        }
        return spool
    }

    private fun binary(source: Source, input: StreamedInput): FacetFile {
        val file = input.file
        val layout = StlBinary.layout(source, file.size, input::bytes)
        val count = layout.count
        if (count > FacetSpool.MOST) source.fail(null, "has $count facets, at most ${FacetSpool.MOST}", "split it")
        if (layout.hasPayload) return withoutPayload(source, input, count)
        source.loading.streamed(source, count)
        source.loading.streamedVertices(source, 3 * count)

        // Look at all facets once: where they are, and whether they have colours
        val words = StlWords()
        val boxes = ArrayList<Box?>()
        val pieces = ((count + PIECE - 1) / PIECE).toInt()
        for (first in 0 until pieces step AT_ONCE) {
            val found = IntStream.range(first, minOf(first + AT_ONCE, pieces)).parallel()
                .mapToObj { number -> FacetScan(file, number * PIECE, minOf(PIECE, count - number * PIECE).toInt()) }
                .toList()
            for (piece in found) {
                boxes += piece.boxes
                words.add(piece.words)
            }
            source.loading.decode(source, 0)
        }
        return FacetFile(
            file, StlBinary.FACETS.toLong(), StlBinary.FACET, StlBinary.NORMAL, count.toInt(), Vector3d(), boxes,
            StlColors.of(source, words)?.let(::FacetWords),
        )
    }

    /** Copies the [count] facets without the bytes that follow each of them. */
    private fun withoutPayload(source: Source, input: StreamedInput, count: Long): FacetFile {
        val spool = input.spool(source, Vector3d())
        StlBinary.eachFacet(source, count, input::bytes) { facet ->
            source.loading.streamedVertices(source, 3)
            StlBinary.addCorners(facet, 0, spool::add)
        }
        return spool.finish()
    }

    /** What is known of [count] facets of a binary file, from number [first] on, after a look at all of them. */
    private class FacetScan(file: FileBytes, first: Long, count: Int) {
        /** The boxes of the parts of [FacetFile]. */
        val boxes = ArrayList<Box?>()
        val words = StlWords()

        init {
            val records = file.read(StlBinary.FACETS + first * StlBinary.FACET, count * StlBinary.FACET)
            for (start in 0 until count step FacetFile.PART) {
                val box = PartBox()
                for (facet in start until minOf(start + FacetFile.PART, count)) {
                    val at = facet * StlBinary.FACET
                    for (i in StlBinary.NORMAL until StlBinary.NORMAL + 36 step 12) {
                        box.add(records.getFloat(at + i), records.getFloat(at + i + 4), records.getFloat(at + i + 8))
                    }
                    words.add(StlBinary.word(records, at))
                }
                boxes += box.toBox()
            }
        }
    }

    /** Facets that a thread looks at, a multiple of [FacetFile.PART]. */
    private const val PIECE = 16L * FacetFile.PART

    /** Pieces that are looked at before the limits are checked. */
    private const val AT_ONCE = 64

    /** The colours in the 16-bit words of facets. */
    private class FacetWords(private val colors: StlColors) : FacetColors {
        @Synchronized
        override fun of(records: ByteBuffer, stride: Int, count: Int): FloatArray {
            val all = FloatArray(12 * count) { 1f }
            for (facet in 0 until count) {
                val number = colors.of(StlBinary.word(records, stride * facet))
                if (number < 0) continue
                for (corner in 0 until 3) colors.palette.copy(number, all, 12 * facet + 4 * corner)
            }
            return all
        }
    }
}
