package dev.lazyz.conformance.rules

import dev.lazyz.conformance.results.SuiteRule
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.writeLines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** Versions of contract and suite, and the rules of each. */
class VersionsTest {
    private val root = listOf(".", "..").map { Path.of(it) }.first { Files.isDirectory(it.resolve("docs")) }
    private val contract = root.resolve("docs/contract.md").readText()
    private val page = root.resolve("docs/conformance.md").readText()
    private val list = root.resolve("docs/conformance/rules-${ConformanceVersions.SUITE}.txt")

    @Test
    fun pagesTellTheVersions() {
        assertTrue("\nVersion ${ConformanceVersions.CONTRACT}.\n" in contract)
        assertTrue("\nVersion ${ConformanceVersions.SUITE} of the suite, " in page)
    }

    /** `-Dlazyz.update=true` adds new rules to the list of the version. A removed rule needs a new version. */
    @Test
    fun ruleDoesNotDisappearWithoutANewVersion() {
        val rules = SuiteRule.all.map { it.name }
        val listed = list.readLines()
        if (System.getProperty("lazyz.update") == "true") list.writeLines((listed + rules).distinct().sorted())
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
        val reasons = Regex("(?m)^\\| (\\d+\\.\\d+) \\|").findAll(page).map { it.groupValues[1] }.toSet()
        assertTrue(numbers.size > 40, "$numbers")
        assertEquals(numbers - named, reasons, "rules of the contract that no test is named after")
    }
}
