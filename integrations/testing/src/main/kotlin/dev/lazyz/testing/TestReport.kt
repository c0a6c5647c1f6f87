package dev.lazyz.testing

import dev.lazyz.scenes.html.Html
import dev.lazyz.scenes.html.Html.escaped
import java.io.IOException
import java.io.InterruptedIOException
import java.io.UncheckedIOException
import java.nio.channels.FileChannel
import java.nio.channels.FileLock
import java.nio.channels.OverlappingFileLockException
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption.CREATE
import java.nio.file.StandardOpenOption.WRITE
import java.security.MessageDigest
import java.util.HexFormat
import java.util.concurrent.ConcurrentHashMap
import kotlin.io.path.ExperimentalPathApi
import kotlin.io.path.deleteRecursively
import kotlin.io.path.extension
import kotlin.streams.asSequence

/**
 * The failures of one test class: its folder in the output folder, and its part of the page that shows all of them.
 *
 * A part of the page is kept as a file for each failure, so that several processes can run tests at the same time, and
 * each can write the whole page. A class begins anew in each process, like its file of Surefire; so the page shows the
 * last run of each class. Thread safe; processes wait for each other.
 *
 * @param test full name of the class
 */
internal class TestReport(private val settings: GoldenSettings, private val test: String) {
    private val folder: Path = settings.output.resolve(test)
    private val page: Path = settings.output.resolve("index.html")

    /** What was written for a failure. */
    class Written(val actual: Path, val difference: Path?, val page: Path)

    /** Deletes what earlier runs of the test have left. Does this only when it is called first in a process. */
    fun begin() {
        if (!begun.add(folder) || !Files.exists(folder)) return
        exclusively {
            @OptIn(ExperimentalPathApi::class)
            folder.deleteRecursively()
            writePage()
        }
    }

    /**
     * Writes the pictures of [failure], and adds it to the page. The same picture for the same golden file is there
     * only once.
     */
    fun add(failure: GoldenFailure): Written {
        val name = fileName(failure)
        val actual = folder.resolve("$name.actual.png")
        val difference = failure.difference?.let { folder.resolve("$name.difference.png") }
        val part = FailurePage.part(test, failure).toByteArray()
        exclusively {
            WholeFile.write(actual, failure.actual.png)
            if (difference != null) WholeFile.write(difference, failure.difference)
            WholeFile.write(folder.resolve("$name.part"), part)
            writePage()
        }
        return Written(actual, difference, page)
    }

    /** The name of the golden file, and the beginning of a hash of the picture and of the whole path. */
    private fun fileName(failure: GoldenFailure): String {
        val sha = MessageDigest.getInstance("SHA-256")
        sha.update(failure.golden.toByteArray())
        val hash = HexFormat.of().formatHex(sha.digest(failure.actual.png), 0, 4)
        return failure.golden.substringAfterLast('/').substringAfterLast('\\').removeSuffix(".png") + "-$hash"
    }

    private fun writePage() {
        val parts = Files.walk(settings.output).use { paths ->
            paths.asSequence().filter { it.extension == "part" }.sorted().map { Files.readString(it) }.toList()
        }
        if (parts.isEmpty()) {
            Files.deleteIfExists(page)
        } else {
            WholeFile.write(page, FailurePage.of(parts).toByteArray())
        }
    }

    /** Runs [action] while no other thread or process writes to the output folder. */
    private fun exclusively(action: () -> Unit) = synchronized(begun) {
        try {
            Files.createDirectories(settings.output)
            FileChannel.open(settings.output.resolve(".lock"), CREATE, WRITE).use { channel ->
                lock(channel).use { action() }
            }
        } catch (failure: IOException) {
            throw UncheckedIOException("cannot write to ${settings.output}: ${failure.message}", failure)
        }
    }

    /** Waits for the lock, also if this class is loaded twice in the process, for which Java's locks do not wait. */
    private fun lock(channel: FileChannel): FileLock {
        while (true) {
            try {
                return channel.lock()
            } catch (_: OverlappingFileLockException) {
                pause()
            }
        }
    }

    private fun pause() = try {
        Thread.sleep(PAUSE_MILLIS)
    } catch (interrupt: InterruptedException) {
        Thread.currentThread().interrupt()
        throw InterruptedIOException("interrupted while waiting for another test").apply { initCause(interrupt) }
    }

    private companion object {
        const val PAUSE_MILLIS = 10L

        /** The folders of the classes that have begun in this process. */
        val begun: MutableSet<Path> = ConcurrentHashMap.newKeySet()
    }
}

/** The page that shows failures side by side: HTML with all pictures in it, so that one file can be kept or sent. */
internal object FailurePage {
    private val style = """
        body { font: 15px/1.5 system-ui, sans-serif; margin: 2em; color: #222; background: #fff; }
        article { border-top: 1px solid #ccc; padding: 0 0 1.5em; }
        h2 { margin-bottom: 0; }
        pre { background: #f4f4f4; padding: .6em; white-space: pre-wrap; }
        .side { display: flex; flex-wrap: wrap; gap: 1em; }
        figure { margin: 0; flex: 1 1 16em; }
        img { width: 100%; max-width: 60em; border: 1px solid #ccc; image-rendering: pixelated;
              background: repeating-conic-gradient(#ddd 0 25%, #fff 0 50%) 0 0 / 16px 16px; }
    """.trimIndent()

    /** Returns the page of these [parts]. */
    fun of(parts: List<String>): String = """
        |<!DOCTYPE html>
        |<html lang="en">
        |<head>
        |<meta charset="utf-8">
        |<title>Golden pictures: ${parts.size} different</title>
        |<style>
        |$style
        |</style>
        |</head>
        |<body>
        |<h1>Golden pictures: ${parts.size} different</h1>
        |<p>From the last run of each test class. In the difference, pixels that differ are yellow to red, and pixels that
        |only one picture has are blue. If the actual picture is right, run the test with
        |<code>-D${GoldenSettings.UPDATE}=true</code>.</p>
        |
    """.trimMargin() + parts.joinToString("") + "</body>\n</html>\n"

    /** Returns the part of the page that shows [failure] of the class [test]. */
    fun part(test: String, failure: GoldenFailure): String = buildString {
        appendLine("<article>")
        appendLine("<h2>${escaped(failure.golden)}</h2>")
        appendLine("<p>${escaped(test)}</p>")
        appendLine("<pre>${escaped(failure.problem)}</pre>")
        appendLine("<div class=\"side\">")
        append(figure("expected", failure.expected))
        append(figure("actual", failure.actual.png))
        append(figure("difference", failure.difference))
        appendLine("</div>")
        appendLine("</article>")
    }

    private fun figure(caption: String, png: ByteArray?): String {
        if (png == null) return "<figure><figcaption>$caption: none</figcaption></figure>\n"
        val image = "<img alt=\"$caption\" src=\"${Html.pngUri(png)}\">"
        return "<figure><figcaption>$caption</figcaption>$image</figure>\n"
    }
}
