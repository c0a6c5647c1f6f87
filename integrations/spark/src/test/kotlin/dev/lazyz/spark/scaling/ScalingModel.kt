package dev.lazyz.spark.scaling

import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.ln
import kotlin.math.pow

/**
 * The picture that a model is about.
 *
 * @property samples all samples
 * @property visible samples that show triangles
 * @property bandEnds for each band the share of the visible samples that are in it or above it
 * @property overdraw fragments of all triangles for each visible sample
 */
internal class PictureFacts(val samples: Long, val visible: Long, val bandEnds: List<Double>, val overdraw: Double) {
    val bands: Int get() = bandEnds.size

    /** The share of the visible samples above a band. */
    fun bandStart(band: Int): Double = if (band == 0) 0.0 else bandEnds[band - 1]
}

/**
 * A share of the triangles, from [from] to [to] in 0..1, in a part of the picture.
 *
 * @property samples of this part of the picture
 * @property top the share of the visible samples above the part
 * @property bottom the share above its end
 * @property strips the share of its strips that are left after splits
 */
internal class ExpectedPiece(
    val from: Double,
    val to: Double,
    val samples: Double,
    val top: Double,
    val bottom: Double,
    val strips: Double,
) {
    /** The share of the triangles. */
    val share: Double get() = minOf(1.0, to - from)
}

/**
 * Bytes and fragments of parts, by the share of the triangles that they have.
 *
 * @property exponent of the formula in [covered]
 * @property bytes of a fragment, and how many more if no neighbour is in the part
 */
internal class PartSizes(
    private val facts: PictureFacts,
    val split: Split,
    val exponent: Double,
    val bytes: DoubleArray,
) {
    /**
     * The share of the visible samples that a part with a [share] of the triangles covers. At random, it misses a
     * sample if it has none of the layers of triangles there; their number is the exponent. A small range hides nothing
     * of itself, so it covers as much as its triangles do, and a larger one less.
     */
    fun covered(share: Double): Double = when (split) {
        Split.SCATTERED -> 1 - (1 - share).pow(exponent)
        Split.RANGES -> facts.overdraw * share / (1 + (facts.overdraw - 1) * share.pow(exponent))
    }

    /** Expected fragments of [piece]. */
    fun fragments(piece: ExpectedPiece): Double = facts.visible * piece.strips * when (split) {
        Split.SCATTERED -> (piece.bottom - piece.top) * covered(piece.share)
        Split.RANGES -> rows(piece)
    }

    /** The share of the visible samples that is in the rows of [piece], if the range is rows, too. */
    private fun rows(piece: ExpectedPiece): Double {
        val width = covered(piece.share)
        val start = ((piece.from + piece.to - width) / 2).coerceIn(0.0, 1 - width)
        return (minOf(start + width, piece.bottom) - maxOf(start, piece.top)).coerceAtLeast(0.0)
    }

    /** Expected bytes of [piece]. */
    fun bytes(piece: ExpectedPiece): Long {
        val fragments = fragments(piece)
        val density = fragments / (facts.visible * piece.strips * (piece.bottom - piece.top))
        return Fit.sum(bytes, sizeFeatures(fragments, density)).toLong()
    }

    companion object {
        /** What bytes of runs depend on. At random, a fragment begins a run with the probability of 1 - [density]. */
        fun sizeFeatures(fragments: Double, density: Double): DoubleArray =
            doubleArrayOf(fragments, fragments * (1 - density))

        /** Returns the exponent for parts with a [share] of the triangles that cover some of the visible samples. */
        fun exponent(facts: PictureFacts, split: Split, share: List<Double>, covered: List<Double>): Double {
            val (given, found) = when (split) {
                Split.SCATTERED -> share.map { -ln(1 - it) } to covered.map { -ln(1 - it) }
                Split.RANGES -> share.map { -ln(it) } to share.zip(covered) { part, seen ->
                    -ln((facts.overdraw * part / seen - 1) / (facts.overdraw - 1))
                }
            }
            return Fit.factors(given.map { doubleArrayOf(it) }, found)[0]
        }
    }
}

/**
 * Predicts times, by expected sizes in the algorithms that [MergeSimulation] has.
 *
 * @property drawing seconds for each of [drawFeatures]
 * @property merging seconds for each of [mergeFeatures]
 */
