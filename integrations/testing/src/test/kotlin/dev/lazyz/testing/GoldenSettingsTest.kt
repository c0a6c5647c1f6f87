package dev.lazyz.testing

import java.nio.file.Path
import kotlin.io.path.createFile
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Files are where both build tools expect them. */
class GoldenSettingsTest {
    @TempDir
    lateinit var project: Path

    private fun settings(vararg properties: Pair<String, String>, environment: Map<String, String> = emptyMap()) =
        GoldenSettings.current(mapOf("user.dir" to "$project", *properties)::get, environment::get)

    private fun GoldenSettings.folders() = "${project.relativize(root)} ${project.relativize(output)}"

    @Test
    fun maven() {
        project.resolve("pom.xml").createFile()
        project.resolve("build.gradle.kts").createFile()
        val settings = settings("user.dir" to "/elsewhere", "basedir" to "$project")
        assertEquals("src/test/resources target/golden-pictures", settings.folders())
        assertEquals("mvn test -Dtest=ATest -Dlazyz.golden.update=true", settings.updateCommand("some.ATest"))
        assertFalse(settings.isUpdate)
    }

    @Test
    fun gradle() {
        project.resolve("pom.xml").createFile()
        val settings = settings("org.gradle.test.worker" to "1", "lazyz.golden.update" to "true")
        assertEquals("src/test/resources build/golden-pictures", settings.folders())
        assertEquals("gradle test --tests some.ATest -Dlazyz.golden.update=true", settings.updateCommand("some.ATest"))
        assertTrue(settings.isUpdate)
    }

    @Test
    fun gradleInAnEditor() {
        project.resolve("build.gradle").createFile()
        assertEquals("src/test/resources build/golden-pictures", settings().folders())
    }

    @Test
    fun configuredFolders() {
        val settings = settings("lazyz.golden.root" to "pictures", "lazyz.golden.output" to "out/diff")
        assertEquals("pictures out/diff", settings.folders())
        assertEquals(Path.of("/pictures"), settings("lazyz.golden.root" to "/pictures").root)
    }

    @Test
    fun workflowsOfGithub() {
        assertNull(settings(environment = mapOf("GITHUB_WORKSPACE" to "/w")).workspace)
        val environment = mapOf("GITHUB_ACTIONS" to "true", "GITHUB_WORKSPACE" to "/w")
        assertEquals(Path.of("/w"), settings(environment = environment).workspace)
    }
}
