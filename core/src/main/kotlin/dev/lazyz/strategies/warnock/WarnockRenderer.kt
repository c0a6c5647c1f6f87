package dev.lazyz.strategies.warnock

import dev.lazyz.Capability
import dev.lazyz.Checkpoint
import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.pipeline.KeyedRows
import dev.lazyz.requireInMemory
import dev.lazyz.requireOpaque
import dev.lazyz.shading.LateShading
import java.io.IOException

/**
 * Divides the picture into areas until each area is simple.
 *
 * A primitive is disjoint from an area, surrounds it, is contained in it or intersects it. A primitive that surrounds
 * an area and is before others hides them in the whole area and all its parts, and one comparison proves it. An area is
 * simple if it has hardly more fragments left than samples: only the background, one surrounding primitive, or one
 * other primitive. Other areas are halved. Samples are shaded after the visible primitives are known.
 *
 * Use it where large surfaces hide much: the number of depth evaluations grows with what is visible, not with the
 * number of layers. Do not use it for meshes of very small triangles: areas have to become as small as the triangles,
 * and a depth buffer does less work.
 *
 * Memory: a band of at most 64 rows, 8 bytes a sample, and the spans of the primitives in it; 8 bytes for each
 * primitive that is not yet in a band. Time: each row of a primitive once; for an area, its candidates times its rows.
 * Thread safe; no state between calls.
 *
 * Source: John Warnock, "A Hidden Surface Algorithm for Computer Generated Half-tone Pictures", University of Utah, TR
 * 4-15 (1969); Ivan Sutherland, Robert Sproull, Robert Schumacker, "A Characterization of Ten Hidden-Surface
 * Algorithms", ACM Computing Surveys 6(1) (1974), the section on Warnock's. In these, an area is divided into quarters
 * and coverage is determined from a polygon's edges; here an area is halved along its longer side, and coverage is
 * determined from spans, which every primitive has.
 *
 * @param options only [RenderOptions.coherence] is used
 */
public class WarnockRenderer @JvmOverloads constructor(private val options: RenderOptions = RenderOptions()) :
    Renderer {
    init {
        options.requireSupportedBy(this)
    }

    override val id: String get() = "warnock"

    override val summary: String get() = "divides areas until one surface hides all others or little is left"

    override val capabilities: Set<Capability>
        get() = setOf(Capability.SHADES_ONLY_VISIBLE, Capability.CONSTANT_MEMORY, Capability.COHERENCE)

    override fun configured(options: RenderOptions): Renderer = WarnockRenderer(options)

    @Throws(InterruptedException::class, IOException::class)
    override fun render(frame: Frame, sink: RowSink): Counters {
        requireOpaque(frame, this)
        requireInMemory(frame, this)
        val counters = Counters.Builder()
        counters.primitives = frame.primitives.size.toLong()
        val region = frame.region
        val coverages = BandCoverages(frame, counters)
        val bandHeight = minOf(BAND, maxOf(BAND_SAMPLES / region.width, 1), region.height)
        val subdivision = Subdivision(frame, bandHeight, counters)
        val rows = KeyedRows(frame, LateShading(frame, options.coherence, counters, Checkpoint.CALLER), counters)
        for (top in region.rowStart until region.rowEnd step bandHeight) {
            val band = region.rows(top, top + bandHeight)

            // Record what is covered, and determine what is visible
            coverages.moveTo(band)
            subdivision.decide(band, coverages)
            counters.peakBytes = maxOf(counters.peakBytes, coverages.bytes + subdivision.bytes)

            // Shade after the visible primitives are known
            rows.handOut(band, subdivision.keys, sink)
        }
        counters.peakBytes += rows.bytes
        return counters.build()
    }

    override fun toString(): String = "WarnockRenderer($options)"

    private companion object {
        /** Rows of a band: enough rows for areas to be large, few enough to hold all their spans. */
        const val BAND = 64

        /** Most samples of a band: wider pictures have lower bands, so that their keys take at most 8 MB. */
        const val BAND_SAMPLES = 1 shl 20
    }
}
