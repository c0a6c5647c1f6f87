package dev.lazyz.cli

import java.io.File
import java.nio.ByteBuffer
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import java.nio.file.attribute.FileTime
import java.util.concurrent.TimeUnit
import java.util.jar.Attributes
import java.util.jar.JarOutputStream
import java.util.jar.Manifest
import java.util.zip.ZipEntry
import javax.imageio.ImageIO
import kotlin.io.path.deleteExisting
import kotlin.io.path.exists
import kotlin.io.path.fileSize
import kotlin.io.path.inputStream
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.isDirectory
import kotlin.io.path.isRegularFile
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.outputStream
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.BeforeAll
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** The script `zcli`, in a folder with a jar like the one of the build. */
class LauncherTest {
    @TempDir
    lateinit var folder: Path

    private val cache get() = folder.resolve("cache")
    private val errors get() = messages(folder)
    private val archives get() = cache.listDirectoryEntries()

    private fun zcli(
        vararg args: String,
        environment: Map<String, String> = mapOf(),
        script: Path = home.resolve("zcli"),
    ): Process {
        val process = ProcessBuilder(listOf("/bin/sh", "$script") + args).directory(folder.toFile())
            .redirectError(folder.resolve("errors.txt").toFile())
            .redirectOutput(folder.resolve("output").toFile())
            .apply {
                environment()["JAVA_HOME"] = System.getProperty("java.home")
                environment()["ZCLI_CACHE"] = "$cache"
                environment() += environment
            }
            .start()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        return process
    }

