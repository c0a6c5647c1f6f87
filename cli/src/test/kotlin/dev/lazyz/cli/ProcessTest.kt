package dev.lazyz.cli

import dev.lazyz.Capability
import dev.lazyz.Renderer
import dev.lazyz.strategies.Renderers
import java.io.ByteArrayInputStream
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.util.concurrent.TimeUnit
import javax.imageio.ImageIO
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** A few runs in a separate process: streams, exit codes, working folder. */
class ProcessTest {
    @TempDir
    lateinit var folder: Path

    private val child by lazy { ChildZcli(folder) }

    private fun start(vararg args: String): Process = child.start(args.asList())

    private fun start(
        args: List<String>,
        javaOptions: List<String> = listOf(),
        configure: ProcessBuilder.() -> Unit,
    ): Process = child.start(args, javaOptions, configure)

    private fun Process.code(): Int = child.code(this)

    private val errors get() = child.errors

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun pictureThroughAPipe() {
        val process = start("render", "-", "--format", "obj", "-o", "-", "--size", "40x30", "--stats=json")
        process.outputStream.use { it.write(WEDGE.toByteArray()) }
        val image = ImageIO.read(ByteArrayInputStream(process.inputStream.readAllBytes()))
        assertEquals(0, process.code())
        assertEquals(40, image.width)
        assertEquals("standard input", statIn(errors, "input"))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun theAdviceForANameWithBracesWorks() {
        folder.wedge("{a,b}.obj")
        val picture = folder.resolve("{a,b}.png").apply { writeText("old") }
        assertEquals(2, start("render", "{a,b}.obj", "--size", "8").code())
        assertEquals("zcli: error: {a,b}.png exists; to replace it, use -o '{{a,b}.png'\n", errors)
        val depth = listOf("--depth-out", "{a,b}.pfm")
        assertEquals(0, child.code(child.start(listOf("render", "{a,b}.obj", "-o", "{{a,b}.png") + depth)), errors)
        assertEquals(640, picture.image.width)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun closedPipe() {
        val process = start("render", "teapot", "-o", "-", "--size", "1500x1500", "--quiet")
        process.inputStream.close()
        assertEquals(0, process.code())
        assertEquals("", errors)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aTerminatedProcessLeavesNoFile() {
        val process = startLargePicture()
        process.destroy()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        assertEquals(listOf("errors.txt"), folder.listDirectoryEntries().map { it.name })
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun aTerminatedRunOfTheSuiteLeavesNoFile() {
        val temporary = folder.resolve("temporary").createDirectory()
        val words = listOf("conformance", "--strategy", "lazy", "--quiet")
        val process = start(words, listOf("-Djava.io.tmpdir=$temporary")) {}
        child.await(process, "no journal") {
            temporary.listDirectoryEntries().any { it.resolve("journal").run { exists() && fileSize() > 0 } }
        }
        process.destroy()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        assertEquals(emptyList<Path>(), temporary.listDirectoryEntries())
        assertEquals("", errors)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whatAKilledProcessLeftTheNextOneDeletes() {
        val process = startLargePicture()
        process.destroyForcibly()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        val left = folder.listDirectoryEntries(".large.png.*").single()
        val anothers = folder.resolve(".other.png.tmp").apply { writeText("of another program") }
        for (file in listOf(left, anothers)) {
            Files.setLastModifiedTime(file, FileTime.fromMillis(System.currentTimeMillis() - 120_000))
        }
        assertEquals(0, start("render", "cycle", "--size", "40x30", "-o", "small.png").code(), errors)
        assertTrue(!left.exists(), "$left is still there")
        assertTrue(anothers.exists(), "what is not ours was deleted")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun whatAnotherProcessWritesIsLeftAlone() {
        val process = startLargePicture()
        try {
            val written = folder.listDirectoryEntries(".large.png.*").single()
            Files.setLastModifiedTime(written, FileTime.fromMillis(System.currentTimeMillis() - 120_000))
            assertEquals(0, start("render", "cycle", "--size", "40x30", "-o", "small.png").code(), errors)
            assertTrue(written.exists(), "the file of a living process was deleted")
        } finally {
            process.destroyForcibly()
        }
    }

    /** Starts a rendering that takes minutes, and returns when its temporary file exists. */
    private fun startLargePicture(): Process {
        val words = listOf("render", "plane", "--size", "60000x60000", "--threads", "1", "-o", "large.png")
        val process = start(words, listOf("-Xmx2g")) {}
        child.await(process, "no temporary file") { folder.listDirectoryEntries(".large.png.*").isNotEmpty() }
        return process
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun fullDevice() {
        assumeTrue(Path.of("/dev/full").exists())
        val process = start(listOf("scenes")) { redirectOutput(File("/dev/full")) }
        assertEquals(2, process.code())
        assertTrue("cannot write to standard output" in errors, errors)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun tooLittleMemory() {
        val job = listOf("render", "teapot", "-o", "x.png", "--size", "3000x3000", "--strategy", "zbuffer")
        val process = start(job, listOf("-Xmx64m")) {}
        assertEquals(2, process.code())
        assertTrue("needs 1.6 GiB" in errors && "--aa 1" in errors && "-Xmx" in errors, errors)
        assertTrue(!folder.resolve("x.png").exists())
    }

    /** Threads that help run out of memory, too. Whether one does between two pieces of work is a matter of luck. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun memoryThatIsUsedUpIsReportedOnce() {
        val job = listOf("render", "teapot", "--size", "300", "--style", "product", "--memory", "32m", "-o", "x.png")
        repeat(2) {
            assertEquals(2, child.code(child.start(job, listOf("-Xmx32m"))))
            assertTrue(errors.startsWith("zcli: error: ") && "OutOfMemoryError" !in errors, errors)
        }
    }

    /** Each picture takes 69 MiB, and any two of them are more than the heap. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun picturesThatDoNotFitTogetherAreRenderedOneAfterTheOther() {
        val inputs = listOf("teapot", "city", "cycle", "molecule")
        val options =
            listOf("--size", "600x600", "--strategy", "zbuffer", "--threads", "4", "--quiet", "-o", "{stem}.png")
        val process = start(listOf("render") + inputs + options, listOf("-Xmx112m")) {}
        assertEquals(0, process.code(), errors)
        assertEquals("", errors)
        for (input in inputs) assertTrue(folder.resolve("$input.png").exists(), input)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun aTerminatedBatchLeavesNoPartialFile() {
        val words = listOf("render", "plane", "city", "--turntable", "100", "--size", "2000x2000", "-o", "{stem}.png")
        val process = start(words, listOf("-Xmx2g")) {}
        val files = minOf(2, Runtime.getRuntime().availableProcessors())
        child.await(process, "no temporary file") { folder.listDirectoryEntries(".*.png.*").size >= files }
        process.destroy()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        assertEquals(listOf("errors.txt"), folder.listDirectoryEntries().map { it.name })
    }

    /** A picture of 46 MiB, in a heap of 32 MiB: strategies that promise constant memory can render it. */
    @TestFactory
    fun picturesLargerThanTheHeapAreStreamed(): List<DynamicTest> =
        streaming().map { strategy ->
            dynamicTest(strategy.id) {
                val size = listOf("--size", "400x10000", "--stats=json")
                val args = listOf("render", "cycle", "--strategy", strategy.id, "-o", "${strategy.id}.png") + size
                val process = start(args, listOf("-Xmx32m")) {}
                val stats = process.inputStream.readAllBytes().decodeToString()
                assertEquals(0, process.code(), errors)
                assertTrue(statIn(stats, "peakBytes").toLong() < 16 shl 20, stats)
            }
        }

    /** All of them take long: the first is enough with the effort `rest`, and none by default. */
    private fun streaming(): List<Renderer> {
        val all = Renderers.builtIn.filter { Capability.CONSTANT_MEMORY in it.capabilities }
        return when (System.getProperty("lazyz.effort")) {
            null -> emptyList()
            "rest" -> all.take(1)
            else -> all
        }
    }
}
