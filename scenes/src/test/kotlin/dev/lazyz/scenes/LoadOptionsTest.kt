package dev.lazyz.scenes

import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class LoadOptionsTest {
    @Test
    fun timesThatAreNoneAreRefused() {
        for (time in listOf(-1.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThrows(IllegalArgumentException::class.java) { LoadOptions(animationTime = time) }
        }
        assertTrue("animationTime=0.5" in LoadOptions(animationTime = 0.5).toString())
    }

    @Test
    fun formatsWithoutAnimationsWarn(@TempDir folder: Path) {
        val path = Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
        val options = LoadOptions(animationTime = 1.0)
        val ways = listOf(
            Scenes.load(path, options),
            Scenes.load(path, SceneFormat.OBJ, options),
            Files.newInputStream(path).use { Scenes.load(it, SceneFormat.OBJ, "a.obj", null, options) },
        )
        for (loaded in ways) assertTrue("no animation" in loaded.warnings.single(), "${loaded.warnings}")
        assertEquals(emptyList<String>(), Scenes.load(path, LoadOptions()).warnings)
    }
}
