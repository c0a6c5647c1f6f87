package dev.lazyz.conformance.rules

import dev.lazyz.conformance.results.SuiteRule
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Versions of contract and suite, and the rules of each. */
class VersionsTest {
    private val root = listOf(".", "..").map { Path.of(it) }.first { Files.isDirectory(it.resolve("docs")) }
    private val contract = root.resolve("docs/contract.md").readText()
    private val page = root.resolve("docs/conformance-versions.md")

    private fun section(version: String) =
        page.readText().substringAfter("\n## Suite $version\n").substringBefore("\n## ")

    private fun listed(version: String): List<String> =
        Regex("(?m)^- `(rule_\\w+)`$").findAll(section(version)).map { it.groupValues[1] }.toList()

    @Test
    fun pagesTellTheVersions() {
        assertTrue(contract.startsWith("# The contract\n\nVersion ${ConformanceVersions.CONTRACT}.\n"))
        val suite = root.resolve("docs/conformance.md").readText().lines().take(3).last()
        assertEquals(
            "Version ${ConformanceVersions.SUITE} of the suite, " +
                "for version ${ConformanceVersions.CONTRACT} of the contract.",
            suite,
        )
    }

    /** `-Dlazyz.update=true` adds new rules to the version's list. A removed rule needs a new version. */
    @Test
    fun ruleDoesNotDisappearWithoutANewVersion() {
        val rules = SuiteRule.all.map { it.name }
        if (System.getProperty("lazyz.update") == "true") {
            val all = (listed(ConformanceVersions.SUITE) + rules).distinct().sorted()
            val old = section(ConformanceVersions.SUITE)
            val list = all.joinToString("\n", postfix = "\n") { "- `$it`" }
            page.writeText(page.readText().replace(old, old.substringBefore("- `rule_") + list))
        }
        val listed = listed(ConformanceVersions.SUITE)
        assertTrue(listed.size >= 43, "$listed")
        assertEquals(emptyList<String>(), listed - rules.toSet(), "rules of this version of the suite are gone")
    }

    @Test
    fun everyRuleOfTheContractHasATestOrAReason() {
        val numbers = Regex("(?m)^\\*\\*(\\d+\\.\\d+)\\*\\*").findAll(contract).map { it.groupValues[1] }.toSet()
        val named = Files.walk(root).use { paths ->
            paths.filter { (it.extension == "kt" || it.extension == "java") && "target" !in it.map { part -> "$part" } }
                .toList().flatMap { path ->
                    Regex("fun rule_(\\d+)_(\\d+)_").findAll(path.readText())
                        .map { "${it.groupValues[1]}.${it.groupValues[2]}" }
                }
        }.toSet()
        val reasons = Regex("(?m)^\\| (\\d+\\.\\d+) \\|").findAll(page.readText()).map { it.groupValues[1] }.toSet()
        assertTrue(numbers.size > 40, "$numbers")
        assertEquals(numbers - named, reasons, "rules of the contract that no test is named after")
    }
}
