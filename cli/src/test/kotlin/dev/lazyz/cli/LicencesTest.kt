package dev.lazyz.cli

import java.io.File
import java.util.zip.ZipFile
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/** The jar of the command line contains libraries whose licences require that their text is distributed with them. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class LicencesTest {
    @Test
    fun everyLibraryHasItsLicence() {
        val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
        val jars = classPath.split(File.pathSeparator).map(::File).filter { it.extension == "jar" }
        val withoutText = jars.filterNot(::hasLicence).map { it.name }.filterNot { name ->
            (owners.keys + withTextsElsewhere + notThirdParty).any { name.startsWith("$it-") }
        }
        assertEquals(emptyList<String>(), withoutText)
        assertTrue(jars.any { it.name.startsWith("drako-") }, classPath)
    }

    @Test
    fun theTextNamesTheOwners() {
        val text = checkNotNull(javaClass.getResource("/META-INF/licenses/THIRD-PARTY.txt")).readText()
        for ((library, owner) in owners) {
            assertTrue(Regex("(?m)^.*\\b$library\\b.*: Copyright \\(c\\) .*$owner$").containsMatchIn(text)) { library }
        }
    }

    private fun hasLicence(jar: File): Boolean = ZipFile(jar).use { zip ->
        zip.entries().asSequence().any { it.name.startsWith("META-INF/LICENSE") }
    }

    private companion object {
        /** Libraries whose jars do not contain the text: `THIRD-PARTY.txt` does. */
        val owners = mapOf(
            "drako" to "Openize Pty Ltd",
            "earcut4j" to "Mapbox",
            "jgltf-impl-v1" to "Marco Hutter",
            "jgltf-impl-v2" to "Marco Hutter",
            "jgltf-model" to "Marco Hutter",
            "joml" to "JOML",
            "obj" to "Marco Hutter",
        )

        /** Apache License 2.0, or (jqwik) Eclipse Public License 2.0: jars of other libraries contain these texts. */
        val withTextsElsewhere = listOf(
            "abi-tools", "annotations", "clikt", "colormath", "java-diff-utils", "jqwik", "kotlin-klib-abi-reader",
            "kotlin-metadata-jvm", "kotlin-stdlib", "kotlinx-coroutines-core", "kotlinx-serialization-core",
            "kotlinx-serialization-json", "mordant", "netty",
        )

        /** The libraries of this project, and the jar that Gradle adds to the class path of tests. */
        val notThirdParty = listOf("gradle", "lazyz")
    }
}
