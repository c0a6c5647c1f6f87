package dev.lazyz.shared

import java.io.File
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.jetbrains.kotlin.abi.tools.AbiFilters
import org.jetbrains.kotlin.abi.tools.AbiTools
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/**
 * The public API of a library is what `api/lazyz-MODULE.api` lists: the signatures that compiled programs depend on. A
 * change of the API shows in the diff of this file; `-Dlazyz.update=true` writes it.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PublicApiTest {
    private val module = Path.of("").toAbsolutePath()

    @Test
    fun theApiIsTheListedOne() {
        val listing = module.resolve("api/lazyz-${module.fileName}.api")
        assumeTrue(listing.parent.exists(), "not a library")
        val actual = buildString {
            AbiTools.getInstance(javaClass.classLoader).printJvmDump(this, classes(), AbiFilters.EMPTY)
        }
        assertTrue("class dev/lazyz/" in actual) { "no classes of $module on the class path" }
        if (System.getProperty("lazyz.update") == "true") listing.writeText(actual)
        val listed = if (listing.exists()) listing.readText() else ""
        assertTrue(listed == actual) {
            "the public API has changed; if that is meant, run this test with -Dlazyz.update=true, and say so in " +
                "CHANGELOG.md:\n${difference(listed.lines(), actual.lines())}"
        }
    }

    /** The classes of this module, without its tests. */
    private fun classes(): List<File> = ClassPath.entries.filter { it.isDirectory && it.toPath().startsWith(module) }
        .filterNot { "test" in it.name }.flatMap { folder -> folder.walk().filter { it.extension == "class" } }

    private fun difference(listed: List<String>, now: List<String>): String =
        ((listed - now.toSet()).map { "- $it" } + (now - listed.toSet()).map { "+ $it" }).joinToString("\n")
}
