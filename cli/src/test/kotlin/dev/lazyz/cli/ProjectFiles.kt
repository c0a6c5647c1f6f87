package dev.lazyz.cli

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.extension
import kotlin.io.path.name
import kotlin.io.path.relativeTo
import kotlin.io.path.walk

/** Finds files of the project, whatever the working directory of the tests. */
internal object ProjectFiles {
    /** The folder that contains both builds, `docs` and the modules. */
    val root: Path = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { it.resolve("settings.gradle.kts").exists() && it.resolve("pom.xml").exists() }

    /** Returns the folder of [module]: in the root, or among the integrations. */
    fun folderOf(module: String): Path =
        root.resolve(module).takeIf { it.exists() } ?: root.resolve("integrations/$module")

    /** Returns the files with one of the [extensions], in their order, but for those that a build makes. */
    fun written(vararg extensions: String): List<Path> = root.walk()
        .filter { it.extension in extensions && it.relativeTo(root).none { part -> part.name in BUILT } }
        .sorted()
        .toList()

    private val BUILT = setOf("target", "build", "node_modules")
}
