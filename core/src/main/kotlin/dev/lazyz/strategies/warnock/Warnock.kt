package dev.lazyz.strategies.warnock

import dev.lazyz.Capability
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.KeyedRows
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading

/**
 * Divides the picture into areas until each is easy.
 *
 * A primitive is disjoint from an area, surrounds it, is contained in it or intersects it. One that surrounds an area
 * and is before others hides them, in the whole area and all its parts, by one comparison. An area is easy if hardly
 * more fragments are left than samples: nothing but the background, one surrounding primitive, one other. What is not
 * easy is halved. What is visible is shaded once it is known.
 *
 * Use it where large surfaces hide much: its depth evaluations grow with what is visible, not with the number of
 * layers. Do not use it for meshes of very small triangles: areas have to become as small as they are, and a depth
 * buffer does the same for less.
 *
 * Memory: a band of at most 64 rows, 8 bytes a sample, and the spans of the primitives in it; 8 bytes for each
 * primitive that waits. Time: each primitive's rows once; for an area its candidates times its rows. Thread safe; no
 * state between calls.
 *
 * Source: John Warnock, "A Hidden Surface Algorithm for Computer Generated Half-tone Pictures", University of Utah,
 * TR 4-15 (1969); Ivan Sutherland, Robert Sproull, Robert Schumacker, "A Characterization of Ten Hidden-Surface
 * Algorithms", ACM Computing Surveys 6(1) (1974), the section on Warnock's. There an area is quartered and what a
 * polygon covers is asked of its edges; here it is halved along its longer side, and asked of spans, which any
 * primitive has.
 *
 * @param options [RenderOptions.coherence] is heeded
 */
public class Warnock @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) : Renderer {
    override val id: String get() = "warnock"

    override val summary: String get() = "divides areas until one surface hides all others or little is left"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.COHERENCE)

    override fun configured(options: RenderOptions): Renderer = Warnock(options)

    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        val counters = Counters()
        counters.primitives = frame.primitives.size.toLong()
        val region = frame.region
        val footprints = Footprints(frame, counters)
        val bandHeight = minOf(BAND, maxOf(BAND_SAMPLES / region.width, 1), region.height)
        val subdivision = Subdivision(frame, bandHeight, counters)
        val rows = KeyedRows(frame, LateShading(frame, options.coherence, counters), counters)
        for (top in region.rowStart until region.rowEnd step bandHeight) {
            val band = Region(region.columnStart, top, region.columnEnd, minOf(top + bandHeight, region.rowEnd))

            // Write down what is covered, and decide what is visible
            footprints.moveTo(band)
            subdivision.decide(band, footprints)
            counters.peakBytes = maxOf(counters.peakBytes, footprints.bytes + subdivision.bytes)

            // Only now make the colours
            rows.handOut(band, subdivision.keys, sink)
        }
        counters.peakBytes += rows.bytes
        return counters
    }

    override fun toString(): String = "Warnock($options)"

    private companion object {
        /** Rows that are decided together: enough for an area to be large, few enough to hold all their spans. */
        const val BAND = 64

        /** Samples of a band at most: wider pictures have lower bands, so that their keys take no more than 8 MB. */
        const val BAND_SAMPLES = 1 shl 20
    }
}
