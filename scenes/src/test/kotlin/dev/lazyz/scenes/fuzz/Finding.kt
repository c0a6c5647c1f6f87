package dev.lazyz.scenes.fuzz

import java.nio.file.Files
import java.nio.file.Path

/** An input that a loader must not answer as it did. */
internal class Finding(
    private val target: FuzzTarget,
    private val settings: FuzzSettings,
    private val number: Long,
    private val input: ByteArray,
    private val outcome: CaseRunner.Outcome,
) {
    /** Writes the input and a text that says what is wrong; returns one line for people. */
    fun write(): String {
        val folder = Files.createDirectories(settings.findings)
        val name = "${target.id}-${settings.seed}-$number"
        val file: Path = folder.resolve("$name.${target.extension}")
        Files.write(file, input)
        val text = "${target.id}, seed ${settings.seed}, input $number, ${input.size} bytes\n" +
            "${outcome.fault}\n${outcome.trace}\n"
        Files.writeString(folder.resolve("$name.txt"), text)
        return "${outcome.kind}: ${outcome.fault}, see $file"
    }
}
