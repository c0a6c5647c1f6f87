package dev.lazyz.scenes.fuzz

import java.nio.file.Path

/** What `-Dlazyz.fuzz.*` says. */
internal class FuzzSettings {
    /** Seconds for all targets together, without loading classes and seeds. */
    val seconds: Double = text("seconds")?.toDouble() ?: USUAL_SECONDS

    /** Two runs with the same one try the same inputs in the same order, as far as time allows. */
    val seed: Long = text("seed")?.toLong() ?: 1

    /** A folder with more files to begin with, or null. */
    val seeds: Path? = text("seeds")?.let { Path.of(it) }

    /** Where findings go. */
    val findings: Path = Path.of(text("findings") ?: "target/fuzz").toAbsolutePath()

    private val only = text("targets")?.split(',')

    /** What is fuzzed. */
    val targets: List<FuzzTarget>
        get() = FuzzTarget.all.filter { only == null || it.id in only }

    private fun text(name: String): String? = System.getProperty("lazyz.fuzz.$name")?.takeIf { it.isNotEmpty() }

    private companion object {
        /** A glance in every build. */
        const val USUAL_SECONDS = 1.5
    }
}
