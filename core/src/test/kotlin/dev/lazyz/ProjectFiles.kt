package dev.lazyz

import java.nio.file.Files
import java.nio.file.Path

/** The project's own files, found from wherever the tests run. */
object ProjectFiles {
    /** The folder that holds `core` and `docs`. */
    val root: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { Files.isDirectory(it.resolve("core/src/main/kotlin")) }
}
