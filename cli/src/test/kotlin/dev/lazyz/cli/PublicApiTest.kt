package dev.lazyz.cli

import dev.lazyz.Image
import dev.lazyz.conformance.Conformance
import dev.lazyz.scenes.Scenes
import dev.lazyz.server.RenderServer
import dev.lazyz.spark.ModelPictures
import dev.lazyz.testing.PictureAssertion
import java.io.File
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.jetbrains.kotlin.abi.tools.AbiFilters
import org.jetbrains.kotlin.abi.tools.AbiTools
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/**
 * The public API of the libraries is what `MODULE/api/lazyz-MODULE.api` lists: the signatures that compiled programs
 * depend on. A change of the API shows in the diff of these files; `-Dlazyz.update=true` writes them.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PublicApiTest {
    @Test
    fun theApiIsTheListedOne() {
        val changed = MODULES.mapNotNull { (module, type) ->
            val listing = ProjectFiles.folderOf(module).resolve("api/lazyz-$module.api")
            val actual = dump(type)
            if (System.getProperty("lazyz.update") == "true") {
                listing.parent.createDirectories()
                listing.writeText(actual)
            }
            if (listing.exists() && listing.readText() == actual) null else "$listing:\n${difference(listing, actual)}"
        }
        assertTrue(changed.isEmpty()) {
            "the public API has changed; if that is meant, run this test with -Dlazyz.update=true, and say so in " +
                "CHANGELOG.md:\n${changed.joinToString("\n")}"
        }
    }

    @Test
    fun internalTypesAreNotListed() {
        val core = dump(Image::class.java)
        assertTrue("public final class dev/lazyz/Image {" in core)
        assertEquals(emptyList<String>(), core.lines().filter { "dev/lazyz/setup/" in it && it.startsWith("public") })
    }

    private fun dump(type: Class<*>): String {
        val place = File(type.protectionDomain.codeSource.location.toURI())
        val files = if (place.isDirectory) place.walk().filter { it.extension == "class" }.toList() else listOf(place)
        return buildString { AbiTools.getInstance(javaClass.classLoader).printJvmDump(this, files, AbiFilters.EMPTY) }
    }

    private fun difference(listing: Path, actual: String): String {
        val listed = if (listing.exists()) listing.readText().lines().toSet() else emptySet()
        val now = actual.lines()
        return (
            (listed - now.toSet()).map {
                "- $it"
            } + now.filter { it !in listed }.map { "+ $it" }
            ).joinToString("\n")
    }

    private companion object {
        /** The libraries, each with one of its types. */
        val MODULES = mapOf(
            "core" to Image::class.java,
            "scenes" to Scenes::class.java,
            "conformance" to Conformance::class.java,
            "testing" to PictureAssertion::class.java,
            "server" to RenderServer::class.java,
            "spark" to ModelPictures::class.java,
        )
    }
}
