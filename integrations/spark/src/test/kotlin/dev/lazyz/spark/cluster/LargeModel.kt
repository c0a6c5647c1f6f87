package dev.lazyz.spark.cluster

import dev.lazyz.Image.PixelHash
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.spark.SortWays
import dev.lazyz.spark.TrianglePicture
import dev.lazyz.spark.TriangleTable
import dev.lazyz.spark.scaling.BumpySphere
import dev.lazyz.spark.triangles.SerializableCamera
import dev.lazyz.spark.triangles.TriangleScene
import dev.lazyz.strategies.tiled.TiledRenderer
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE_NEW
import java.nio.file.StandardOpenOption.WRITE
import kotlin.math.ceil
import kotlin.math.sqrt
import kotlin.system.exitProcess

/**
 * Renders a binary STL file of many triangles in a cluster, by each order of sorting, and compares the pictures with
 * that of one JVM that reads the file part by part. The script `integrations/spark/cluster/check` starts the cluster
 * and this program.
 *
 * The arguments are the master, a folder for files, and the number of triangles in millions, at least.
 */
fun main(arguments: Array<String>) {
    val (master, folder, millions) = arguments
    val rings = ceil(sqrt(millions.toInt() * 1e6 / 4)).toInt()
    val file = Path.of(folder, "large.stl")
    val triangles = writeSphere(file, rings)
    println("a sphere of $triangles triangles, ${Files.size(file)} bytes")

    val camera = SerializableCamera(BumpySphere(PREVIEW).camera(WIDTH, HEIGHT))
    val seen = TriangleScene { BumpySphere.SCENE.scene(it).withViewpoint(camera.camera()) }
    val (expected, alone) = timed {
        val hash = PixelHash()
        Scenes.stream(file).use { streamed ->
            val scene = seen.scene(streamed.loaded.scene.surfaces.single())
            TiledRenderer().render(scene.frame(WIDTH, HEIGHT)) { _, argb, _, _ -> hash.add(argb, WIDTH) }
        }
        hash.digest()
    }
    println("one JVM: $expected, $alone s")

    var failed = 0
    val spark = drillSession(master, "large model", executorMemory = "1g")
    try {
        val table = TriangleTable.readStl(spark, "$file")
        println(TrianglePicture(table, WIDTH, HEIGHT, seen).explain())
        for ((order, shading) in SortWays.all) {
            val hash = PixelHash()
            val (report, seconds) = timed {
                TrianglePicture(table, WIDTH, HEIGHT, seen, order, shading)
                    .render { _, argb, _, _ -> hash.add(argb, WIDTH) }
            }
            val digest = hash.digest()
            if (digest != expected) failed++
            println(
                "${if (digest == expected) "PASSED" else "FAILED"} $order, $shading: $digest, $seconds s, " +
                    "${report.movedBytes} bytes moved",
            )
        }
    } finally {
        spark.stop()
    }
    exitProcess(if (failed == 0) 0 else 1)
}

private const val WIDTH = 2000
private const val HEIGHT = 1500

/** Rings of the sphere that the camera is fitted to. */
private const val PREVIEW = 100

/** Returns the result of [work], and how many seconds it took. */
private fun <T> timed(work: () -> T): Pair<T, Long> {
    val start = System.nanoTime()
    return work() to (System.nanoTime() - start) / 1_000_000_000
}

/** Writes a [BumpySphere] of so many [rings], ring by ring, and returns its number of triangles. */
private fun writeSphere(file: Path, rings: Int): Int {
    val columns = 2 * rings
    val triangles = 2 * rings * columns
    FileChannel.open(file, CREATE_NEW, WRITE).use { channel ->
        channel.write(ByteBuffer.allocate(84).order(ByteOrder.LITTLE_ENDIAN).putInt(80, triangles))
        val bytes = ByteBuffer.allocate(100 * columns).order(ByteOrder.LITTLE_ENDIAN)
        var above = BumpySphere.ring(rings, 0)
        for (i in 1..rings) {
            val below = BumpySphere.ring(rings, i)
            bytes.clear()
            for (j in 0 until columns) {
                bytes.facet(above, j, above, j + 1, below, j)
                bytes.facet(above, j + 1, below, j + 1, below, j)
            }
            bytes.flip()
            while (bytes.hasRemaining()) channel.write(bytes)
            above = below
        }
    }
    return triangles
}

/** Puts a facet without a normal; each corner is a ring, and the number of a vertex in it. */
private fun ByteBuffer.facet(a: FloatArray, i: Int, b: FloatArray, j: Int, c: FloatArray, k: Int) {
    for (zero in 0 until 3) putFloat(0f)
    corner(a, i)
    corner(b, j)
    corner(c, k)
    putShort(0)
}

private fun ByteBuffer.corner(ring: FloatArray, vertex: Int) {
    for (axis in 0 until 3) putFloat(ring[3 * vertex + axis])
}
