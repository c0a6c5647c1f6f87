package dev.lazyz.spark.cluster

import dev.lazyz.PixelHash
import dev.lazyz.Raster
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.Scenes
import dev.lazyz.spark.Models
import dev.lazyz.spark.SortOrder
import dev.lazyz.spark.SortedShading
import dev.lazyz.spark.TrianglePicture
import dev.lazyz.spark.TriangleTable
import dev.lazyz.spark.pictures.DistributedPicture
import dev.lazyz.spark.pictures.PictureSource
import dev.lazyz.spark.triangles.CameraValues
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.strategies.tiled.Tiled
import dev.lazyz.world.Camera
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Surface
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import kotlin.concurrent.thread
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeBytes
import kotlin.system.exitProcess
import org.apache.spark.SparkEnv
import org.apache.spark.SparkException
import org.apache.spark.api.java.JavaSparkContext
import org.apache.spark.api.java.function.Function
import org.apache.spark.sql.SparkSession

/**
 * Breaks things in a cluster of several JVMs, and checks that pictures are still those of one JVM. The script
 * `integrations/spark/cluster/check` starts the cluster and this program.
 *
 * The arguments are the master, a folder for files, and a folder on a small disk or "-".
 */
fun main(arguments: Array<String>) {
    val (master, folder, smallDisk) = arguments
    val spark = SparkSession.builder().master(master).appName("fault drill")
        .config("spark.ui.enabled", false)
        .config("spark.driver.host", "127.0.0.1")
        .config("spark.driver.bindAddress", "127.0.0.1")
        .config("spark.executor.cores", 1)
        .config("spark.executor.memory", "512m")
        .config("spark.executor.extraClassPath", System.getProperty("java.class.path"))
        .config("spark.speculation", true)
        .config("spark.speculation.interval", "100ms")
        .config("spark.speculation.multiplier", "1.5")
        .config("spark.speculation.quantile", "0.5")
        .getOrCreate()
    val drill = FaultDrill(spark, Path.of(folder))
    try {
        drill.aKilledExecutorChangesNoPicture()
        drill.aKilledExecutorChangesNoTriangles()
        drill.aSlowWorkerIsOvertaken()
        if (smallDisk == "-") {
            println("SKIPPED a disk is full: there is no small disk")
        } else {
            drill.aFullDiskLeavesNothing(Path.of(smallDisk))
        }
    } finally {
        spark.stop()
    }
    exitProcess(if (drill.failed == 0) 0 else 1)
}

/** A scene whose making takes a second in each JVM, and much longer in the first executor if it is slow. */
private class SlowCity(private val isSlow: Boolean) : PictureSource {
    override fun picture(): SampledFrame {
        val executor = SparkEnv.get()?.executorId()
        if (executor != "driver") Thread.sleep(if (isSlow && executor == "0") 60_000 else 2000)
        return SuperSampling(2).frame(Scenes.city(), Raster(1600, 1200))
    }

    private companion object {
        const val serialVersionUID = 1L
    }
}

/** The scene of triangles, which takes a while in each task. */
private object SlowTriangles : TriangleScene {
    private const val serialVersionUID = 1L

    override fun scene(triangles: Surface): Scene {
        if (SparkEnv.get()?.executorId() != "driver") Thread.sleep(500)
        return Scene(listOf(triangles), viewpoint = Camera.fit()).withUpAxis(UpAxis.Z)
    }
}

private class Pid : Function<Int, Long> {
    override fun call(number: Int): Long {
        Thread.sleep(300)
        return ProcessHandle.current().pid()
    }

    private companion object {
        const val serialVersionUID = 1L
    }
}

private class FaultDrill(private val spark: SparkSession, private val folder: Path) {
    private val context = JavaSparkContext.fromSparkContext(spark.sparkContext())
    var failed = 0
        private set

    private fun report(what: String, expected: Any, actual: Any, details: String) {
        if (expected != actual) failed++
        println("${if (expected == actual) "PASSED" else "FAILED"} $what: $actual ($details)")
    }

    private fun executors(): Set<Long> = context.parallelize((0 until 8).toList(), 8).map(Pid()).collect().toSet()

    /** Kills one executor of this application after some milliseconds. */
    private fun killing(after: Long, work: () -> Unit): String {
        val all = executors()
        val victim = all.first()
        var killed = false
        val killer = thread {
            Thread.sleep(after)
            killed = ProcessHandle.of(victim).map { it.destroyForcibly() }.orElse(false)
        }
        val start = System.nanoTime()
        work()
        killer.join()
        check(killed) { "the executor $victim was not there any more" }
        return "process $victim of $all was killed after $after ms of ${(System.nanoTime() - start) / 1_000_000}"
    }

    fun aKilledExecutorChangesNoPicture() {
        val source = SlowCity(isSlow = false)
        val expected = source.picture().render(Tiled()).pixelHash()
        val hash = PixelHash()
        val details = killing(3000) {
            DistributedPicture(spark, source).render { _, argb, _, _ -> hash.add(argb, 1600) }
        }
        report("an executor is killed, sort-first", expected, hash.digest(), details)
    }

    fun aKilledExecutorChangesNoTriangles() {
        val file = folder.resolve("teapot.stl").also { it.writeBytes(Models.stl(24)) }
        val loaded = Scenes.load(file, LoadOptions(smoothNormals = false)).scene.surfaces.single()
        val camera = CameraValues(SlowTriangles.scene(loaded).camera(1200, 900))
        val seen = TriangleScene { SlowTriangles.scene(it).withViewpoint(camera.camera()) }
        val expected = Tiled().render(seen.scene(loaded).frame(1200, 900)).pixelHash()
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 100_000)
        for ((order, shading) in listOf(
            SortOrder.LAST to SortedShading.EAGER,
            SortOrder.LAST to SortedShading.LAZY,
            SortOrder.MIDDLE to SortedShading.EAGER,
        )) {
            val hash = PixelHash()
            val details = killing(4000) {
                TrianglePicture(triangles, 1200, 900, seen, order, shading).render { _, argb, _, _ ->
                    hash.add(argb, 1200)
                }
            }
            report("an executor is killed, $order, $shading", expected, hash.digest(), details)
        }
    }

    fun aSlowWorkerIsOvertaken() {
        executors()
        val source = SlowCity(isSlow = true)
        val expected = SlowCity(false).picture().render(Tiled())
        val start = System.nanoTime()
        DistributedPicture(spark, source).writeDeepZoom(folder.resolve("slow.dzi"))
        val seconds = (System.nanoTime() - start) / 1_000_000_000
        val names = folder.listDirectoryEntries("*slow*").map { it.name }.sorted()
        report("a worker is slow, and its tasks run twice: files", listOf("slow.dzi", "slow_files"), names, "$seconds s")
        val levels = folder.resolve("slow_files").listDirectoryEntries().map { it.name.toInt() }.sorted()
        val strays = Files.walk(folder.resolve("slow_files")).use { all ->
            all.filter { Files.isRegularFile(it) && !it.name.endsWith(".png") }.count()
        }
        report("levels and strays", "${(0..11).toList()} 0", "$levels $strays", "${expected.visible} visible")
    }

    fun aFullDiskLeavesNothing(disk: Path) {
        val outcome = try {
            DistributedPicture(spark, SlowCity(isSlow = false)).writeDeepZoom(disk.resolve("full.dzi"))
            "written"
        } catch (e: IOException) {
            "refused"
        } catch (e: SparkException) {
            "refused"
        }
        val left = disk.listDirectoryEntries().map { it.name }
        report("a disk is full", "refused []", "$outcome $left", "$disk")
    }
}