internal class ScalingModel(
    private val facts: PictureFacts,
    private val sizes: PartSizes,
    val drawing: DoubleArray,
    val merging: DoubleArray,
    private val network: Network,
) : Compositing<ExpectedPiece> {
    override fun bytes(piece: ExpectedPiece): Long = sizes.bytes(piece)

    override fun split(piece: ExpectedPiece, ways: Int): List<ExpectedPiece> = with(piece) {
        List(ways) { ExpectedPiece(from, to, samples / ways, top, bottom, strips / ways) }
    }

    override fun merge(pieces: List<ExpectedPiece>): Timed<ExpectedPiece> {
        val features = mergeFeatures(pieces[0].samples, pieces.map { sizes.fragments(it) })
        val merged = with(pieces[0]) {
            ExpectedPiece(pieces.minOf { it.from }, pieces.maxOf { it.to }, samples, top, bottom, strips)
        }
        return Timed(merged, Fit.sum(merging, features))
    }

    /** Seconds of an executor that draws a part of [parts], if all have [triangles]. */
    fun drawSeconds(triangles: Double, parts: Int): Double =
        Fit.sum(drawing, drawFeatures(facts, sizes, triangles, triangles / parts))

    /** Bytes of a part of [parts], all bands. */
    fun partBytes(parts: Int): Long = sizes.bytes(whole(0, parts))

    /** Predicts the job's merging of [nodes] parts. */
    fun tree(nodes: Int): Simulated<ExpectedPiece> = MergeSimulation(this, network).tree(
        List(nodes) { node ->
            (0 until facts.bands).associateWith { band(node, nodes, it) }.filter { sizes.fragments(it.value) > 0 }
        },
        facts.bands,
    )

    /** Predicts radix-k. */
    fun swap(nodes: Int, factors: List<Int>): Simulated<ExpectedPiece> =
        MergeSimulation(this, network).swap(List(nodes) { whole(it, nodes) }, factors)

    private fun whole(node: Int, nodes: Int): ExpectedPiece {
        val from = node.toDouble() / nodes
        return ExpectedPiece(from, from + 1.0 / nodes, facts.samples.toDouble(), top = 0.0, bottom = 1.0, strips = 1.0)
    }

    private fun band(node: Int, nodes: Int, band: Int): ExpectedPiece {
        val from = node.toDouble() / nodes
        val samples = facts.samples.toDouble() / facts.bands
        return ExpectedPiece(
            from, from + 1.0 / nodes, samples, facts.bandStart(band), facts.bandEnds[band], strips = 1.0,
        )
    }

    companion object {
        /** Triangles that a task draws at a time. */
        private const val CHUNK = 1 shl 17

        /** What merging depends on: samples of the region, the [fragments] of each part, and how sparse they are. */
        fun mergeFeatures(samples: Double, fragments: List<Double>): DoubleArray =
            doubleArrayOf(samples, fragments.sum(), fragments.sumOf { it * (1 - it / samples) })

        /**
         * What drawing [own] of [all] triangles depends on: their number, the fragments that they cover, the
         * samples that each chunk of them reaches, and the samples of all bands that they reach.
         */
        fun drawFeatures(facts: PictureFacts, sizes: PartSizes, all: Double, own: Double): DoubleArray {
            val chunks = ceil(own / CHUNK)
            val isNear = sizes.split == Split.RANGES
            val ofChunk = if (isNear) sizes.covered(own / chunks / all) else 1.0
            val ofPart = if (isNear) minOf(1.0, sizes.covered(own / all) + 1.0 / facts.bands) else 1.0
            val fragments = facts.visible * facts.overdraw * own / all
            return doubleArrayOf(own, fragments, facts.samples * chunks * ofChunk, facts.samples * ofPart)
        }
    }
}

/** Least squares. */
internal object Fit {
    /** Returns the prediction for [features]. */
    fun sum(factors: DoubleArray, features: DoubleArray): Double = features.indices.sumOf { factors[it] * features[it] }

    /**
     * Returns the factors, none of them negative, that make the sum of the squares of errors least, each divided by the
     * measured value. A factor that would be negative is 0, and the others are computed without it.
     */
    fun factors(features: List<DoubleArray>, measured: List<Double>): DoubleArray {
        require(measured.all { it > 0 && it.isFinite() }) { "all must be positive: $measured" }
        val used = features[0].indices.toMutableList()
        while (true) {
            val found = solve(features, measured, used)
            val least = found.indices.minBy { found[it] }
            if (found[least] >= 0) {
                return DoubleArray(features[0].size).also { all -> used.forEachIndexed { i, to -> all[to] = found[i] } }
            }
            used.removeAt(least)
        }
    }

    /** Solves the normal equations by elimination. */
    private fun solve(features: List<DoubleArray>, measured: List<Double>, used: List<Int>): DoubleArray {
        val n = used.size
        val rows = Array(n) { DoubleArray(n + 1) }
        for ((all, value) in features.zip(measured)) {
            for (i in 0 until n) {
                for (j in 0 until n) rows[i][j] += all[used[i]] * all[used[j]] / value
                rows[i][n] += all[used[i]]
            }
        }
        for (column in 0 until n) {
            val pivot = (column until n).maxBy { abs(rows[it][column]) }
            rows[column] = rows[pivot].also { rows[pivot] = rows[column] }
            for (row in 0 until n) {
                if (row == column) continue
                val factor = rows[row][column] / rows[column][column]
                for (k in column..n) rows[row][k] -= factor * rows[column][k]
            }
        }
        return DoubleArray(n) { rows[it][n] / rows[it][it] }
    }
}
