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
import dev.lazyz.scenes.text.TextEncoding
import dev.lazyz.scenes.text.TextLines
import dev.lazyz.world.surface.MeshSource
import java.nio.ByteBuffer
import java.util.stream.IntStream
import org.joml.Vector3d
import org.joml.Vector3dc

/**
 * Reads stereolithography files of any size part by part. The triangles and their colours are those of [StlParser]
 * without smooth normals. A binary file is read where it is, an ASCII file is converted once to a [FacetSpool].
 */
internal object StlStreaming {
    /** Opens [input], whose first bytes [source] has. */
    fun open(source: Source, input: StreamedInput): MeshSource {
        val mesh = if (StlBinary.isBinary(source.bytes)) binary(source, input.file) else ascii(source, input)
        if (mesh.triangleCount == 0) source.warn("there are no facets, so there is nothing to see")
        return mesh
    }

    private fun ascii(source: Source, input: StreamedInput): FacetFile {
        if (TextEncoding.hasMark(source.bytes)) {
            source.fail(null, "begins with a byte order mark", "save it as plain ASCII to stream it")
        }
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
            val lines = TextLines(ByteArray(0), rest = bytes)
            StlAscii(source, origin, lines).read { CornerSink(spool::add) }
        }
        return spool
    }

    private fun binary(source: Source, file: FileBytes): FacetFile {
        val count = StlBinary.countOf(source, file.size)
        if (count > FacetSpool.MOST) source.fail(null, "has $count facets, at most ${FacetSpool.MOST}", "split it")
        source.loading.streamed(source, count)

        // Look at all facets once: where they are, and whether they have colours
        val words = StlWords()
        val boxes = ArrayList<Box?>()
        val parts = FacetFile.parts(count.toInt())
        for (first in 0 until parts step AT_ONCE) {
            val found = IntStream.range(first, minOf(first + AT_ONCE, parts)).parallel()
                .mapToObj { number -> FacetScan.of(file, number, count) }.toList()
            for (part in found) {
                boxes += part.box
                words.add(part.words)
            }
            source.loading.decode(source, 0)
        }
        return FacetFile(
            file, StlBinary.FACETS.toLong(), StlBinary.FACET, StlBinary.NORMAL, count.toInt(), Vector3d(), boxes,
            StlColors.of(source, words)?.let(::FacetWords),
        )
    }

    /** What is known of one part of a binary file after a look at all its facets. */
    private class FacetScan(val box: Box?, val words: StlWords) {
        companion object {
            /** Looks at part [number] of a file with [count] facets. */
            fun of(file: FileBytes, number: Int, count: Long): FacetScan {
                val first = number.toLong() * FacetFile.PART
                val facets = minOf(FacetFile.PART.toLong(), count - first).toInt()
                val records = file.read(StlBinary.FACETS + first * StlBinary.FACET, facets * StlBinary.FACET)
                val box = PartBox()
                val words = StlWords()
                for (facet in 0 until facets * StlBinary.FACET step StlBinary.FACET) {
                    for (corner in 0 until 3) {
                        val at = facet + StlBinary.NORMAL + 12 * corner
                        box.add(records.getFloat(at), records.getFloat(at + 4), records.getFloat(at + 8))
                    }
                    words.add(StlBinary.word(records, facet))
                }
                return FacetScan(box.toBox(), words)
            }
        }
    }

    /** Parts that are looked at before the limits are checked. */
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
