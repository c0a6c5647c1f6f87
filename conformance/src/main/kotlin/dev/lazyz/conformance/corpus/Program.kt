package dev.lazyz.conformance.corpus

import dev.lazyz.Image
import dev.lazyz.conformance.report.ShellWords
import dev.lazyz.conformance.results.reason
import dev.lazyz.conformance.run.Deadline
import dev.lazyz.conformance.run.Lateness
import dev.lazyz.conformance.run.StallTimer
import dev.lazyz.conformance.run.ThreadTimes
import java.io.ByteArrayInputStream
import java.io.File
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.concurrent.TimeUnit
import javax.imageio.IIOException
import javax.imageio.ImageIO
import javax.imageio.stream.MemoryCacheImageInputStream
import kotlin.concurrent.thread
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively

/** What a program made of a scene. */
internal sealed interface Drawing {
    /** A picture. Depth and primitive are the expected ones if the program does not write them. */
    class Picture(val image: Image) : Drawing

    /** The program says that it cannot draw the scene. */
    object NotSupported : Drawing

    /** It ended without a picture of the right size. */
    class Failed(val isCrash: Boolean, val message: String) : Drawing

    /** It did not end in time. */
    class Late(val lateness: Lateness, val message: String) : Drawing
}

/**
 * A program that draws scenes of the corpus, in a process for each. It may do anything: the process and those that it
 * starts are ended when its time is over, when it has ended itself, or when it has written too much. Thread safe.
 *
 * @param command for the shell: `{scene}` is the file to read, `{picture}`, `{depth}` and `{primitive}` those to write
 * @param deadline how much processor time it may use, together with the processes that it starts
 */
internal class Program(private val command: String, private val deadline: Duration) {
    private val files = listOf("picture", "depth", "primitive").filter { "{$it}" in command }

    /** Lets the program draw [scene], which is [json] in its own form. */
    @OptIn(ExperimentalPathApi::class)
    fun draw(scene: CorpusScene, json: String): Drawing {
        val folder = Files.createTempDirectory("lazyz-program")
        try {
            Files.writeString(folder.resolve("scene"), json)
            val ended = run(folder)
            return ended ?: Drawing.Picture(picture(folder, scene.expected))
        } catch (bad: IOException) {
            return Drawing.Failed(isCrash = false, bad.message ?: bad.javaClass.simpleName)
        } finally {
            folder.deleteRecursively()
        }
    }

    /** Runs the command. Returns null if it says that it has drawn the scene. */
    private fun run(folder: Path): Drawing? {
        val words = (files + "scene").fold(command) { text, name ->
            text.replace("{$name}", ShellWords.quoted("${folder.resolve(name)}"))
        }
        val isWindows = File.separatorChar == '\\'
        val shell = if (isWindows) listOf("cmd", "/c", words) else listOf("/bin/sh", "-c", "$LIMIT; $words")
        val process = ProcessBuilder(shell).redirectErrorStream(true).start()
        val family = Family(process)
        val printed = StringBuilder()
        val reader = thread(isDaemon = true, name = "lazyz-program") { keep(process, printed) }
        val late = try {
            process.outputStream.close()
            awaitEnd(process, family, folder)
        } finally {
            family.end()
            process.waitFor()
            reader.join(LAST_OUTPUT)
        }
        val text = synchronized(printed) { "$printed" }.trim().let { if (it.isEmpty()) "" else "; it printed\n$it" }
        return when {
            late is Drawing.Late -> Drawing.Late(late.lateness, late.message + text)
            late is Drawing.Failed -> Drawing.Failed(late.isCrash, late.message + text)
            process.exitValue() == NOT_SUPPORTED -> Drawing.NotSupported

            process.exitValue() != 0 ->
                Drawing.Failed(isCrash = true, "ended with exit code ${process.exitValue()}$text")

            else -> null
        }
    }

    /** Waits for the end. Returns why the process is not awaited further, or null if it has ended. */
    private fun awaitEnd(process: Process, family: Family, folder: Path): Drawing? {
        val meter = Deadline(deadline, { family.times() })
        var moment = 1L
        while (!process.waitFor(moment, TimeUnit.MILLISECONDS)) {
            // Look often in the beginning, so that a process that leaves its family is seen before
            moment = minOf(moment + 1, StallTimer.POLL.toMillis())
            val written = Files.walk(folder).use { paths -> paths.mapToLong { sizeOf(it) }.sum() }
            if (written > MOST_BYTES) return Drawing.Failed(isCrash = false, "wrote more than $MOST_BYTES bytes")
            meter.lateness()?.let { return Drawing.Late(it, meter.words(it)) }
        }
        return null
    }

