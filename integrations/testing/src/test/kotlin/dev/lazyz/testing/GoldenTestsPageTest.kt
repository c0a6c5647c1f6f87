package dev.lazyz.testing

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `docs/golden-tests.md` says what is so. */
class GoldenTestsPageTest {
    private val root = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .first { it.resolve("settings.gradle.kts").exists() && it.resolve("pom.xml").exists() }
    private val page = root.resolve("docs/golden-tests.md").readText()

    @Test
    fun theTableHasAllProperties() {
        val listed = Regex("""\| `(lazyz\.[a-z.]+)` \|""").findAll(page).map { it.groupValues[1] }.toList()
        assertEquals(listOf(GoldenSettings.UPDATE, GoldenSettings.ROOT, GoldenSettings.OUTPUT), listed)
    }

    @Test
    fun theMethodsExist() {
        val types = listOf(SceneAssertion::class, RenderingAssertion::class, PictureAssertion::class)
        val methods = types.flatMap { type -> type.java.methods.map { it.name } }
        val listed = Regex("""`(with\w+)""").findAll(page).map { it.groupValues[1] }.toSet()
        assertTrue(listed.size >= 4, "$listed")
        assertEquals(emptyList<String>(), listed.filter { it !in methods })
    }
}
