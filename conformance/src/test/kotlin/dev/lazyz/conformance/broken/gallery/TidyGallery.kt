package dev.lazyz.conformance.broken.gallery

import dev.lazyz.Frame
import dev.lazyz.conformance.broken.BrokenFailures
import dev.lazyz.conformance.broken.BrokenRenderer
import dev.lazyz.strategies.zbuffer.ZBuffer
import java.util.Collections
import java.util.Locale

/** The gallery's part about side effects. */
internal object TidyGallery {
    val mutants: List<Mutant> = listOf(
        Mutant(::prints, "a line on standard output for each rendering", RuleNames.tidy),
        Mutant(::setsEnglish, "the default locale is English, which it may be already", RuleNames.tidy),
        Mutant(::renamesTheCaller, "another name for the calling thread", RuleNames.tidy),
        Mutant(::addsAHook, "a shutdown hook for each rendering", RuleNames.leaks),
        Mutant(::keepsAHistory, "a list of the sizes of all frames", RuleNames.leaks),
        Mutant(
            BrokenFailures::leavesInterrupts,
            "an interrupt of the executor's thread if the rendering fails",
            RuleNames.notInterrupted,
        ),
    )

    private fun prints() = having("prints") { println("rendering ${it.width} x ${it.height}") }

    private fun setsEnglish() = having("sets-english") { Locale.setDefault(Locale.ENGLISH) }

    private fun renamesTheCaller() = having("renames-the-caller") { Thread.currentThread().name = "renderer" }

    private fun addsAHook() = having("adds-a-hook") { Runtime.getRuntime().addShutdownHook(Thread {}) }

    private fun keepsAHistory(): BrokenRenderer {
        val history = Collections.synchronizedList(ArrayList<String>())
        return having("keeps-a-history") { history += "${it.width} x ${it.height}" }
    }

    private fun having(id: String, block: (Frame) -> Unit) = BrokenRenderer(id) { frame, sink ->
        block(frame)
        ZBuffer().render(frame, sink)
    }
}
