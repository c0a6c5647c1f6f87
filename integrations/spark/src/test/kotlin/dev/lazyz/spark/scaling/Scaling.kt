package dev.lazyz.spark.scaling

import dev.lazyz.spark.triangles.jobs.SortLast
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.sql.SparkSession

/**
 * Prints the data of `docs/spark-scaling.md`: what parts of a picture take that are drawn and merged, and what the sum
 * of all steps is for more executors and triangles.
 */
fun main() {
    val measured = PartPictures(BumpySphere(RINGS), SIDE, SIDE)
    repeat(2) { for (split in Split.entries) measure(PartPictures(BumpySphere(RINGS / 3), SIDE, SIDE), split, 4) }
    val all = Split.entries.associateWith { split -> PARTS.map { measure(measured, split, it) } }
    val near = all.getValue(Split.RANGES)
    println("parts,near: draw s,model,bytes of a part,a round s,mixed: draw s,bytes of a part,a round s")
    for ((cost, mixed) in near.zip(all.getValue(Split.SCATTERED))) {
        val model = drawing(near).invoke(TRIANGLES / cost.parts)
        val scattered = with(mixed) { "$draw,$bytes,$round" }
        println("${cost.parts},${cost.draw},$model,${cost.bytes},${cost.round},$scattered")
    }
    val task = taskSeconds()
    println("\ntask s\n$task\n\ntriangles,executors,read s,draw s,merge and network s,tasks s,total s,of ideal")
    for (triangles in listOf(1e9, 1e12)) {
        for (executors in listOf(10, 100, 1000)) {
            println("$triangles,$executors,${Times(near, triangles, executors, measured.setUp.bands, task)}")
        }
    }
}

/** The mean of drawing one of [parts] parts, and the longest round of merging them with the bytes that it sends. */
private class Cost(val parts: Int, val draw: Double, val bytes: Long, val round: Double)

private fun measure(pictures: PartPictures, split: Split, parts: Int): Cost {
    val drawn = List(parts) { pictures.draw(it, parts, split) }
    val rounds = pictures.merged(drawn.flatMap { it.value }, parts).second
    val bytes = drawn.sumOf { part -> part.value.sumOf { it.part.runs.size.toLong() } } / parts
    val longest = rounds.maxOf { LATENCY + it.bytes / BYTES_PER_SECOND + it.seconds }
    return Cost(parts, drawn.map { it.seconds }.average(), bytes, longest)
}

/** Seconds of drawing by the number of triangles: a line with the least squares of relative errors. */
private fun drawing(costs: List<Cost>): (Double) -> Double {
    // Each divided by what was measured: the constant part, and the number of triangles
    val fitted = costs.filter { it.parts <= FITTED }.map { 1 / it.draw to TRIANGLES / it.parts / it.draw }
    val aa = fitted.sumOf { it.first * it.first }
    val ab = fitted.sumOf { it.first * it.second }
    val bb = fitted.sumOf { it.second * it.second }
    val (ac, bc) = fitted.sumOf { it.first } to fitted.sumOf { it.second }
    val determinant = aa * bb - ab * ab
    return { triangles -> (ac * bb - bc * ab + (aa * bc - ab * ac) * triangles) / determinant }
}

/** Seconds by what they are for. Merging takes no longer in each round than it did in the longest that was measured. */
private class Times(costs: List<Cost>, triangles: Double, executors: Int, bands: Int, task: Double) {
    private val groups = SortLast.groups(executors)
    private val read = triangles / executors * FILE_BYTES / READ_BYTES_PER_SECOND
    private val draw = drawing(costs).invoke(triangles / executors)
    private val merge = groups.size * costs.maxOf { it.round }
    private val tasks = (executors + groups.sumOf { SortLast.tasks(executors, bands, it) }) * task
    private val total = read + draw + merge + tasks
    private val ideal = (triangles * FILE_BYTES / READ_BYTES_PER_SECOND + drawing(costs).invoke(triangles)) / executors

    override fun toString(): String = "$read,$draw,$merge,$tasks,$total,${ideal / total}"
}

private const val SIDE = 2048
private const val RINGS = 1000
private const val TRIANGLES = 4.0 * RINGS * RINGS

/** The numbers of parts that are measured, and the greatest to which the line is fitted. */
private val PARTS = listOf(2, 4, 8, 16, 32, 64)
private const val FITTED = 16

/** Of a network of 10 Gbit/s. */
private const val BYTES_PER_SECOND = 1.25e9
private const val LATENCY = 1e-3

/** Of a triangle in an STL file, and of storage, for each executor. */
private const val FILE_BYTES = 50
private const val READ_BYTES_PER_SECOND = 200e6

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
