package dev.lazyz.cli

import kotlin.io.path.readLines
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/**
 * `MODULE/api/packages.md` describes each package that has public types. The pages of the API documentation are made of
 * it.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PackageTextsTest {
    private fun publicPackages(module: String): List<String> {
        val type = Regex("""^public .*(?:class|interface) ([\w/]+)/\w[\w$]* .*""")
        val listing = ProjectFiles.folderOf(module).resolve("api/lazyz-$module.api").readLines()
        return listing.mapNotNull { type.matchEntire(it)?.groupValues?.get(1)?.replace('/', '.') }.distinct().sorted()
    }

    /** The texts by their headings, such as `Package dev.lazyz`, with single spaces between words. */
    private fun texts(module: String): Map<String, String> =
        ProjectFiles.folderOf(module).resolve("api/packages.md").readText().split(Regex("(?m)^# ")).drop(1).associate {
            it.substringBefore('\n') to it.substringAfter('\n').trim().replace(Regex("""\s+"""), " ")
        }

    @ParameterizedTest
    @ValueSource(strings = ["core", "scenes", "conformance", "testing", "server", "spark", "swing"])
    fun eachPublicPackageHasAText(module: String) {
        val packages = publicPackages(module)
        assertTrue("dev.lazyz" in packages || "dev.lazyz.$module" in packages) { "$packages" }
        val texts = texts(module)
        assertEquals(setOf("Module lazyz-$module") + packages.map { "Package $it" }, texts.keys)
        for ((heading, text) in texts) assertTrue(text.length > 40) { "$heading: $text" }
    }
}
