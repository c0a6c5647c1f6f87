package dev.lazyz.conformance.broken.gallery

import dev.lazyz.Frame
import dev.lazyz.conformance.broken.BrokenRenderer
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.nio.file.Files
import java.util.Locale
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
        Mutant(::setsAProperty, "a system property", RuleNames.tidy),
    )

    private fun prints() = having("prints") { println("rendering ${it.width} x ${it.height}") }

    private fun printsErrors() = having("prints-errors") {
        Thread { System.err.println("careful") }.apply { start() }.join()
    }

    private fun leavesAThread() = having("leaves-a-thread") {
        Thread({ CountDownLatch(1).await() }, "left").apply { isDaemon = true }.start()
    }

    /** The thread ends by itself, so that the process of this test can end. */
    private fun keepsTheProcessAlive() = having("keeps-the-process-alive") {
        Thread({ Thread.sleep(3000) }, "kept").apply { isDaemon = false }.start()
    }

    private fun leavesAFile() = having("leaves-a-file") {
        Files.createTempFile("lazyz-gallery", ".tmp").toFile().deleteOnExit()
    }

    private fun setsTheLocale() = having("sets-the-locale") {
        Locale.setDefault(if (Locale.getDefault() == Locale.ROOT) Locale.ENGLISH else Locale.ROOT)
    }

    private fun setsAProperty() = having("sets-a-property") {
        System.setProperty("lazyz.gallery", "${System.nanoTime()}")
    }

    private fun having(id: String, block: (Frame) -> Unit) = BrokenRenderer(id) { frame, sink ->
        block(frame)
        ZBuffer().render(frame, sink)
    }
}