    private fun sizeOf(path: Path): Long = try {
        Files.size(path)
    } catch (_: IOException) {
        // It was deleted meanwhile
        0L
    }

    /** Keeps the first part of the output, and reads and discards the rest, so that the process does not block. */
    private fun keep(process: Process, to: StringBuilder) {
        val buffer = CharArray(MOST_PRINTED)
        try {
            val reader = process.inputStream.reader()
            while (true) {
                val count = reader.read(buffer)
                if (count < 0) return
                synchronized(to) { to.appendRange(buffer, 0, minOf(count, MOST_PRINTED - to.length)) }
            }
        } catch (_: IOException) {
            // The stream was closed
        }
    }

    private fun picture(folder: Path, expected: Image): Image {
        val shape = listOf(expected.height, expected.width)
        fun <T> read(name: String, use: (ByteArray) -> T): T = try {
            val path = folder.resolve(name)
            if (sizeOf(path) > MOST_BYTES) throw IOException("is larger than $MOST_BYTES bytes")
            use(Files.readAllBytes(path))
        } catch (bad: IOException) {
            throw IOException("the file of the $name: ${reason(bad)}", bad)
        }
        fun numbers(name: String, otherwise: IntArray) =
            if (name in files) read(name) { Npy.read(it, shape) } else otherwise
        val argb = read("picture") { if (Npy.isNpy(it)) packed(Npy.read(it, shape + 4)) else decoded(it, shape) }
        return Image(
            expected.region, argb, numbers("depth", expected.depth), numbers("primitive", expected.primitive),
            expected.counters,
        )
    }

    private fun packed(parts: IntArray): IntArray = IntArray(parts.size / 4) {
        val (red, green, blue, alpha) = parts.copyOfRange(4 * it, 4 * it + 4)
        alpha shl 24 or (red shl 16) or (green shl 8) or blue
    }

    private fun decoded(bytes: ByteArray, shape: List<Int>): IntArray {
        val stream = MemoryCacheImageInputStream(ByteArrayInputStream(bytes))
        val reader = ImageIO.getImageReadersByFormatName("png").next()
        try {
            reader.input = stream
            val found = listOf(reader.getHeight(0), reader.getWidth(0))
            if (found != shape) throw IOException("has ${found[1]} x ${found[0]} pixels, not ${shape[1]} x ${shape[0]}")
            return reader.read(0).getRGB(0, 0, shape[1], shape[0], null, 0, shape[1])
        } catch (bad: IIOException) {
            throw IOException("is not a picture: ${bad.message}", bad)
        } catch (bad: RuntimeException) {
            throw IOException("is not a picture: $bad", bad)
        } finally {
            reader.dispose()
        }
    }

    private companion object {
        /** Exit code of a program that cannot draw a scene. */
        const val NOT_SUPPORTED = 3

        /** Most bytes of all files in the folder, and of one file elsewhere: some dozen megabytes, in blocks. */
        const val MOST_BYTES = 32_000_000L
        const val LIMIT = "ulimit -f 65536"
        const val MOST_PRINTED = 2000

        /** Milliseconds for the output of a process that has ended. Others may keep the output open. */
        const val LAST_OUTPUT = 2000L
    }
}

/** A process, and those that it has started. Used by one thread. */
private class Family(process: Process) {
    private val first = process.toHandle()
    private val all = LinkedHashMap<ProcessHandle, Duration>()

    /** Returns the processor time of all together, also of those that have ended, as that of one thread. */
    fun times(): ThreadTimes {
        look()
        for (member in all.keys) member.info().totalCpuDuration().ifPresent { all[member] = it }
        val sum = mapOf(0L to all.values.sumOf { it.toNanos() })
        return ThreadTimes(sum, sum, first.info().totalCpuDuration().isPresent || !first.isAlive)
    }

    private fun look() {
        for (member in listOf(first) + first.descendants().toList()) all.putIfAbsent(member, Duration.ZERO)
        for (member in all.keys.toList()) member.descendants().forEach { all.putIfAbsent(it, Duration.ZERO) }
    }

    /** Ends all, until no new ones are found: a process may start others meanwhile. */
    fun end() {
        do {
            val before = all.size
            look()
            for (member in all.keys) member.destroyForcibly()
        } while (all.size > before)
    }
}
