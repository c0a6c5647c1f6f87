package dev.lazyz.spark.figures

import com.sun.management.OperatingSystemMXBean
import dev.lazyz.Image.PixelHash
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.geometry.UpAxis
import dev.lazyz.scenes.LoadOptions
import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.ImageFiles
import dev.lazyz.scenes.writers.ImageFormat
import dev.lazyz.spark.Models
import dev.lazyz.spark.SortWays
import dev.lazyz.spark.TestSpark
import dev.lazyz.spark.TrianglePicture
import dev.lazyz.spark.TriangleTable
import dev.lazyz.spark.pictures.DistributedPicture
import dev.lazyz.spark.pictures.PictureSource
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.strategies.tiled.TiledRenderer
import dev.lazyz.world.Scene
import java.lang.management.ManagementFactory
import java.nio.file.Files
import kotlin.io.path.writeBytes
import org.apache.spark.sql.functions.col

/**
 * Prints the figures of `docs/spark.md`: processor time with Spark and without, in one run; and what the orders of
 * [TrianglePicture] move and shade.
 */
fun main() {
    processorTime()
    moved()
    System.exit(0)
}

private val system = ManagementFactory.getOperatingSystemMXBean() as OperatingSystemMXBean

private fun seconds(work: () -> Unit): Double {
    System.gc()
    val before = system.processCpuTime
    work()
    return (system.processCpuTime - before) / 1e9
}

/** A picture of a built-in scene, with [factor] x [factor] samples a pixel. */
private class Picture(val id: String, val factor: Int, val width: Int, val height: Int) : PictureSource {
    override fun picture(): SampledFrame = SuperSampling(factor).frame(Scenes.builtin(id)!!, Raster(width, height))

    override fun toString(): String = "$id ${width}x$height aa=$factor"

    private companion object {
        const val serialVersionUID = 1L
    }
}

private val pictures = listOf(
    Picture("city", 2, 3000, 2000),
    Picture("teapot", 4, 2000, 1500),
    Picture("city", 2, 9000, 6000),
    Picture("teapot", 4, 8000, 6000),
)

/** The same PNG file by `local[2]` and by `TiledRenderer` with two threads, in turns; the first turn is not counted. */
private fun processorTime() {
    val folder = Files.createTempDirectory("figures")
    for (each in pictures) {
        val frame = each.picture()
        val renderer = TiledRenderer(RenderOptions(threads = 2))
        val picture = DistributedPicture(TestSpark.session, each)
        val spark = ArrayList<Double>()
        val alone = ArrayList<Double>()
        repeat(3) { turn ->
            val one = seconds {
                ImageFiles.write(
                    folder.resolve("a.png"), each.width, each.height, ImageFormat.PNG, AlphaChannel.DROP,
                ) { frame.render(renderer, it) }
            }
            val two = seconds { picture.writePng(folder.resolve("b.png")) }
            if (turn > 0) {
                alone += one
                spark += two
            }
        }
        check(Files.mismatch(folder.resolve("a.png"), folder.resolve("b.png")) < 0)
        println("$each: TiledRenderer $alone s, Spark $spark s, ratio ${"%.2f".format(spark.min() / alone.min())}")
    }
    folder.toFile().deleteRecursively()
}

private fun moved() {
    val file = TestSpark.folder.resolve("teapot.stl").also { it.writeBytes(Models.stl(64)) }
    val plain = LoadOptions(smoothNormals = false)
    val loaded = Scenes.load(Files.readAllBytes(file), SceneFormat.STL, options = plain).scene.surfaces.single()
    val fitted = TriangleScene { Scene(listOf(it)).withUpAxis(UpAxis.Z) }
    val near = TriangleTable.readStl(TestSpark.session, "$file", partitionBytes = 800_000).cache()
    val mixed = near.repartition(16, col("index")).cache()
    for ((width, height) in listOf(1000 to 750, 2000 to 1500)) {
        val camera = SerializableCamera(fitted.scene(loaded).camera(width, height))
        val scene = TriangleScene { fitted.scene(it).withViewpoint(camera.camera()) }
        val expected = TiledRenderer().render(scene.scene(loaded).frame(width, height))
        println("${width}x$height: ${expected.visible} visible, ${expected.counters.primitives} triangles")
        for ((name, table) in listOf("near" to near, "mixed" to mixed)) {
            for ((order, shading) in SortWays.all) {
                val hash = PixelHash()
                val report = TrianglePicture(table, width, height, scene, order, shading).render { _, argb, _, _ ->
                    hash.add(argb, width)
                }
                check(hash.digest() == expected.pixelHash())
                println(
                    "$name ${table.javaRDD().numPartitions} $order $shading: moved ${report.movedBytes}, " +
                        "shading calls ${report.counters.shadingCalls}"
                )
            }
            println(TrianglePicture(table, width, height, scene).explain())
        }
    }
}
