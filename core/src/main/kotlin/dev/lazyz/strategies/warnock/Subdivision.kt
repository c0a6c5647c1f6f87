package dev.lazyz.strategies.warnock

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.raster.AreaBounds
import dev.lazyz.raster.VisibilityOrder

/**
 * Decides what is visible in an area, or else in its two halves.
 *
 * An area knows its *candidates*: primitives that may be visible in it, nearest first. One that surrounds the area is
 * its *cover* if it reaches least far; the background, which surrounds everything, is the first cover of all. What
 * the cover hides is no candidate any more, here and in all areas below. When little is left the candidates are
 * scan-converted over the cover; otherwise the area is halved.
 */
internal class Subdivision(frame: Frame, bandHeight: Int, private val counters: Counters) {
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val bounds = AreaBounds(test, counters)
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val painting = BandPainting(frame, bandHeight, counters)

    /** Candidates of the areas on the way down, by number, and how many samples of its area each covers. */
    private var candidates = IntArray(INITIAL)
    private var samples = IntArray(INITIAL)

    private lateinit var footprints: Footprints

    /** The visible key of each sample of the band, in rows from its top. */
    val keys: LongArray get() = painting.keys

    /** Bytes held at present. */
    val bytes: Long get() = painting.bytes + Int.SIZE_BYTES * (candidates.size + samples.size)

    /** Fills [keys] for [band]. */
    fun decide(band: Region, footprints: Footprints) {
        this.footprints = footprints
        painting.begin(band)
        reserve(footprints.count)
        for (number in 0 until footprints.count) {
            candidates[number] = number
            samples[number] = UNKNOWN
        }
        decide(band, 0, footprints.count, WITHOUT_PARENT)
    }

    /** Decides [area], a part of one of [parentSize] samples whose candidates are at [from] until [until]. */
    private fun decide(area: Region, from: Int, until: Int, parentSize: Int) {
        val size = area.size.toInt()
        reserve(2 * until - from)

        // Classify: leave out what is disjoint, and let the surrounder that reaches least far be the cover
        var end = until
        var cover: Footprint? = null
        var coverKey = backgroundKey
        for (i in from until until) {
            val candidate = footprints[candidates[i]]
            // All that follow are no nearer: the cover hides them
            if (candidate.nearestKey > coverKey) break
            val covered = if (samples[i] == parentSize) size else candidate.samplesIn(area)
            if (covered == 0) continue
            if (covered == size) {
                val key = bounds.farthestKey(candidate.primitive, candidate.index, area)
                if (key < coverKey) {
                    coverKey = key
                    cover = candidate
                }
            }
            candidates[end] = candidates[i]
            samples[end] = covered
            end++
        }

        // Reject what the cover hides, here and below
        var kept = until
        var fragments = 0L
        for (i in until until end) {
            val candidate = footprints[candidates[i]]
            if (candidate !== cover && isHidden(candidate, cover, coverKey, area)) continue
            candidates[kept] = candidates[i]
            samples[kept] = samples[i]
            fragments += samples[i]
            kept++
        }

        // Nothing, the cover alone, one candidate alone, or hardly more fragments than samples: no need to look closer
        if (fragments <= size + size / SPARE || size <= LEAF) {
            painting.fill(area, cover)
            for (i in until until kept) {
                val candidate = footprints[candidates[i]]
                if (candidate !== cover) painting.draw(area, candidate)
            }
            return
        }

        // Otherwise look at its halves
        if (area.width >= area.height) {
            val middle = area.columnStart + area.width / 2
            decide(Region(area.columnStart, area.rowStart, middle, area.rowEnd), until, kept, size)
            decide(Region(middle, area.rowStart, area.columnEnd, area.rowEnd), until, kept, size)
        } else {
            val middle = area.rowStart + area.height / 2
            decide(Region(area.columnStart, area.rowStart, area.columnEnd, middle), until, kept, size)
            decide(Region(area.columnStart, middle, area.columnEnd, area.rowEnd), until, kept, size)
        }
    }

    /** Whether [candidate] is behind the [cover] (null for the background), which is nowhere behind [coverKey]. */
    private fun isHidden(candidate: Footprint, cover: Footprint?, coverKey: Long, area: Region): Boolean {
        // Bounds decide most pairs, one way or the other
        if (candidate.nearestKey > coverKey) return true
        if (candidate.farthestKey < (cover?.nearestKey ?: backgroundKey)) return false

        // Planes are compared where both are; other primitives by how far the cover reaches
        val shared = candidate.boxIn(area)
        val front = cover?.primitive?.depthForm
        val behind = candidate.primitive.depthForm
        if (front == null || behind == null) {
            return bounds.nearestKey(candidate.primitive, candidate.index, shared) > coverKey
        }
        return bounds.leads(front, behind, shared, order.leastLead(cover.index, candidate.index))
    }

    /** Makes room for [count] candidates. */
    private fun reserve(count: Int) {
        if (count <= candidates.size) return
        candidates = candidates.copyOf(maxOf(count, 2 * candidates.size))
        samples = samples.copyOf(candidates.size)
    }

    private companion object {
        const val INITIAL = 64
        const val UNKNOWN = -1
        const val WITHOUT_PARENT = -2

        /**
         * Fragments may be more than samples by one in so many before an area is divided. With 1 a city takes 1.4 times
         * as many depths; with none to spare it takes no fewer, in more areas.
         */
        const val SPARE = 4

        /** Areas of so many samples are not divided: of 1, 4, 16 and 64 what takes fewest depths in a city. */
        const val LEAF = 16
    }
}
