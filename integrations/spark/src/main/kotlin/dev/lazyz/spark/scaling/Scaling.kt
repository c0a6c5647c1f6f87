package dev.lazyz.spark.scaling

import dev.lazyz.spark.triangles.jobs.SortLast
import kotlin.math.pow
import kotlin.math.roundToInt
import kotlin.math.sqrt
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SparkSession

/**
 * Prints the tables of `docs/spark-scaling.md`: measures parts of a picture, fits a model to parts of few executors,
 * compares it with the others, and predicts more executors and triangles.
 */
internal fun main(args: Array<String>) {
    require(args.isEmpty()) { "no arguments are known: ${args.joinToString(" ")}" }
    val study = ScalingStudy(PartPictures(BumpySphere(RINGS), SIDE, SIDE, STRIPS), taskSeconds())
    val small = PartPictures(BumpySphere(RINGS / 3), SIDE, SIDE, STRIPS)

    // Let the JVM compile what is measured
    repeat(2) { for (split in Split.entries) study.measure(small, split, 4, keep = false) }
    for (split in Split.entries) {
        for (parts in listOf(4, 16)) study.measureDrawing(small, split, parts)
        for (parts in PARTS) study.measure(study.pictures, split, parts, keep = true)
    }
    println(study.report())
}

private const val SIDE = 2048
private const val STRIPS = 64
private const val RINGS = 1000
private val PARTS = listOf(2, 4, 8, 16, 32, 64)

/** Seconds of Spark for a task that does nothing, on one thread; network and other machines not included. */
private fun taskSeconds(): Double {
    val tasks = 2000
    val session = SparkSession.builder().master("local[1]").config("spark.ui.enabled", false)
        .config("spark.driver.host", "127.0.0.1").config("spark.driver.bindAddress", "127.0.0.1").getOrCreate()
    try {
        val context = JavaSparkContext.fromSparkContext(session.sparkContext())
        return List(3) {
            val start = System.nanoTime()
            context.parallelize(List(tasks) { 0 }, tasks).count()
            (System.nanoTime() - start) / 1e9 / tasks
        }.min()
    } finally {
        session.stop()
    }
}

/**
 * What was measured, and the tables made of it.
 *
 * @param taskSeconds what Spark's driver needs for a task
 */
internal class ScalingStudy(val pictures: PartPictures, private val taskSeconds: Double) {
    private class Drawing(val pictures: PartPictures, val split: Split, val parts: Int, val drawn: Drawn) {
        val fragments: Long = drawn.bands.fragments
        val bytes: Long = drawn.bands.cells.sumOf { it.part.runs.size.toLong() }
    }

    private class Merging(
        val split: Split,
        val parts: Int,
        val costs: List<MergeCost>,
        val simulated: Map<String, Simulated<RunPiece>>,
    )

    private val network = Network(BYTES_PER_SECOND, LATENCY)
    private val drawings = ArrayList<Drawing>()
    private val mergings = ArrayList<Merging>()
    private val raw = RawCompositing.measured()

    /** Draws all parts, and keeps what each took. */
    fun measureDrawing(from: PartPictures, split: Split, parts: Int): List<Drawn> =
        List(parts) { from.draw(it, parts, split) }.onEach { drawings += Drawing(from, split, parts, it) }

    /** Draws and merges all parts; for [keep] their cost is part of the report. */
    fun measure(from: PartPictures, split: Split, parts: Int, keep: Boolean) {
        System.err.println("$split in $parts parts")
        val drawn = measureDrawing(from, split, parts)
        val costs = ArrayList<MergeCost>()
        val simulated = LinkedHashMap<String, Simulated<RunPiece>>()
        val inBands = drawn.map { one -> one.bands.cells.associate { it.number to RunPiece(listOf(it)) } }
        simulated[TREE] = MergeSimulation(PartPictures.RunCompositing(from.bandSetUp, costs), network)
            .tree(inBands, SortLast.FAN_IN)
        val inStrips = drawn.map { from.strips(it.bands) }
        for ((name, k) in SWAPS) {
            simulated[name] = MergeSimulation(PartPictures.RunCompositing(from.stripSetUp, costs), network)
                .swap(inStrips, factors(parts, k))
        }
        if (keep) mergings += Merging(split, parts, costs, simulated) else drawings.clear()
    }

    /** The picture, as its parts have shown. */
    private val facts: PictureFacts by lazy {
        val bands = mergings[0].simulated.getValue(TREE).pieces.flatMap { it.cells }
        val counts = List(pictures.bandSetUp.bands) { n -> bands.filter { it.number == n }.sumOf { it.fragments } }
        val ends = counts.runningReduce(Long::plus).map { it.toDouble() / counts.sum() }
        val covered = drawings(Split.SCATTERED) { it == PARTS[0] }.sumOf { it.drawn.covered }
        PictureFacts(pictures.width.toLong() * pictures.height, counts.sum(), ends, covered.toDouble() / counts.sum())
    }

