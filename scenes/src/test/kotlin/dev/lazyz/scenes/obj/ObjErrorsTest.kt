package dev.lazyz.scenes.obj

import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.meshes
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class ObjErrorsTest {
    private val triangle = "v 0 0 0\nv 1 0 0\nv 1 1 0\n"

    private fun assertFails(text: String, location: String?, part: String) {
        val error = TestSources.error(ObjParser, TestSources.of(text))
        assertEquals(location, error.location, error.message)
        assertTrue(part in error.message!!, "\"$part\" in: ${error.message}")
    }

    @Test
    fun errorsNameTheirLine() {
        assertFails("# nothing\n", null, "no vertex")
        assertFails(triangle + "f 1 2 4\n", "line 4", "number 4 of 3 vertices")
        assertFails(triangle + "\n\nf 1 2 \\\n 4\n", "line 6", "number 4 of 3 vertices")
        assertFails(triangle + "f 1 2 -4\n", "line 4", "number -4, counted backward, of the 3 vertices")
        assertFails(triangle + "f 1 2 0\n", "line 4", "\"0\"")
        assertFails(triangle + "f 1 2 x\n", "line 4", "\"x\"")
        assertFails(triangle + "f 1 2 4294967297\n", "line 4", "\"4294967297\"")
        assertFails(triangle + "f 1 2 3/1/1/1\n", "line 4", "more than three")
        assertFails(triangle + "v 1 2\n", "line 4", "needs 3 numbers, not 2")
        assertFails(triangle + "v\n", "line 4", "needs 3 numbers")
        assertFails(triangle + "vt\n", "line 4", "needs 1 numbers")
        assertFails(triangle + "v 1 2 x\n", "line 4", "\"x\"")
        assertFails(triangle + "v 1,5 2 3\n", "line 4", "decimal point")
        assertFails(triangle + "v 1 2 --3\n", "line 4", "cannot be understood")
    }

    @Test
    fun facesLoseReferencesToWhatIsNotThere() {
        val text = triangle + "vt 0 0\nvn 0 0 1\nf 1/1 2/2 3/1\nf 1/0 2/1 3/1\nf 1/-9 2/1 3/1\nf 1/1 2/1 3/1\n" +
            "f 1//1 2//7 3//99999999999\n"
        val source = TestSources.of(text)
        val meshes = ObjParser.parse(source).meshes
        assertEquals(5, meshes.sumOf { it.triangleCount })
        assertEquals(
            listOf(
                "test: 3 faces, first in line 6, refer to texture coordinates that are not there, and are drawn without",
                "test: 1 faces, first in line 10, refer to normals that are not there, and are drawn without",
            ),
            source.warnings,
        )
    }

    @Test
    fun materialErrorsNameTheLibraryAndItsLine(@TempDir folder: Path) {
        val statements = listOf("Ns x", "d", "illum a").associateWith { true } +
            listOf("Kd", "Kd spectral f", "bump").associateWith { false }
        for ((statement, isBad) in statements) {
            Files.writeString(folder.resolve("m.mtl"), "Kd 1 1 1\n\nnewmtl a\n$statement\n")
            val source = TestSources.of(triangle + "mtllib m.mtl\nusemtl a\nf 1 2 3\n", folder)
            if (isBad) {
                val error = TestSources.error(ObjParser, source)
                assertEquals("line 4", error.location)
                assertTrue(error.source.endsWith("m.mtl") && statement in error.problem, error.message)
            } else {
                assertEquals(1, ObjParser.parse(source).surfaces.size, statement)
            }
        }
    }
}
