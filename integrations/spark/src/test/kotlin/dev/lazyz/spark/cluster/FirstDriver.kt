package dev.lazyz.spark.cluster

import dev.lazyz.Raster
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.spark.pictures.DistributedPicture
import dev.lazyz.spark.pictures.PictureSource
import java.lang.management.ManagementFactory
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.listDirectoryEntries
import org.apache.spark.SparkEnv
import org.apache.spark.sql.SparkSession

/** Renders a picture with a checkpoint, as a driver that is killed. The arguments are those of [FirstDriver]. */
fun main(arguments: Array<String>) {
    val (master, parts) = arguments
    FirstDriver.picture(drillSession(master, "first driver"), Path.of(parts)).render { _, _, _, _ -> }
}

/** Starts a driver, kills it when some parts of its picture are finished, and knows the picture. */
internal class FirstDriver(private val master: String, private val parts: Path) {
    /** Returns how many parts are left. */
    fun runAndKill(): Int {
        val options = ManagementFactory.getRuntimeMXBean().inputArguments.filter { it.startsWith("--add-opens") }
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val words = listOf(java) + options +
            listOf("-cp", System.getProperty("java.class.path"), MAIN, master, "$parts")
        val driver = ProcessBuilder(words).redirectErrorStream(true)
            .redirectOutput(ProcessBuilder.Redirect.DISCARD).start()
        while (driver.isAlive && finished() < ENOUGH) Thread.sleep(POLL)
        check(driver.isAlive) { "the driver has ended with ${driver.exitValue()} before it was killed" }
        driver.destroyForcibly()
        check(driver.waitFor(PATIENCE, TimeUnit.SECONDS)) { "the driver cannot be killed" }
        return finished()
    }

    private fun finished(): Int = if (Files.isDirectory(parts)) parts.listDirectoryEntries("*.part").size else 0

    companion object {
        private const val MAIN = "dev.lazyz.spark.cluster.FirstDriverKt"
        private const val ENOUGH = 3
        private const val POLL = 20L
        private const val PATIENCE = 30L

        /** Returns the picture whose parts stay in [parts]. */
        fun picture(spark: SparkSession, parts: Path): DistributedPicture =
            DistributedPicture(spark, SlowRows).checkpointed(parts, mapOf("scene" to "city"))
    }
}

/** A picture each of whose parts takes a while in a task. */
internal object SlowRows : PictureSource {
    private const val serialVersionUID = 1L
    private const val EVERY = 400

    override fun picture(): SampledFrame {
        val frame = Scenes.city().frame(Raster(1600, 1200))
        if (SparkEnv.get()?.executorId() in listOf(null, "driver")) return SuperSampling.NONE.of(frame)
        return SuperSampling.NONE.of(frame.observed { x, _, _ -> if (x % EVERY == 0) Thread.sleep(5) })
    }
}