    private fun drawings(split: Split, parts: (Int) -> Boolean) =
        drawings.filter { it.pictures == pictures && it.split == split && parts(it.parts) }

    private val sizes: Map<Split, PartSizes> by lazy {
        Split.entries.associateWith { split ->
            // Parts differ: some are hidden, so the mean of the parts counts
            val means = PARTS.filter { it in 4..FITTED }.map { parts -> parts to drawings(split) { it == parts } }
            val covered = means.map { (_, all) -> all.map { it.fragments }.average() / facts.visible }
            val seen = means.flatMap { it.second }.filter { it.fragments > LEAST }
            val bytes = Fit.factors(
                seen.map {
                    PartSizes.sizeFeatures(it.fragments.toDouble(), it.fragments.toDouble() / facts.visible)
                },
                seen.map { it.bytes.toDouble() },
            )
            PartSizes(facts, split, PartSizes.exponent(facts, split, means.map { 1.0 / it.first }, covered), bytes)
        }
    }

    private val drawing by lazy {
        val fitted = drawings.filter { it.parts <= FITTED }
        Fit.factors(
            fitted.map {
                val own = it.drawn.triangles.toDouble()
                ScalingModel.drawFeatures(facts, sizes.getValue(it.split), own * it.parts, own)
            },
            fitted.map { it.drawn.seconds },
        )
    }

    private val merging by lazy {
        val fitted = mergings.filter { it.parts <= FITTED }.flatMap { it.costs }.filter { it.fragments.sum() > LEAST }
        Fit.factors(
            fitted.map {
                ScalingModel.mergeFeatures(it.samples.toDouble(), it.fragments.map(Long::toDouble))
            },
            fitted.map { it.seconds },
        )
    }

    private fun model(split: Split) = ScalingModel(facts, sizes.getValue(split), drawing, merging, network)

    /** Returns all tables, as Markdown. */
    fun report(): String = buildString {
        for (table in listOf(predictions(), limits(), comparison(), fitted(), checks(), algorithms())) appendLine(table)
    }

    /** Seconds by what they are for. */
    private inner class Times(split: Split, triangles: Double, executors: Int) {
        private val model = model(split)
        private val merge = model.tree(executors, SortLast.FAN_IN)
        val read = triangles / executors * FILE_BYTES / READ_BYTES_PER_SECOND
        val draw = model.drawSeconds(triangles, executors)
        val merging = merge.mergeSeconds
        val network = merge.networkSeconds
        val tasks = (merge.roundBytes.size + 1) * executors
        val empty = tasks - executors - merge.merges
        val tasksSeconds = tasks * taskSeconds
        val emptySeconds = empty * taskSeconds
        val total = read + draw + merging + network + tasksSeconds
    }

    private fun predictions() = table(
        "triangles", "executors", "parts", "read, s", "draw, s", "merge, s", "network, s", "Spark's tasks, s",
        "of them empty", "total, s", "of ideal", "without empty tasks, s",
    ) {
        for (triangles in TRIANGLES) {
            for (executors in listOf(10, 100, 1000)) {
                for (split in Split.entries) {
                    val ideal = Times(split, triangles, 1).let { it.read + it.draw } / executors
                    with(Times(split, triangles, executors)) {
                        row(
                            power(triangles), "%,d".form(executors), split.label(), read.form(), draw.form(),
                            merging.form(), network.form(), tasksSeconds.form(), percent(empty.toDouble() / tasks),
                            total.form(), percent(ideal / total), (total - emptySeconds).form(),
                        )
                    }
                }
            }
        }
    }

    private fun limits() = table("triangles", "parts", "half of ideal at", "fastest at", "total there, s") {
        for (triangles in TRIANGLES) {
            for (split in Split.entries) {
                val all = (0..2 * MOST_DOUBLINGS).map { sqrt(2.0).pow(it).roundToInt() }
                    .associateWith { Times(split, triangles, it) }
                val one = all.getValue(1).let { it.read + it.draw }
                val half = all.entries.lastOrNull { one / it.key / it.value.total >= 0.5 }?.key ?: 1
                val best = all.minBy { it.value.total }
                row(power(triangles), split.label(), "%,d".form(half), "%,d".form(best.key), best.value.total.form())
            }
        }
    }

    private fun comparison() = table(
        "executors", "parts", "Spark's tree, s", "factors", "radix-k, s", "raw radix-k, s",
    ) {
        for (executors in listOf(10, 100, 1000)) {
            val factors = factors(executors, GREATEST)
            val plain = MergeSimulation(raw, network).swap(List(executors) { facts.samples }, factors)
            for (split in Split.entries) {
                val model = model(split)
                row(
                    "%,d".form(executors), split.label(), model.tree(executors, SortLast.FAN_IN).seconds.form(),
                    factors.joinToString(" x "), model.swap(executors, factors).seconds.form(), plain.seconds.form(),
                )
            }
        }
    }

