package dev.lazyz.conformance.broken.gallery

import dev.lazyz.Frame
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.BrokenRenderer
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.nio.file.Files
import java.util.Collections
import java.util.Locale
import java.util.TimeZone
import java.util.concurrent.ConcurrentHashMap
import java.util.concurrent.CountDownLatch

/** The gallery's part about side effects. */
internal object TidyGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(::prints, "a line on standard output for each rendering", RuleNames.tidy),
        Mutant(::printsErrors, "a line on standard error, from a thread of its own", RuleNames.tidy),
        Mutant(::leavesAThread, "a daemon thread that waits forever, for each rendering", RuleNames.tidy),
        Mutant(::keepsTheProcessAlive, "a pool whose threads are no daemons", RuleNames.tidy),
        Mutant(::leavesAFile, "a temporary file for each rendering", RuleNames.tidy),
        Mutant(::setsTheLocale, "another default locale", RuleNames.tidy),
        Mutant(::setsEnglish, "the default locale is English, which it may be already", RuleNames.tidy),
        Mutant(::setsTheTimeZone, "the default time zone is UTC, which it may be already", RuleNames.tidy),
        Mutant(::setsAHandler, "a handler of uncaught exceptions, when the renderer is made", RuleNames.tidy),
        Mutant(::setsAProperty, "a system property", RuleNames.tidy),
        Mutant(::renamesTheCaller, "another name for the calling thread", RuleNames.tidy),
        Mutant(::hurries, "a higher priority for the calling thread", RuleNames.tidy),
        Mutant(::dropsTheClassLoader, "no context class loader for the calling thread", RuleNames.tidy),
        Mutant(::spillsWideFrames, "a temporary file for each rendering of more than 1000 columns", RuleNames.tidy),
        Mutant(::addsAHook, "a shutdown hook for each rendering", RuleNames.leaks),
        Mutant(::keepsAHistory, "a list of the sizes of all frames", RuleNames.leaks),
        Mutant(::poolsByWidth, "a row of numbers for each width of a frame", RuleNames.leaks),
        Mutant(
            BrokenFailures::renamesAfterFailures,
            "another name for the calling thread if the rendering fails",
            RuleNames.tidy,
        ),
        Mutant(
            BrokenFailures::leavesInterrupts,
            "an interrupt of the executor's thread if the rendering fails",
            RuleNames.notInterrupted,
        ),
        Mutant(BrokenFailures::threadsAfterFailures, "a thread for each rendering that fails", RuleNames.tidy),
        Mutant(BrokenFailures::keepsFailures, "some bytes for each rendering that fails", RuleNames.leaks),
        Mutant(BrokenFailures::keepsConfigured, "a renderer for each set of options", RuleNames.leaks),
    )

    private fun poolsByWidth(): BrokenRenderer {
        val rows = ConcurrentHashMap<Int, IntArray>()
        return having("pools-by-width") { frame -> rows.computeIfAbsent(frame.width) { IntArray(it) } }
    }

    private fun prints() = having("prints") { println("rendering ${it.width} x ${it.height}") }

    private fun printsErrors() = having("prints-errors") {
        Thread { System.err.println("careful") }.apply { start() }.join()
    }

    private fun leavesAThread() = having("leaves-a-thread") {
        Thread({ CountDownLatch(1).await() }, "left").apply { isDaemon = true }.start()
    }

    /** The thread ends by itself, so that the process of this test can end. */
    private fun keepsTheProcessAlive() = having("keeps-the-process-alive") {
        Thread({ Thread.sleep(10_000) }, "kept").start()
    }

    private fun leavesAFile() = having("leaves-a-file") {
        Files.createTempFile("lazyz-gallery", ".tmp").toFile().deleteOnExit()
    }

    private fun setsTheLocale() = having("sets-the-locale") {
        Locale.setDefault(if (Locale.getDefault() == Locale.ROOT) Locale.ENGLISH else Locale.ROOT)
    }

    private fun setsEnglish() = having("sets-english") { Locale.setDefault(Locale.ENGLISH) }

    private fun setsTheTimeZone() = having("sets-the-time-zone") {
        TimeZone.setDefault(TimeZone.getTimeZone("UTC"))
    }

    private fun setsAHandler(): BrokenRenderer {
        Thread.setDefaultUncaughtExceptionHandler { _, _ -> }
        return having("sets-a-handler") {}
    }

    private fun renamesTheCaller() = having("renames-the-caller") { Thread.currentThread().name = "renderer" }

    private fun hurries() = having("hurries") { Thread.currentThread().priority = Thread.MAX_PRIORITY }

    private fun dropsTheClassLoader() = having("drops-the-class-loader") {
        Thread.currentThread().contextClassLoader = null
    }

    private fun spillsWideFrames() = having("spills-wide-frames") {
        if (it.width > 1000) Files.createTempFile("lazyz-gallery", ".tmp").toFile().deleteOnExit()
    }

    private fun addsAHook() = having("adds-a-hook") { Runtime.getRuntime().addShutdownHook(Thread {}) }

    private fun keepsAHistory(): BrokenRenderer {
        val history = Collections.synchronizedList(ArrayList<String>())
        return having("keeps-a-history") { history += "${it.width} x ${it.height}" }
    }

    private fun setsAProperty() = having("sets-a-property") {
        System.setProperty("lazyz.gallery", "${System.nanoTime()}")
    }

    private fun having(id: String, block: (Frame) -> Unit) = BrokenRenderer(id) { frame, sink ->
        block(frame)
        ZBuffer().render(frame, sink)
    }
}
