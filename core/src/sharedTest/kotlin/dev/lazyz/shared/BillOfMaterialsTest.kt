package dev.lazyz.shared

import java.io.File
import java.nio.file.Path
import java.security.MessageDigest
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/** `src/main/sbom` has the bill of materials of a jar that runs alone, in the format CycloneDX: a component a line. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class BillOfMaterialsTest {
    private val folder = Path.of("").toAbsolutePath().resolve("src/main/sbom")
    private val bill by lazy { folder.listDirectoryEntries().single().readText() }
    private val libraries by lazy { LIBRARY.findAll(bill).map { it.destructured }.toList() }

    @BeforeEach
    fun hasABill() = assumeTrue(folder.exists(), "no jar of a release that runs alone")

    /** Each jar of the class path, but those that only tests use, with its version and its bytes. */
    @Test
    fun theBillListsTheClassPath() {
        val jars = ClassPath.entries.filter { it.extension == "jar" && !it.name.startsWith("lazyz-") }
        val listed = libraries.map { (_, name, version, _, _, hash) -> "$name-$version.jar $hash" }
        val there = jars.map { "${it.name} ${sha256(it)}" }
        val unlisted = (there - listed.toSet()).filterNot { line -> TESTS_ONLY.any { line.startsWith("$it-") } }
        assertEquals(emptyList<String>(), unlisted, "add them to $folder")
        assertEquals(emptyList<String>(), listed - there.toSet(), "remove them from $folder")
        for ((group, name, version, purl) in libraries) assertEquals("pkg:maven/$group/$name@$version", purl)
    }

    @Test
    fun ourOwnHaveTheVersionOfTheProject() {
        val root = generateSequence(folder) { it.parent }.first { it.resolve("settings.gradle.kts").exists() }
        val version = Regex("(?m)^version = (.*)$").find(root.resolve("gradle.properties").readText())!!.groupValues[1]
        val own = Regex(""""group": "dev.lazyz", "name": "lazyz-(\w+)", "version": "(.*?)"""").findAll(bill).toList()
        assertTrue(own.any { it.groupValues[1] == "core" } && own.all { it.groupValues[2] == version }) { bill }
    }

    /** The texts of the others' licences are in their own jars, which have them in `META-INF`. */
    @Test
    fun licencesThatRequireItAreInTheJarWithTheirOwners() {
        val text = checkNotNull(javaClass.getResource("/META-INF/licenses/THIRD-PARTY.txt")).readText()
        for ((_, name, _, _, licence) in libraries) {
            if (licence in setOf("Apache-2.0", "EPL-2.0", "MIT-0")) continue
            val owner = Regex("(?m)^(?:.*, )?${name.removeSuffix("-jvm")}(?:, .*)?: Copyright \\(c\\) .+$")
            assertTrue(owner.containsMatchIn(text)) { "$name, $licence" }
        }
    }

    private fun sha256(file: File): String =
        MessageDigest.getInstance("SHA-256").digest(file.readBytes()).joinToString("") { "%02x".format(it) }

    private companion object {
        val LIBRARY = Regex(
            """"group": "([^"]+)", "name": "([^"]+)", "version": "([^"]+)", "purl": "([^"]+)", """ +
                """"licenses": \[\{"license": \{"id": "([^"]+)"}}], "hashes": \[\{"alg": "SHA-256", "content": "(\w+)"}]""",
        )

        val TESTS_ONLY = listOf(
            "abi-tools", "apiguardian-api", "gradle", "java-diff-utils", "jqwik", "junit-jupiter", "junit-platform",
            "kotlin-klib-abi-reader", "kotlin-metadata-jvm", "opentest4j",
        )
    }
}
