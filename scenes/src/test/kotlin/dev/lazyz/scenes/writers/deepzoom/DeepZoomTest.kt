package dev.lazyz.scenes.writers.deepzoom

import dev.lazyz.RowSink
import dev.lazyz.filter.BoxPyramid
import dev.lazyz.scenes.writers.AlphaChannel
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.util.Random
import javax.imageio.ImageIO
import kotlin.io.path.createDirectories
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.exists
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class DeepZoomTest {
    @TempDir
    lateinit var folder: Path

    private val path get() = folder.resolve("a.dzi")
    private val tiles get() = folder.resolve("a_files")

    /** The borders of tiles are at multiples of 254; sizes just beyond one have tiles of a pixel. */
    @Test
    fun everyTileShowsItsPartOfItsLevel() {
        for ((width, height) in listOf(1 to 1, 3 to 2, 254 to 255, 256 to 257, 509 to 700, 700 to 508)) {
            for (alpha in AlphaChannel.entries) {
                DeepZoomFiles.write(path, width, height, alpha) { sink -> send(sink, width, height) }
                requireLevels(width, height, alpha)
            }
        }
    }

    /** A block has 34 rows here. */
    @Test
    fun tilesOfWidePicturesAreWrittenInBlocks() {
        DeepZoomFiles.write(path, 30_000, 40, AlphaChannel.DROP) { sink -> send(sink, 30_000, 40) }
        requireLevels(30_000, 40, AlphaChannel.DROP)
    }

    @Test
    fun aFailureLeavesNothing() {
        assertThrows<IllegalStateException> {
            DeepZoomFiles.write(path, 300, 900) { sink -> send(sink, 300, 900, stop = 600) }
        }
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
        val short = assertThrows<IOException> { DeepZoomFiles.write(path, 9, 9) { sink -> send(sink, 9, 8) } }
        assertEquals("cannot write $path: the image is incomplete: 8 of 9 rows", short.message)
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }

    @Test
    fun aPyramidIsReplacedWhenTheNewOneIsComplete() {
        DeepZoomFiles.write(path, 300, 300) { sink -> send(sink, 300, 300) }
        val before = content(folder)
        assertThrows<IllegalStateException> {
            DeepZoomFiles.write(path, 20, 90) { sink -> send(sink, 20, 90, stop = 9) }
        }
        assertEquals(before, content(folder))
        DeepZoomFiles.write(path, 20, 90) { sink -> send(sink, 20, 90) }
        requireLevels(20, 90, AlphaChannel.KEEP)
        assertFalse(tiles.resolve("9").exists())
        assertEquals(setOf("a.dzi", "a_files"), folder.listDirectoryEntries().map { it.name }.toSet())
    }

    @Test
    fun aFolderWithOtherFilesIsNotReplaced() {
        tiles.resolve("3").createDirectories()
        val own = tiles.resolve("3/notes.txt").apply { writeText("mine") }
        val refused = assertThrows<IOException> { DeepZoomFiles.write(path, 9, 9) { sink -> send(sink, 9, 9) } }
        assertTrue("other files than tiles" in refused.message.orEmpty(), refused.message)
        assertEquals("mine", own.readText())
        assertThrows<IOException> { DeepZoomFiles.write(folder.resolve(".dzi"), 9, 9) { sink -> send(sink, 9, 9) } }
        assertThrows<IOException> { DeepZoomFiles.write(folder.resolve("x/a.dzi"), 9, 9) { sink -> send(sink, 9, 9) } }
        assertEquals(listOf(tiles), folder.listDirectoryEntries())
    }

    @Test
    fun anInterruptedPyramidIsCompletedToTheSameBytes() {
        val other = folder.resolve("other").createDirectories().resolve("a.dzi")
        for (alpha in AlphaChannel.entries) {
            DeepZoomFiles.write(other, 600, 1300, alpha) { sink -> send(sink, 600, 1300) }
            val starts = ArrayList<Int>()
            for (stop in listOf(100, 254, 600, 601, 1299, 1300)) {
                resume(600, 1300, alpha, stop, starts)
            }
            assertEquals(listOf(0, 0, 0, 508, 508, 1270), starts)
            assertEquals(content(other.parent), content(folder).filterKeys { !it.startsWith("other") })
            Files.walk(folder).use { all -> all.filter { it.name == "a.dzi" }.forEach(Files::delete) }
        }
    }

    @Test
    fun aFolderThatCannotBeDeletedIsNotReplaced() {
        DeepZoomFiles.write(path, 20, 90) { sink -> send(sink, 20, 90) }
        val before = content(folder)
        for (place in listOf(tiles.resolve("3"), tiles)) {
            assumeTrue(place.toFile().setWritable(false) && !Files.isWritable(place), "all is permitted to this user")
            try {
                val refused = assertThrows<IOException> {
                    DeepZoomFiles.write(path, 9, 9) { _ -> error("must not begin") }
                }
                val reason = "no permission to delete what is in ${place.toRealPath()}"
                assertEquals("cannot write $path: $reason; permit it, or choose another name", refused.message)
            } finally {
                place.toFile().setWritable(true)
            }
        }
        assertEquals(before, content(folder))
    }

    /** The folder may be on another disk, and folders cannot be moved to another disk. */
    @Test
    fun aPartialPyramidIsBesideTheFolderThatALinkNames() {
        val disk = folder.resolve("disk").createDirectories()
        disk.resolve("real").createDirectories()
        tiles.createSymbolicLinkPointingTo(Path.of("disk/real"))
        resume(300, 600, AlphaChannel.DROP, 500, ArrayList())
        assertEquals(setOf("real", "real.partial"), names(disk))
        resume(300, 600, AlphaChannel.DROP, 600, ArrayList())
        assertEquals(setOf("real"), names(disk))
        assertEquals(setOf("a.dzi", "a_files", "disk"), names(folder))
        assertTrue(tiles.isSymbolicLink())
        requireLevels(300, 600, AlphaChannel.DROP)
    }

    private fun names(folder: Path): Set<String> = folder.listDirectoryEntries().map { it.name }.toSet()

    private fun resume(width: Int, height: Int, alpha: AlphaChannel, stop: Int, starts: MutableList<Int>) {
        val resuming = {
            DeepZoomFiles.resume(path, width, height, alpha, mapOf("model" to "m")) { sink, first ->
                starts.add(first)
                send(sink, width, height, first, stop)
            }
        }
        if (stop < height) assertThrows<IllegalStateException> { resuming() } else resuming()
    }

    @Test
    fun anotherPictureIsNotMixedWithAPartialOne() {
        resume(300, 600, AlphaChannel.DROP, 500, ArrayList())
        val before = content(folder)
        for ((facts, width) in listOf(mapOf("model" to "other") to 300, mapOf("model" to "m") to 301)) {
            val refused = assertThrows<IOException> {
                DeepZoomFiles.resume(path, width, 600, AlphaChannel.DROP, facts) { _, _ -> error("must not begin") }
            }
            assertTrue("another picture" in refused.message.orEmpty(), refused.message)
        }
        assertEquals(before, content(folder))
    }

    @Test
    fun aPartialPyramidBelongsToOneWriter() {
        DeepZoomFiles.resume(path, 9, 9, AlphaChannel.DROP, mapOf()) { sink, _ ->
            val refused = assertThrows<IOException> {
                DeepZoomFiles.resume(path, 9, 9, AlphaChannel.DROP, mapOf()) { _, _ -> error("must not begin") }
            }
            assertTrue("another process" in refused.message.orEmpty(), refused.message)
            send(sink, 9, 9)
        }
    }

    @Test
    fun aDamagedTileIsReported() {
        resume(300, 600, AlphaChannel.DROP, 500, ArrayList())
        val tile = folder.resolve("a_files.partial/tiles/10/0_0.png")
        val bytes = Files.readAllBytes(tile)
        bytes.fill(0, fromIndex = bytes.size / 4, toIndex = bytes.size / 2)
        Files.write(tile, bytes)
        val error = assertThrows<IOException> { resume(300, 600, AlphaChannel.DROP, 600, ArrayList()) }
        assertEquals("cannot write $path: the tile $tile is damaged", error.message)
    }

    private fun requireLevels(width: Int, height: Int, alpha: AlphaChannel) {
        val rows = HashMap<Int, ArrayList<IntArray>>()
        val pyramid = BoxPyramid(width, height) { level, _, argb ->
            rows.getOrPut(level) { ArrayList() }.add(argb.copyOf(BoxPyramid.side(width, level)))
        }
        val opaque = if (alpha == AlphaChannel.DROP) 0xFF shl 24 else 0
        send({ _, argb, _, _ -> pyramid.add(IntArray(width) { argb[it] or opaque }) }, width, height)
        for ((level, expected) in rows) {
            requireLevel(tiles.resolve("${pyramid.levels - 1 - level}"), expected)
        }
    }

    /** Checks each tile of a level with the decoder of Java. */
    private fun requireLevel(folder: Path, expected: List<IntArray>) {
        val width = expected[0].size
        var count = 0
        for (row in 0..(expected.size - 1) / 254) {
            for (column in 0..(width - 1) / 254) {
                val top = maxOf(254 * row - 1, 0)
                val left = maxOf(254 * column - 1, 0)
                val right = minOf(254 * column + 255, width)
                val image = ImageIO.read(folder.resolve("${column}_$row.png").toFile())
                assertEquals(right - left, image.width)
                assertEquals(minOf(254 * row + 255, expected.size) - top, image.height)
                for (y in 0 until image.height) {
                    val part = expected[top + y].copyOfRange(left, right)
                    assertArrayEquals(part, image.getRGB(0, y, image.width, 1, null, 0, image.width))
                }
                count++
            }
        }
        assertEquals(count, folder.listDirectoryEntries().size)
    }

    private fun content(folder: Path): Map<String, String> = Files.walk(folder).use { all ->
        all.filter { Files.isRegularFile(it) }.toList().associate {
            "${folder.relativize(it)}" to Files.readAllBytes(it).contentHashCode().toString()
        }
    }

    /** Sends the rows of a picture with smooth and noisy parts. */
    private fun send(sink: RowSink, width: Int, height: Int, first: Int = 0, stop: Int = height) {
        val argb = IntArray(width)
        for (y in first until stop) {
            val random = Random(y.toLong())
            for (x in 0 until width) argb[x] = if (x / 64 + y / 64 and 1 == 0) x * 0x10203 - y else random.nextInt()
            sink.row(y, argb, argb, argb)
        }
        check(stop == height) { "interrupted" }
    }

    @Test
    fun anInterruptLeavesNothing() {
        assertThrows<InterruptedException> {
            DeepZoomFiles.write(path, 300, 300) { sink ->
                Thread.currentThread().interrupt()
                send(sink, 300, 300)
            }
        }
        assertFalse(Thread.interrupted(), "the status is cleared")
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }

    /** The interrupt takes effect when the descriptor is written: the tiles have their place by then. */
    @Test
    fun aPyramidStaysIfItsDescriptorCannotBeReplaced() {
        DeepZoomFiles.write(path, 300, 300) { sink -> send(sink, 300, 300) }
        val before = content(folder)
        val other = folder.resolve("other").createDirectories()
        DeepZoomSink(other, 20, 90).use { send(it, 20, 90) }
        val tiles = content(other)
        Thread.currentThread().interrupt()
        assertThrows<IOException> { DeepZoomFiles.publish(path, other, 20, 90) }
        assertTrue(Thread.interrupted(), "the status is set")
        assertEquals(tiles, content(other))
        assertEquals(before, content(folder).filterKeys { !it.startsWith("other") })
    }

    @Test
    fun otherNamesAreRefused() {
        val photo = folder.resolve("photo.png").apply { writeText("mine") }
        for (other in listOf(photo, folder.resolve("photo"))) {
            val refusals = listOf<() -> Unit>(
                { DeepZoomFiles.write(other, 9, 9) { sink -> send(sink, 9, 9) } },
                { DeepZoomFiles.resume(other, 9, 9, AlphaChannel.KEEP, emptyMap()) { sink, _ -> send(sink, 9, 9) } },
                { DeepZoomFiles.publish(other, folder, 9, 9) },
            )
            for (refusal in refusals) {
                val e = assertThrows<IllegalArgumentException> { refusal() }
                assertEquals("cannot write $other: the name of a Deep Zoom pyramid must end in .dzi", e.message)
            }
        }
        assertEquals("mine", photo.readText())
        assertEquals(listOf(photo), folder.listDirectoryEntries())
    }
}
