package dev.lazyz.scenes.loading

import dev.lazyz.scenes.ReferencePolicy
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class FileReferencesTest {
    @TempDir
    lateinit var root: Path

    private val folder by lazy { Files.createDirectories(root.resolve("scene")) }

    private fun file(name: String): Path {
        val file = root.resolve(name)
        Files.createDirectories(file.parent)
        return Files.write(file, byteArrayOf(1)).toRealPath()
    }

    private fun find(reference: String, policy: ReferencePolicy = ReferencePolicy.WITHIN_FOLDER): Path? =
        FileReferences(folder, folder, policy).find(reference).file?.toRealPath()

    private fun warning(reference: String): String =
        FileReferences(folder, folder, ReferencePolicy.WITHIN_FOLDER).find(reference).warning

    @Test
    fun partsMayBeDividedEitherWay() {
        val wood = file("scene/tex/dark wood.png")
        val references = listOf(
            "tex/dark wood.png",
            "tex\\dark wood.png",
            "./tex/./dark wood.png",
            ".\\tex\\dark wood.png",
            " \"tex/dark wood.png\" ",
        )
        for (reference in references) {
            assertEquals(wood, find(reference), reference)
        }
    }

    @Test
    fun caseIsTheLastResort() {
        val lower = file("scene/Tex/wood.png")
        assertEquals(lower, find("tEX/WOOD.PNG"))
        val upper = file("scene/Tex/WOOD.png")
        assertEquals(upper, find("Tex/WOOD.png"))
        assertEquals(lower, find("Tex/wood.png"))
    }

    @Test
    fun referenceMayLeadUpwardWhereThatIsAllowed() {
        val wood = file("tex/wood.png")
        assertEquals(wood, find("../tex/wood.png", ReferencePolicy.ANYWHERE))
        assertNull(find("../tex/wood.png"))
        assertEquals(
            "lies outside $folder and is left out; copy it there, or if the model can be trusted set " +
                "LoadLimits.references (zcli: --allow-outside)",
            warning("../tex/wood.png"),
        )
        assertNull(find("../../../../../../../../../../../../nothing", ReferencePolicy.ANYWHERE))
        assertEquals("is missing and is left out; put it into $folder", warning("../nothing"))

        // Up and down again is within the folder
        val inside = file("scene/tex/wood.png")
        assertEquals(inside, find("../scene/tex/wood.png"))
    }

    @Test
    fun theRemedyNamesThePlaceThatWasSearched() {
        assertEquals("is missing and is left out; put it into $folder/tex/a", warning("tex\\a\\wood.png"))
        assertEquals("is missing and is left out; put it into $folder/tex", warning("./tex/wood.png"))
        for (reference in listOf("wood.png", "C:\\tex\\wood.png", "/tex/wood.png", "../tex/wood.png", "a\u0000/b")) {
            assertEquals("is missing and is left out; put it into $folder", warning(reference), reference)
        }
    }

    @Test
    fun linksAreResolved() {
        val secret = file("secret.png")
        val inside = file("scene/tex/wood.png")
        Files.createSymbolicLink(folder.resolve("out.png"), secret)
        Files.createSymbolicLink(folder.resolve("up"), root)
        Files.createSymbolicLink(folder.resolve("in.png"), inside)
        assertNull(find("out.png"))
        assertNull(find("up/secret.png"))
        assertEquals(inside, find("in.png"))
        assertEquals(secret, find("out.png", ReferencePolicy.ANYWHERE))
    }

    @Test
    fun absolutePathCountsOnlyWithinTheFolder() {
        val inside = file("scene/tex/wood.png")
        val outside = file("other/wood.png")
        assertEquals(inside, find(folder.toRealPath().resolve("tex/wood.png").toString()))
        assertNull(find(outside.toString()))
        val beside = file("scene/wood.png")
        assertEquals(beside, find(outside.toString()))
        assertEquals(beside, find("C:\\Users\\me\\wood.png"))
        assertEquals(beside, find("https://example.com/wood.png"))
    }
}
