package dev.lazyz.spark.scaling

import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SparkSession

/**
 * Prints the tables of `docs/spark-scaling.md`: measures parts of a picture, fits a model to parts of few executors,
 * compares it with the others, and predicts more executors and triangles.
 */
internal fun main(args: Array<String>) {
    require(args.isEmpty()) { "no arguments are known: ${args.joinToString(" ")}" }
    val measured = ScalingMeasurements(PartPictures(BumpySphere(RINGS), SIDE, SIDE, STRIPS))
    val small = PartPictures(BumpySphere(RINGS / 3), SIDE, SIDE, STRIPS)

    // Let the JVM compile what is measured
    repeat(2) { for (split in Split.entries) measured.measure(small, split, 4, keep = false) }
    for (split in Split.entries) {
        for (parts in listOf(4, 16)) measured.measureDrawing(small, split, parts)
        for (parts in ScalingMeasurements.PARTS) measured.measure(measured.pictures, split, parts, keep = true)
    }
    println(ScalingTables(measured, taskSeconds()).report())
}

private const val SIDE = 2048
private const val STRIPS = 64
private const val RINGS = 1000

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
