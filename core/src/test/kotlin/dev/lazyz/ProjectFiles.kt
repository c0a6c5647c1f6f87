package dev.lazyz

import java.nio.file.Files
import java.nio.file.Path

/** Finds files of the project, whatever the working directory of the tests. */
object ProjectFiles {
    /** The folder that contains `core` and `docs`. */
    val root: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { Files.isDirectory(it.resolve("core/src/main/kotlin")) }
}
