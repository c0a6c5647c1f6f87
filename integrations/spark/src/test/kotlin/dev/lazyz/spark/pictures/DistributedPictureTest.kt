package dev.lazyz.spark.pictures

import dev.lazyz.Image.PixelHash
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Rgba
import dev.lazyz.filter.SampledFrame
import dev.lazyz.filter.SuperSampling
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.writers.AlphaChannel
import dev.lazyz.scenes.writers.deepzoom.DeepZoomFiles
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.spark.TestSpark
import dev.lazyz.strategies.tiled.TiledRenderer
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.atomic.AtomicInteger
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.apache.spark.SparkException
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

class DistributedPictureTest {
    private val spark = TestSpark.session

    /** A built-in scene; what is sent to tasks is its name. */
    private class Builtin(
        private val id: String,
        private val width: Int,
        private val height: Int,
        private val factor: Int,
        private val isTransparent: Boolean = false,
    ) : PictureSource {
        override fun picture(): SampledFrame {
            made.incrementAndGet()
            val scene = Scenes.builtin(id)!!
            val clear = if (isTransparent) scene.withBackground(Rgba.TRANSPARENT) else scene
            val raster = Raster(width, height, clear.background)
            return SuperSampling(factor).frame(clear, raster)
        }

        companion object {
            private const val serialVersionUID = 1L
            val made = AtomicInteger()
        }
    }

    @ParameterizedTest
    @ValueSource(ints = [1, 4])
    fun bitsAreThoseOfOneJvm(factor: Int) {
        val source = Builtin("city", 300, 500, factor)
        val image = source.picture().render(TiledRenderer())
        val picture = DistributedPicture(spark, source)
        assertEquals("300 x 500", "${picture.width} x ${picture.height}")
        val hash = PixelHash()
        val before = Builtin.made.get()
        var rows = 0
        val counters = picture.render { y, argb, depth, primitive ->
            assertEquals(rows++, y)
            hash.add(argb, 300)
            for (x in 0 until 300) {
                assertEquals(image.depth(x, y), depth[x])
                assertEquals(image.primitive(x, y), primitive[x])
            }
        }
        assertEquals(image.pixelHash(), hash.digest())
        assertEquals(500, rows)
        assertEquals(image.counters.primitives, counters.primitives)
        assertEquals(image.counters.fragments > 0, counters.fragments > 0)
        if (factor == 1) assertEquals(image.counters.shadingCalls, counters.shadingCalls)

        // The scene is made once in each JVM, not once for each task
        assertEquals(before, Builtin.made.get())
    }

    @Test
    fun filesHaveTheBytesOfOneJvm(@TempDir folder: Path) {
        val source = Builtin("teapot", 200, 150, 2)
        DistributedPicture(spark, source).writePng(folder.resolve("teapot.png"))
        val image = source.picture().render(TiledRenderer())
        assertArrayEquals(image.toPng(), folder.resolve("teapot.png").readBytes())
        assertEquals(listOf("teapot.png"), folder.listDirectoryEntries().map { it.name })
    }

    /** Sides just above and below multiples of tiles and blocks, and more levels than blocks have. */
    @ParameterizedTest
    @ValueSource(strings = ["300x200", "1x1", "4097x1025", "5000x2100", "254x255"])
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun pyramidsHaveThePixelsOfOneJvm(size: String, @TempDir folder: Path) {
        val (width, height) = size.split('x').map { it.toInt() }
        val source = Builtin("star", width, height, 1, isTransparent = size == "300x200")
        val alpha = if (size == "300x200") AlphaChannel.KEEP else AlphaChannel.DROP
        DistributedPicture(spark, source).writeDeepZoom(folder.resolve("spark.dzi"))
        DeepZoomFiles.write(folder.resolve("one.dzi"), width, height, alpha) {
            source.picture().render(TiledRenderer(RenderOptions()), it)
        }
        assertEquals(folder.resolve("one.dzi").readText(), folder.resolve("spark.dzi").readText())
        val names = setOf("one.dzi", "one_files", "spark.dzi", "spark_files")
        assertEquals(names, folder.listDirectoryEntries().map { it.name }.toSet())
        assertEquals(tiles(folder.resolve("one_files")), tiles(folder.resolve("spark_files")))
    }

    /** Names and pixels of all tiles. */
    private fun tiles(folder: Path): Map<String, List<Int>> = Files.walk(folder).use { all ->
        all.filter { Files.isRegularFile(it) }.toList().associate { file ->
            val picture = Picture.read(file)
            val pixels = (0 until picture.height).flatMap { y -> (0 until picture.width).map { picture.argb(it, y) } }
            "${folder.relativize(file)}" to listOf(picture.width, picture.height, pixels.hashCode())
        }
    }

