package dev.lazyz.scenes.images

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

    private fun find(reference: String): Path? = FileReferences.find(folder, reference)?.toRealPath()

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
    fun referenceMayLeadUpward() {
        val wood = file("tex/wood.png")
        assertEquals(wood, find("../tex/wood.png"))
        assertNull(find("../../../../../../../../../../../../nothing"))
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

    @Test
    fun onlyRegularFilesCount() {
        Files.createDirectories(folder.resolve("directory.png"))
        for (reference in listOf("directory.png", "", ".", "..", "/", "/dev/zero", "a\u0000b", "wood.png/x")) {
            assertNull(find(reference), reference)
        }
        assertNull(FileReferences.find(null, "wood.png"))
    }
}