    private fun fitted() = table("fitted or measured", "value") {
        row("drawing, of a triangle", "%.0f ns".form(1e9 * drawing[0]))
        row("drawing, of a fragment", "%.1f ns".form(1e9 * drawing[1]))
        row("drawing, of a sample for each 131,072 triangles", "%.2f ns".form(1e9 * drawing[2]))
        row("drawing, of a sample of the bands of a part", "%.2f ns".form(1e9 * drawing[3]))
        row("merging, of a sample", "%.2f ns".form(1e9 * merging[0]))
        row("merging, of a fragment", "%.1f + %.1f (1 - density) ns".form(1e9 * merging[1], 1e9 * merging[2]))
        row("merging two raw arrays, of a sample", "%.2f ns".form(1e9 * raw.merge(listOf(1L, 1L)).seconds))
        row("fragments of all triangles, for each visible sample", "%.2f".form(facts.overdraw))
        for (split in Split.entries) {
            with(sizes.getValue(split)) {
                row("${split.label()}: exponent of the coverage", "%.2f".form(exponent))
                row("${split.label()}: bytes of a fragment", "%.2f + %.2f (1 - density)".form(bytes[0], bytes[1]))
            }
        }
        row("Spark, an empty task", "%.2f ms".form(1e3 * taskSeconds))
        row("visible samples of the picture", "%,d of %,d".form(facts.visible, facts.samples))
    }

    private fun checks() = table(
        "parts", "", "draw, s", "model", "bytes of a part", "model", "tree, s", "model", "binary swap, s", "model",
    ) {
        for (merging in mergings) {
            val model = model(merging.split)
            val drawn = drawings(merging.split) { it == merging.parts }
            val seconds = drawn.map { it.drawn.seconds }.average()
            val bytes = drawn.map { it.bytes }.average()
            val tree = merging.simulated.getValue(TREE).seconds
            val swap = merging.simulated.getValue(BINARY).seconds
            val all = pictures.sphere.triangles.toDouble()
            row(
                "${merging.parts} ${merging.split.label()}", if (merging.parts <= FITTED) "fitted" else "predicted",
                seconds.form(), deviation(model.drawSeconds(all, merging.parts), seconds),
                "%,.0f".form(bytes), deviation(model.partBytes(merging.parts).toDouble(), bytes),
                tree.form(), deviation(model.tree(merging.parts, SortLast.FAN_IN).seconds, tree),
                swap.form(), deviation(model.swap(merging.parts, factors(merging.parts, 2)).seconds, swap),
            )
        }
    }

    private fun algorithms() = table(
        "parts", "algorithm", "runs: MB of each round", "sum", "all nodes, MB", "s", "raw: sum", "all nodes, MB", "s",
    ) {
        for (merging in mergings.filter { it.parts in SHOWN }) {
            for ((name, runs) in merging.simulated) {
                val plain = MergeSimulation(raw, network)
                val bands = pictures.bandSetUp.let { set -> (0 until set.bands).associateWith { set.region(it).size } }
                val pixels = when (name) {
                    TREE -> plain.tree(List(merging.parts) { bands }, SortLast.FAN_IN)
                    else -> plain.swap(
                        List(merging.parts) { facts.samples }, factors(merging.parts, SWAPS.getValue(name)),
                    )
                }
                row(
                    "${merging.parts} ${merging.split.label()}", name,
                    runs.roundBytes.joinToString(" + ") { it.megabytes() }, runs.roundBytes.sum().megabytes(),
                    runs.totalBytes.megabytes(), runs.seconds.form(),
                    pixels.roundBytes.sum().megabytes(), pixels.totalBytes.megabytes(), pixels.seconds.form(),
                )
            }
        }
    }

    companion object {
        private const val TREE = "Spark's tree"
        private const val BINARY = "binary swap"
        private const val RADIX = "radix-k"

        /** Greatest k of radix-k. */
        const val GREATEST: Int = 8

        /** Greatest k of each algorithm. */
        private val SWAPS = mapOf(BINARY to 2, RADIX to GREATEST)
        private val SHOWN = listOf(4, 16, 64)

        /** The model is fitted to measurements with so many parts at most. */
        private const val FITTED = 16

        /** Merging fewer fragments is not measured exactly. */
        private const val LEAST = 1000

        /** 10 Gbit/s. */
        private const val BYTES_PER_SECOND = 1.25e9
        private const val LATENCY = 1e-3

        /** Of a triangle in an STL file. */
        private const val FILE_BYTES = 50

        /** Of storage, for each executor. */
        private const val READ_BYTES_PER_SECOND = 200e6
        private val TRIANGLES = listOf(1e9, 1e12)
        private const val MOST_DOUBLINGS = 16

        /** Returns factors of [nodes], the greatest first, of which each is [most] or less. */
        fun factors(nodes: Int, most: Int): List<Int> = buildList {
            var rest = nodes
            while (rest > 1) {
                add((minOf(rest, most) downTo 2).first { rest % it == 0 })
                rest /= last()
            }
        }
    }
}