    @Test
    fun failuresLeaveNothing(@TempDir folder: Path) {
        val picture = DistributedPicture(spark, FailsInTasks())
        assertThrows(SparkException::class.java) { picture.writePng(folder.resolve("a.png")) }
        assertThrows(SparkException::class.java) { picture.writeDeepZoom(folder.resolve("a.dzi")) }
        assertEquals(listOf<Path>(), folder.listDirectoryEntries())
        val missing = folder.resolve("missing/a.dzi")
        val error = assertThrows(IOException::class.java) { picture.writeDeepZoom(missing) }
        assertTrue("no folder" in error.message!!, error.message)
        val png = folder.resolve("a.png")
        val refused = assertThrows(IllegalArgumentException::class.java) { picture.writeDeepZoom(png) }
        assertTrue("must end in .dzi" in refused.message.orEmpty(), refused.message)
    }

    /** Primitives that throw when they are drawn. */
    private class FailsInTasks : PictureSource {
        override fun picture(): SampledFrame {
            val frame = Scenes.builtin("teapot")!!.frame(40, 40)
            return SuperSampling.NONE.of(frame.observed { _, _, _ -> error("no colour today") })
        }

        private companion object {
            const val serialVersionUID = 1L
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun anotherDriverContinuesWithTheParts(@TempDir folder: Path) {
        val parts = folder.resolve("parts")
        val facts = mapOf("model" to "star")
        val expected = Interrupted().picture().render(TiledRenderer()).pixelHash()
        fun picture() = DistributedPicture(spark, Interrupted()).checkpointed(parts, facts)
        Interrupted.parts = parts
        Interrupted.failsFrom = 300
        assertThrows(SparkException::class.java) { picture().render { _, _, _, _ -> } }
        val kept = parts.listDirectoryEntries("*.part").sortedBy { it.name.split('-')[1].toInt() }
        assertTrue(kept.size >= 2, "$kept")

        // A picture of something else is refused, and damaged parts are rendered again
        val other = DistributedPicture(spark, Interrupted()).checkpointed(parts, mapOf("model" to "teapot"))
        val error = assertThrows(IOException::class.java) { other.render { _, _, _, _ -> } }
        assertTrue("(\"model: star\", and now \"model: teapot\")" in error.message!!, error.message)
        kept[0].writeBytes(kept[0].readBytes().dropLast(9).toByteArray())
        kept[1].writeBytes(kept[1].readBytes().also { it[it.size / 2] = (it[it.size / 2] + 1).toByte() })

        Interrupted.failsFrom = Int.MAX_VALUE
        Interrupted.rows.clear()
        val hash = PixelHash()
        picture().render { _, argb, _, _ -> hash.add(argb, 600) }
        assertEquals(expected, hash.digest())
        for ((i, part) in kept.withIndex()) {
            val (_, start, _, end) = part.name.split('-').map { it.removeSuffix(".part").toInt() }
            assertEquals(i < 2, Interrupted.rows.any { it in start until end }, part.name)
        }
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }

    @Test
    fun partsAreNotPutAmongOtherFiles(@TempDir folder: Path) {
        folder.resolve("notes.txt").writeText("mine")
        val picture = DistributedPicture(spark, Builtin("teapot", 20, 15, 1)).checkpointed(folder, emptyMap())
        val error = assertThrows(IOException::class.java) { picture.writePng(folder.resolve("a.png")) }
        assertEquals("$folder has other files than the parts of a picture; name another folder", error.message)
        assertEquals(listOf("notes.txt"), folder.listDirectoryEntries().map { it.name })
    }

    /** A picture whose rows from [failsFrom] on cannot be shaded. Notes which rows were. */
    private class Interrupted : PictureSource {
        override fun picture(): SampledFrame {
            val frame = Scenes.builtin("star")!!.frame(600, 600)
            return SuperSampling.NONE.of(
                frame.observed { _, y, _ ->
                    if (y >= failsFrom) {
                        // On a busy machine, the parts above may come later
                        while (parts.listDirectoryEntries("*.part").size < 2) Thread.sleep(1)
                        error("interrupted")
                    }
                    rows.add(y)
                },
            )
        }

        companion object {
            private const val serialVersionUID = 1L
            val rows: MutableSet<Int> = ConcurrentHashMap.newKeySet()

            @Volatile
            var failsFrom = Int.MAX_VALUE

            @Volatile
            var parts: Path = Path.of("")
        }
    }
}
