package dev.lazyz.cli

import java.nio.file.Path
import kotlin.io.path.exists

/** Finds files of the project, whatever the working directory of the tests. */
internal object ProjectFiles {
    /** The folder that contains both builds, `docs` and the modules. */
    val root: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { it.resolve("settings.gradle.kts").exists() && it.resolve("pom.xml").exists() }

    /** Returns the folder of [module]: in the root, or among the integrations. */
    fun folderOf(module: String): Path =
        root.resolve(module).takeIf { it.exists() } ?: root.resolve("integrations/$module")
}
