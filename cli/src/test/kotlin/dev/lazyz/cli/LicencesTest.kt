package dev.lazyz.cli

import java.io.File
import java.util.zip.ZipFile
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The jar of the command line holds other people's libraries, whose licences ask for their text to be with them. */
class LicencesTest {
    @Test
    fun everyLibraryHasItsLicence() {
        val classPath = System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path")
        val jars = classPath.split(File.pathSeparator).map(::File).filter { it.extension == "jar" }
        val withoutText = jars.filterNot(::hasLicence).map { it.name }.filterNot { name ->
            (owners.keys + withTextsElsewhere + OWN_NAME).any { name.startsWith("$it-") }
        }
        assertEquals(emptyList<String>(), withoutText)
        assertTrue(jars.any { it.name.startsWith("drako-") }, classPath)
    }

    @Test
    fun textsNameTheirOwners() {
        for ((library, owner) in owners) {
            val file = "/META-INF/licenses/${library.substringBefore('-')}.txt"
            val text = javaClass.getResource(file)?.readText().orEmpty()
            assertTrue("Copyright (c) " in text && owner in text && "permission notice" in text, file)
        }
    }

    private fun hasLicence(jar: File): Boolean = ZipFile(jar).use { zip ->
        zip.entries().asSequence().any { it.name.startsWith("META-INF/LICENSE") }
    }

    private companion object {
        /** Libraries whose jars lack the text, which is in ours therefore. */
        val owners = mapOf(
            "drako" to "Openize Pty Ltd",
            "earcut4j" to "Mapbox",
            "jgltf-impl-v1" to "Marco Hutter",
            "jgltf-impl-v2" to "Marco Hutter",
            "jgltf-model" to "Marco Hutter",
            "joml" to "JOML",
            "obj" to "Marco Hutter",
        )

        /** Apache License 2.0, and Eclipse Public License 2.0 of jqwik: other libraries' jars have these texts. */
        val withTextsElsewhere = listOf(
            "annotations", "clikt", "clikt-core-jvm", "clikt-jvm", "colormath-jvm", "jqwik", "kotlin-stdlib",
            "kotlinx-coroutines-core-jvm", "kotlinx-serialization-core-jvm", "kotlinx-serialization-json-jvm",
            "mordant-core-jvm", "mordant-jvm",
        )
        const val OWN_NAME = "lazyz"
    }
}
