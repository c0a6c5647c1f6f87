package dev.lazyz.testing

import java.nio.file.Files
import java.nio.file.Path

/**
 * Where files are, and what is to be done with them.
 *
 * @property root the folder to which paths of golden files are relative
 * @property output the folder for what a failure writes
 * @property isUpdate whether golden files are written
 * @property isGradle whether Gradle runs the tests, rather than Maven
 * @property workspace the root of the repository, if the tests run in a GitHub workflow
 * @property print prints a line to standard output
 */
internal class GoldenSettings(
    val root: Path,
    val output: Path,
    val isUpdate: Boolean = false,
    val isGradle: Boolean = false,
    val workspace: Path? = null,
    val print: (String) -> Unit = ::println,
) {
    /** The command that writes the golden files of [test], which is the name of a class. */
    fun updateCommand(test: String): String = if (isGradle) {
        "gradle test --tests $test -D$UPDATE=true"
    } else {
        "mvn test -Dtest=${test.substringAfterLast('.')} -D$UPDATE=true"
    }

    companion object {
        const val UPDATE = "lazyz.golden.update"
        const val ROOT = "lazyz.golden.root"
        const val OUTPUT = "lazyz.golden.output"

        /**
         * Returns the settings of this process. The project is the folder that Surefire calls `basedir`, or else the
         * working folder, as in Gradle. Its build folder is Gradle's if Gradle runs the tests, or if there is no POM.
         */
        fun current(
            properties: (String) -> String? = System::getProperty,
            environment: (String) -> String? = System::getenv,
        ): GoldenSettings {
            val project = Path.of(properties("basedir") ?: properties("user.dir") ?: "").toAbsolutePath()
            val isGradle = properties("org.gradle.test.worker") != null || isGradleOnly(project)
            val build = if (isGradle) "build" else "target"
            return GoldenSettings(
                root = project.resolve(properties(ROOT) ?: "src/test/resources").normalize(),
                output = project.resolve(properties(OUTPUT) ?: "$build/golden-pictures").normalize(),
                isUpdate = properties(UPDATE) == "true",
                isGradle = isGradle,
                workspace = if (environment("GITHUB_ACTIONS") == "true") {
                    Path.of(environment("GITHUB_WORKSPACE") ?: "").toAbsolutePath()
                } else {
                    null
                },
            )
        }

        private fun isGradleOnly(project: Path): Boolean = !Files.exists(project.resolve("pom.xml")) &&
            listOf("build.gradle", "build.gradle.kts").any { Files.exists(project.resolve(it)) }
    }
}
