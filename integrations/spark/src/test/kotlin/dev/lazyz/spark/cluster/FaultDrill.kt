package dev.lazyz.spark.cluster

import dev.lazyz.Image.PixelHash
import dev.lazyz.Raster
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.spark.ModelPictures
import dev.lazyz.spark.Models
import dev.lazyz.spark.SortOrder
import dev.lazyz.spark.SortWays
import dev.lazyz.spark.TrianglePicture
import dev.lazyz.spark.TriangleTable
import dev.lazyz.spark.pictures.DistributedPicture
import dev.lazyz.spark.pictures.PictureSource
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.surface.Surface
import java.io.IOException
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import kotlin.concurrent.thread
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
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
    val parts = Path.of(folder, "parts")
    val left = FirstDriver(master, parts).runAndKill()
    val spark = drillSession(master, "fault drill")
    val drill = FaultDrill(spark, Path.of(folder))
    try {
        drill.anotherDriverContinues(parts, left)
        drill.aPoisonedPartitionChangesNothing()
        drill.poisonedModelsFailAlone()
        drill.aSlowWorkerIsOvertaken()
        if (smallDisk == "-") {
            println("SKIPPED a disk is full: there is no small disk")
        } else {
            drill.aFullDiskLeavesNothing(Path.of(smallDisk))
        }
        drill.aKilledExecutorChangesNoTriangles()
        drill.aKilledExecutorChangesNoPicture()
    } finally {
        spark.stop()
    }
    exitProcess(if (drill.failed == 0) 0 else 1)
}

/** Returns a session on the cluster, with speculative execution. */
internal fun drillSession(master: String, name: String, executorMemory: String = "512m"): SparkSession =
    SparkSession.builder().master(master).appName(name)
        .config("spark.ui.enabled", false)
        .config("spark.driver.host", "127.0.0.1")
        .config("spark.driver.bindAddress", "127.0.0.1")
        .config("spark.executor.cores", 1)
        .config("spark.executor.memory", executorMemory)
        .config("spark.executor.extraClassPath", System.getProperty("java.class.path"))
        .config("spark.speculation", true)
        .config("spark.speculation.interval", "100ms")
        .config("spark.speculation.multiplier", "1.5")
        .config("spark.speculation.quantile", "0.5")
        .getOrCreate()

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
        if (SparkEnv.get()?.executorId() != "driver") Thread.sleep(100)
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

    /** [left] parts are there from a driver that was killed. */
    fun anotherDriverContinues(parts: Path, left: Int) {
        val expected = SlowRows.picture().render(TiledRenderer()).pixelHash()
        val hash = PixelHash()
        FirstDriver.picture(spark, parts).render { _, argb, _, _ -> hash.add(argb, 1600) }
        report("a driver is killed", expected, hash.digest(), "$left parts were finished")
        report("its parts are gone", false, Files.exists(parts), "$parts")
    }

    fun aPoisonedPartitionChangesNothing() {
        val clean = folder.resolve("clean.stl").also { it.writeBytes(Models.stl(24)) }
        val scene = Scene(load(clean), viewpoint = Camera.fit()).withUpAxis(UpAxis.Z)
        val camera = SerializableCamera(scene.camera(800, 600))
        val file = folder.resolve("poisoned.stl").also { it.writeBytes(poisoned(clean.readBytes())) }
        val seen = TriangleScene { Scene(listOf(it), viewpoint = camera.camera()) }
        val expected = TiledRenderer().render(seen.scene(load(file).single()).frame(800, 600)).pixelHash()
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 100_000)
        for (order in SortOrder.entries) {
            val hash = PixelHash()
            TrianglePicture(triangles, 800, 600, seen, order).render { _, argb, _, _ -> hash.add(argb, 800) }
            report("a partition is poisoned, $order", expected, hash.digest(), "${triangles.count()} triangles")
        }
    }

    private fun load(file: Path): List<Surface> = Scenes.load(file, LoadOptions(smoothNormals = false)).scene.surfaces

    /** Returns an STL file of which a range of triangles has corners that are no numbers, or infinite. */
    private fun poisoned(stl: ByteArray): ByteArray {
        val bytes = ByteBuffer.wrap(stl).order(ByteOrder.LITTLE_ENDIAN)
        val bad = listOf(Float.NaN, Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY)
        val count = bytes.getInt(80)
        for (i in count / 3 until count / 2) bytes.putFloat(84 + 50 * i + 12 + 4 * (i % 9), bad[i % bad.size])
        return stl
    }

    fun poisonedModelsFailAlone() {
        val models = Models.collection(folder.resolve("models"))
        val files = spark.read().format("binaryFile").load("$models")
        val rows = ModelPictures.render(files, "size=64x64").collectAsList()
        val outcomes = rows.associate {
            Path.of(it.getString(it.fieldIndex("name"))).name to (it.getString(it.fieldIndex("error")) == null)
        }
        val expected = mapOf(
            "cut.stl" to false, "missing.obj" to false, "teapot.stl" to true, "tetrahedron.obj" to true,
            "words.ply" to false,
        )
        report("models are poisoned", expected, outcomes.toSortedMap(), "one row each")
    }

    fun aKilledExecutorChangesNoPicture() {
        val source = SlowCity(isSlow = false)
        val expected = source.picture().render(TiledRenderer()).pixelHash()
        val hash = PixelHash()
        val details = killing(3000) {
            DistributedPicture(spark, source).render { _, argb, _, _ -> hash.add(argb, 1600) }
        }
        report("an executor is killed, sort-first", expected, hash.digest(), details)
    }

    fun aKilledExecutorChangesNoTriangles() {
        val file = folder.resolve("teapot.stl").also { it.writeBytes(Models.stl(24)) }
        val loaded = Scenes.load(file, LoadOptions(smoothNormals = false)).scene.surfaces.single()
        val camera = SerializableCamera(SlowTriangles.scene(loaded).camera(1200, 900))
        val seen = TriangleScene { SlowTriangles.scene(it).withViewpoint(camera.camera()) }
        val expected = TiledRenderer().render(seen.scene(loaded).frame(1200, 900)).pixelHash()
        val triangles = TriangleTable.readStl(spark, "$file", partitionBytes = 100_000)
        for ((order, shading) in SortWays.all) {
            val hash = PixelHash()
            val details = killing(2000) {
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
        val expected = SlowCity(false).picture().render(TiledRenderer())
        val start = System.nanoTime()
        DistributedPicture(spark, source).writeDeepZoom(folder.resolve("slow.dzi"))
        val seconds = (System.nanoTime() - start) / 1_000_000_000
        val names = folder.listDirectoryEntries("*slow*").map { it.name }.sorted()
        report("a worker is slow: files", listOf("slow.dzi", "slow_files"), names, "$seconds s")
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
