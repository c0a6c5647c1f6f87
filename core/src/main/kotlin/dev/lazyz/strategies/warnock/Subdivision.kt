package dev.lazyz.strategies.warnock

import dev.lazyz.Counters
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Region
import dev.lazyz.bytes
import dev.lazyz.endIfInterrupted
import dev.lazyz.raster.AreaBounds
import dev.lazyz.raster.VisibilityOrder
import dev.lazyz.raster.forEachKey

/**
 * Determines what is visible in an area, if necessary by dividing it into two halves.
 *
 * Each area has a list of *candidates*: primitives that may be visible in it, from near to far. Of the primitives that
 * surround the area, the *cover* is the one whose farthest key is the least. The background surrounds everything and is
 * the cover if there is no other. Candidates hidden by the cover are removed, in this area and all its parts. When few
 * fragments are left, the candidates are scan-converted over the cover; otherwise the area is halved.
 */
internal class Subdivision(frame: Frame, bandHeight: Int, private val counters: Counters.Builder) {
    private val test = frame.raster.depthTest
    private val order = VisibilityOrder(test)
    private val bounds = AreaBounds(test, counters)
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private val painting = BandPainting(frame, bandHeight, counters)

    /**
     * Candidates of the areas being divided, by number, and for each the number of samples of its area that it covers.
     */
    private var candidates = IntArray(INITIAL)
    private var samples = IntArray(INITIAL)

    private lateinit var coverages: BandCoverages

    /** The visible key of each sample of the band, in rows from its top. */
    val keys: LongArray get() = painting.keys

    /** Bytes currently held. */
    val bytes: Long get() = painting.bytes + candidates.bytes + samples.bytes

    /** Fills [keys] for [band]. */
    fun decide(band: Region, coverages: BandCoverages) {
        this.coverages = coverages
        painting.begin(band)
        reserve(coverages.count)
        for (number in 0 until coverages.count) {
            candidates[number] = number
            samples[number] = UNKNOWN
        }
        decide(band, 0, coverages.count, WITHOUT_PARENT)
    }

    /** Fills [area], a part of an area of [parentSize] samples whose candidates are at [from] until [until]. */
    private fun decide(area: Region, from: Int, until: Int, parentSize: Int) {
        val size = area.size.toInt()
        reserve(2 * until - from)

        // Classify: drop disjoint candidates, and take as the cover the surrounder whose farthest key is least
        var end = until
        var cover: BandCoverage? = null
        var coverKey = backgroundKey
        for (i in from until until) {
            endIfInterrupted()
            val candidate = coverages[candidates[i]]
            // All candidates after this one are at least as far away: the cover hides them
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

        // Remove candidates hidden by the cover, for this area and its parts
        var kept = until
        var fragments = 0L
        for (i in until until end) {
            val candidate = coverages[candidates[i]]
            if (candidate !== cover && isHidden(candidate, cover, coverKey, area)) continue
            candidates[kept] = candidates[i]
            samples[kept] = samples[i]
            fragments += samples[i]
            kept++
        }

        // Do not divide if few are left: nothing, only the cover, one candidate, or hardly more fragments than samples
        if (fragments <= size + size / SPARE || size <= LEAF) {
            painting.fill(area, cover)
            for (i in until until kept) {
                val candidate = coverages[candidates[i]]
                if (candidate !== cover) painting.draw(area, candidate)
            }
            return
        }

        // Otherwise divide the area into halves
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

    /**
     * Whether [candidate] is hidden by the [cover] (null for the background). [coverKey] bounds the cover's keys from
     * above.
     */
    private fun isHidden(candidate: BandCoverage, cover: BandCoverage?, coverKey: Long, area: Region): Boolean {
        // Bounds decide most pairs, in one direction or the other
        if (candidate.nearestKey > coverKey) return true
        if (candidate.farthestKey < (cover?.nearestKey ?: backgroundKey)) return false

        // Compare planes if both have one; otherwise compare with the cover's farthest key
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
         * An area is divided only if the number of fragments exceeds the number of samples by more than 1/[SPARE]. With
         * 1, a city takes 1.4 times as many depth evaluations. With no allowance at all, it takes no fewer evaluations
         * but more areas.
         */
        const val SPARE = 4

        /**
         * Areas of at most this many samples are not divided. Of 1, 4, 16 and 64, this value takes the fewest depth
         * evaluations in a city.
         */
        const val LEAF = 16
    }
}

/**
 * The visibility keys of a band of rows. They are set in two ways: without comparing ([fill]), and by minimum ([draw]).
 */
internal class BandPainting(frame: Frame, bandHeight: Int, private val counters: Counters.Builder) {
    private val region = frame.region
    private val test = frame.raster.depthTest
    private val backgroundKey = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private var firstRow = 0

    /** The key of each sample, in rows from the top of the band. */
    val keys: LongArray = LongArray(region.width * bandHeight)

    /** Bytes held. */
    val bytes: Long get() = keys.bytes

    /** Moves to [band]. */
    fun begin(band: Region) {
        firstRow = band.rowStart
    }

    private fun at(x: Int, y: Int): Int = (y - firstRow) * region.width + (x - region.columnStart)

    /** Sets all samples of [area] to the [cover], which covers them all, or to the background, without comparing. */
    fun fill(area: Region, cover: BandCoverage?) {
        if (cover == null) {
            for (y in area.rowStart until area.rowEnd) {
                val start = at(area.columnStart, y)
                keys.fill(backgroundKey, start, start + area.width)
            }
            return
        }
        counters.depthEvaluations += area.size
        counters.depthPasses += area.size
        for (y in area.rowStart until area.rowEnd) {
            var at = at(area.columnStart, y)
            cover.primitive.forEachKey(cover.index, test, y, area.columnStart, area.columnEnd) { _, key ->
                keys[at++] = key
            }
        }
    }

    /** Scan-converts the [candidate] in [area]; each sample keeps the lesser key. */
    fun draw(area: Region, candidate: BandCoverage) {
        val box = candidate.boxIn(area)
        for (y in box.rowStart until box.rowEnd) {
            var position = candidate.firstSpan(y, box.columnStart)
            val end = candidate.endOfRow(y)
            while (position < end && candidate.start(position) < box.columnEnd) {
                val from = maxOf(candidate.start(position), box.columnStart)
                drawSpan(candidate, y, from, minOf(candidate.end(position), box.columnEnd))
                position += 2
            }
        }
    }

    private fun drawSpan(candidate: BandCoverage, y: Int, start: Int, end: Int) {
        counters.depthEvaluations += end - start
        var at = at(start, y)
        var passes = 0
        candidate.primitive.forEachKey(candidate.index, test, y, start, end) { _, key ->
            if (key < keys[at]) {
                keys[at] = key
                passes++
            }
            at++
        }
        counters.depthPasses += passes
    }
}
