package dev.lazyz.spark.scaling

import dev.lazyz.spark.scaling.ScalingMeasurements.Companion.BINARY
import dev.lazyz.spark.scaling.ScalingMeasurements.Companion.FITTED
import dev.lazyz.spark.scaling.ScalingMeasurements.Companion.GREATEST
import dev.lazyz.spark.scaling.ScalingMeasurements.Companion.SWAPS
import dev.lazyz.spark.scaling.ScalingMeasurements.Companion.TREE
import dev.lazyz.spark.scaling.ScalingMeasurements.Companion.factors
import kotlin.math.pow
import kotlin.math.roundToInt
import kotlin.math.sqrt

/**
 * The tables of `docs/spark-scaling.md`, as Markdown.
 *
 * @param taskSeconds what Spark's driver needs for a task
 */
internal class ScalingTables(private val measured: ScalingMeasurements, private val taskSeconds: Double) {
    /** Returns all tables, as Markdown. */
    fun report(): String = buildString {
        for (table in listOf(predictions(), limits(), comparison(), fitted(), checks(), algorithms())) appendLine(table)
    }

    /** Seconds by what they are for. */
    private inner class Times(split: Split, triangles: Double, executors: Int) {
        private val model = measured.model(split)
        private val merge = model.tree(executors)
        val read = triangles / executors * FILE_BYTES / READ_BYTES_PER_SECOND
        val draw = model.drawSeconds(triangles, executors)
        val merging = merge.mergeSeconds
        val network = merge.networkSeconds
        val tasksSeconds = (executors + merge.tasks) * taskSeconds
        val total = read + draw + merging + network + tasksSeconds
    }

    private fun predictions() = table(
        "triangles", "executors", "parts", "read, s", "draw, s", "merge, s", "network, s", "Spark's tasks, s",
        "total, s", "of ideal",
    ) {
        for (triangles in TRIANGLES) {
            for (executors in listOf(10, 100, 1000)) {
                for (split in Split.entries) {
                    val ideal = Times(split, triangles, 1).let { it.read + it.draw } / executors
                    with(Times(split, triangles, executors)) {
                        row(
                            power(triangles), "%,d".form(executors), split.label(), read.form(), draw.form(),
                            merging.form(), network.form(), tasksSeconds.form(), total.form(), percent(ideal / total),
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
            val plain = MergeSimulation(measured.raw, measured.network)
                .swap(List(executors) { measured.facts.samples }, factors)
            for (split in Split.entries) {
                val model = measured.model(split)
                row(
                    "%,d".form(executors), split.label(), model.tree(executors).seconds.form(),
                    factors.joinToString(" x "), model.swap(executors, factors).seconds.form(), plain.seconds.form(),
                )
            }
        }
    }

    private fun fitted() = table("fitted or measured", "value") {
        row("drawing, of a triangle", "%.0f ns".form(1e9 * measured.drawing[0]))
        row("drawing, of a fragment", "%.1f ns".form(1e9 * measured.drawing[1]))
        row("drawing, of a sample for each 131,072 triangles", "%.2f ns".form(1e9 * measured.drawing[2]))
        row("drawing, of a sample of the bands of a part", "%.2f ns".form(1e9 * measured.drawing[3]))
        row("merging, of a sample", "%.2f ns".form(1e9 * measured.merging[0]))
        row(
            "merging, of a fragment",
            "%.1f + %.1f (1 - density) ns".form(1e9 * measured.merging[1], 1e9 * measured.merging[2])
        )
        row("merging two raw arrays, of a sample", "%.2f ns".form(1e9 * measured.raw.merge(listOf(1L, 1L)).seconds))
        row("fragments of all triangles, for each visible sample", "%.2f".form(measured.facts.overdraw))
        for (split in Split.entries) {
            with(measured.sizes.getValue(split)) {
                row("${split.label()}: exponent of the coverage", "%.2f".form(exponent))
                row("${split.label()}: bytes of a fragment", "%.2f + %.2f (1 - density)".form(bytes[0], bytes[1]))
            }
        }
        row("Spark, an empty task", "%.2f ms".form(1e3 * taskSeconds))
        row("visible samples of the picture", "%,d of %,d".form(measured.facts.visible, measured.facts.samples))
    }

    private fun checks() = table(
        "parts", "", "draw, s", "model", "bytes of a part", "model", "tree, s", "model", "binary swap, s", "model",
    ) {
        for (merging in measured.mergings) {
            val model = measured.model(merging.split)
            val drawn = measured.drawings(merging.split) { it == merging.parts }
            val seconds = drawn.map { it.drawn.seconds }.average()
            val bytes = drawn.map { it.bytes }.average()
            val tree = merging.simulated.getValue(TREE).seconds
            val swap = merging.simulated.getValue(BINARY).seconds
            val all = measured.pictures.sphere.triangles.toDouble()
            row(
                "${merging.parts} ${merging.split.label()}", if (merging.parts <= FITTED) "fitted" else "predicted",
                seconds.form(), deviation(model.drawSeconds(all, merging.parts), seconds),
                "%,.0f".form(bytes), deviation(model.partBytes(merging.parts).toDouble(), bytes),
                tree.form(), deviation(model.tree(merging.parts).seconds, tree),
                swap.form(), deviation(model.swap(merging.parts, factors(merging.parts, 2)).seconds, swap),
            )
        }
    }

    private fun algorithms() = table(
        "parts", "algorithm", "runs: MB of each round", "sum", "all nodes, MB", "s", "raw: sum", "all nodes, MB", "s",
    ) {
        for (merging in measured.mergings.filter { it.parts in SHOWN }) {
            for ((name, runs) in merging.simulated) {
                val plain = MergeSimulation(measured.raw, measured.network)
                val bands = measured.pictures.bandSetUp.let { set ->
                    (0 until set.bands).associateWith { set.region(it).size }
                }
                val pixels = when (name) {
                    TREE -> plain.tree(List(merging.parts) { bands }, bands.size)
                    else -> plain.swap(
                        List(merging.parts) { measured.facts.samples }, factors(merging.parts, SWAPS.getValue(name)),
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

    private companion object {
        val SHOWN = listOf(4, 16, 64)

        /** Of a triangle in an STL file. */
        const val FILE_BYTES = 50

        /** Of storage, for each executor. */
        const val READ_BYTES_PER_SECOND = 200e6
        val TRIANGLES = listOf(1e9, 1e12)
        const val MOST_DOUBLINGS = 16
    }
}