    private fun render(environment: Map<String, String> = mapOf(), script: Path = home.resolve("zcli")) {
        val process =
            zcli("render", "cycle", "--size", "40x30", "--quiet", "-o", "-", environment = environment, script = script)
        assertEquals(0, process.exitValue(), errors)
        assertEquals("", errors)
        assertEquals(40, ImageIO.read(folder.resolve("output").toFile()).width)
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun firstStartMakesTheArchiveAndTheSecondUsesIt() {
        Files.createDirectory(cache)
        val half = cache.resolve(".123.jsa").apply { writeText("half") }
        Files.setLastModifiedTime(half, FileTime.fromMillis(System.currentTimeMillis() - 3L * 24 * 60 * 60 * 1000))
        val another = cache.resolve(".124.jsa").apply { writeText("another, of now") }
        render()
        assertEquals(false to true, half.exists() to another.exists(), "only what was left three days ago is deleted")
        another.deleteExisting()
        val archive = archives.single()
        assertTrue(archive.fileSize() > 1 shl 20, "size of the archive")

        val log = folder.resolve("classes.txt")
        val before = Files.getLastModifiedTime(archive)
        render(mapOf("ZCLI_JAVA_OPTIONS" to "-Xlog:class+load:file=$log"))
        val loaded = "dev.lazyz.cli.render.RenderJob source: shared objects file"
        assertTrue(loaded in log.readText(), "loaded from the archive")
        assertEquals(before, Files.getLastModifiedTime(archives.single()))

        // Such as a container image that is used elsewhere
        render(mapOf("TZ" to "XXX-9", "LC_ALL" to "C.UTF-8"))
        assertEquals(before, Files.getLastModifiedTime(archives.single()), "time zones do not matter")

        // A truncated one is made again
        archive.toFile().setWritable(true)
        FileChannel.open(archive, StandardOpenOption.WRITE).use { it.truncate(archive.fileSize() / 2) }
        render()
        assertEquals(archives.single().fileName.toString().substringAfter('-'), "${archives.single().fileSize()}.jsa")
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun memoryIsTheHeapOfJava() {
        val java = folder.resolve("java/bin/java")
        Files.createDirectories(java.parent)
        java.writeText("#!/bin/sh\necho \"$@\"\n")
        java.toFile().setExecutable(true)
        for ((amount, heap) in mapOf(
            "64m" to "-Xmx65536k", "1GiB" to "-Xmx1048576k", "16384K" to "-Xmx16384k", "33554432" to "-Xmx32768k",
            "1m" to null, "much" to null, "010m" to null, "99999999999999999m" to null,
        )) {
            for (words in listOf(listOf("--memory", amount), listOf("--memory=$amount"))) {
                val environment = mapOf("JAVA_HOME" to "${folder.resolve("java")}", "ZCLI_CACHE" to "")
                zcli("render", "teapot", *words.toTypedArray(), environment = environment)
                val options = folder.resolve("output").readText().substringBefore(" -jar").split(' ')
                assertEquals(heap, options.firstOrNull { it.startsWith("-Xmx") }, amount)
            }
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun damagedArchiveIsMadeAgainAfterItsFirstUse() {
        render()
        val archive = archives.single()
        archive.toFile().setWritable(true)
        val bytes = Files.readAllBytes(archive)
        bytes.fill(0, fromIndex = bytes.size / 4, toIndex = bytes.size / 2)
        Files.write(archive, bytes)
        Files.setLastModifiedTime(archive, FileTime.fromMillis(System.currentTimeMillis() - 10_000))

        // Java crashes
        assertNotEquals(0, zcli("render", "cycle", "--size", "40x30", "-o", "a.png").exitValue())
        render()
        render()
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun everyCommandOfTheTrainingRunSucceeds() {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val process = ProcessBuilder(java, "-cp", "${home.resolve("zcli.jar")}", "dev.lazyz.cli.TrainingRunKt")
            .redirectErrorStream(true).start()
        assertEquals("", process.inputStream.readAllBytes().decodeToString())
        assertEquals(0, process.waitFor())
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun exitCodeAndWordsPassThrough() {
        assertEquals(2, zcli("render", "no such  model", environment = OFF).exitValue())
        assertTrue("'no such  model'" in errors, errors)
        assertTrue(!cache.exists(), "no cache was wanted")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun cacheThatCannotBe() {
        folder.resolve("file").writeText("")
        render(mapOf("ZCLI_CACHE" to "${folder.resolve("file/cache")}"))
        render(mapOf("ZCLI_CACHE" to "$cache:elsewhere"))
        assertTrue(!folder.resolve("cache:elsewhere").exists(), "no archive where Java would not find it")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun throughALink() {
        val link = Files.createSymbolicLink(folder.resolve("link"), home.resolve("zcli"))
        render(OFF, link)
        render(OFF, Files.createSymbolicLink(folder.resolve("second"), Path.of("link")))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun collectorOfOnesOwn() = render(OFF + ("ZCLI_JAVA_OPTIONS" to "-XX:+UseParallelGC -Xmx64m"))

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun vectorApiOnRequest() {
        val jar = "${home.resolve("zcli.jar")}"
        val offered = output("--add-modules", "jdk.incubator.vector", "-jar", jar)
        assumeTrue(statIn(offered, "kernel") == "vector", "this machine has no vectors that are wide enough")
        assertEquals("scalar", kernel("-jar", jar))
        assertEquals("vector", kernel("-Dzcli.kernel=vector", "-jar", jar))
        // Without the export, the module is not loaded, and nothing is printed
        assertEquals("scalar", kernel("-Dzcli.kernel=vector", "-cp", jar, "dev.lazyz.cli.MainKt"))

        val script = zcli(*KERNEL_JOB, environment = OFF + ("ZCLI_JAVA_OPTIONS" to "-Dzcli.kernel=vector"))
        assertEquals(0, script.exitValue(), errors)
        assertEquals("vector", statIn(folder.resolve("output").readText(), "kernel"))
        assertEquals("", errors)
    }

    /** Returns the kernel that `--stats` prints in a process of plain Java, which must not print a warning. */
    private fun kernel(vararg start: String): String {
        val text = output(*start)
        assertTrue(text.startsWith("{"), text)
        return statIn(text, "kernel")
    }

    /** Returns all that a process of plain Java prints. */
    private fun output(vararg start: String): String {
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val process = ProcessBuilder(listOf(java) + start + KERNEL_JOB).directory(folder.toFile())
            .redirectErrorStream(true).start()
        val text = process.inputStream.readAllBytes().decodeToString()
        assertEquals(0, process.waitFor(), text)
        return text
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun shortRunsDoWithoutTheSecondCompiler() {
        val java = folder.resolve("jdk/bin/java")
        Files.createDirectories(java.parent)
        java.writeText("#!/bin/sh\necho \"$@\"\n")
        assertTrue(java.toFile().setExecutable(true))
        folder.resolve("small.obj").writeText("")
        FileChannel.open(folder.resolve("large.obj"), StandardOpenOption.WRITE, StandardOpenOption.CREATE).use {
            it.write(ByteBuffer.allocate(1), 20L shl 20)
        }
        Files.createDirectory(folder.resolve("models"))

        fun isShort(vararg words: String, options: String = ""): Boolean {
            val environment = OFF + mapOf("JAVA_HOME" to "${folder.resolve("jdk")}", "ZCLI_JAVA_OPTIONS" to options)
            assertEquals(0, zcli(*words, environment = environment).exitValue())
            assertEquals("", errors)
            val line = folder.resolve("output").readText().removeSuffix("\n")
            assertTrue(line.endsWith(words.joinToString(" ")), line)
            return "-XX:TieredStopAtLevel=1" in line
        }
        val short = listOf(
            "render teapot", "render small.obj -o a.png", "render teapot --size 512", "render teapot --size=1024x768",
            "render - --format obj", "render small.obj --aa-filter box", "render -o",
        )
        val long = listOf(
            "", "--help", "compare teapot", "render teapot --size 1024x1024", "render teapot --size=4096",
            "render teapot --size 09x08", "render teapot --size 5x", "render teapot --size 99999999999999999999",
            "render teapot --size ", "render large.obj", "render models", "render teapot --turntable=36",
            "render teapot --aa 8", "render teapot --style product", "render teapot --strategy warnock",
        )
        for (words in short) assertTrue(isShort(*words.split(' ').toTypedArray()), words)
        for (words in long) assertFalse(isShort(*words.split(' ').toTypedArray()), words)

        // Reading two megabytes is worth compiling loops that run once
        folder.resolve("middle.obj").writeText("#".repeat(2 shl 20))
        for ((file, isEarly) in mapOf("middle.obj" to true, "small.obj" to false)) {
            assertTrue(isShort("render", file))
            assertEquals(isEarly, "-XX:Tier3BackEdgeThreshold=" in folder.resolve("output").readText())
        }
        assertFalse(isShort("render", "teapot", options = "-Dzcli.kernel=vector"))
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun noJava() {
        assertEquals(2, zcli("scenes", environment = mapOf("JAVA_HOME" to "/nowhere")).exitValue())
        assertTrue(errors.startsWith("zcli: error: no Java at '/nowhere/bin/java'"), errors)
    }

    companion object {
        private val OFF = mapOf("ZCLI_CACHE" to "")
        private val KERNEL_JOB =
            arrayOf("render", "cycle", "--size", "40x30", "--quiet", "--stats=json", "-o", "kernel.png")

        @TempDir
        lateinit var home: Path

        /**
         * The script and a jar of the classes under test. It has to be a jar, because Java does not archive classes of
         * folders.
         */
        @BeforeAll
        @JvmStatic
        fun install() {
            assumeTrue(Path.of("/bin/sh").exists())
            Files.copy(Path.of("src/main/sh/zcli"), home.resolve("zcli"))
            val (folders, jars) = System.getProperty("java.class.path").split(File.pathSeparator)
                .map { Path.of(it).toAbsolutePath() }.filter { it.exists() }.partition { it.isDirectory() }
            val manifest = Manifest()
            manifest.mainAttributes[Attributes.Name.MANIFEST_VERSION] = "1.0"
            manifest.mainAttributes[Attributes.Name.MAIN_CLASS] = "dev.lazyz.cli.MainKt"
            manifest.mainAttributes[Attributes.Name("Add-Exports")] = VectorModule.EXPORT
            manifest.mainAttributes[Attributes.Name.CLASS_PATH] = jars.joinToString(" ") { it.toUri().toString() }
            JarOutputStream(home.resolve("zcli.jar").outputStream(), manifest).use { jar ->
                for (folder in folders) pack(folder, jar)
            }
        }

        private fun pack(folder: Path, jar: JarOutputStream) {
            val files = Files.walk(folder).use { all -> all.filter { it.isRegularFile() }.toList() }
            val names = files.associateBy { folder.relativize(it).invariantSeparatorsPathString }
            for ((name, file) in names.filterKeys { it.startsWith("dev/") }) {
                jar.putNextEntry(ZipEntry(name))
                file.inputStream().use { it.copyTo(jar) }
            }
        }
    }
}
