package dev.lazyz.scenes

import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.scenes.threemf.ThreeMfFiles
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
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
    fun propertiesAreChangedOneByOne() {
        val limits = LoadLimits(triangles = 3)
        val changed = LoadOptions().withLimits(limits).withAnimationTime(0.5).withoutSmoothNormals()
        assertEquals(LoadOptions(limits, 0.5, false).toString(), changed.toString())
        assertEquals(LoadOptions(limits).toString(), changed.withoutAnimationTime().withSmoothNormals().toString())
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

    @Test
    fun normalsAreMadeUnlessTheyAreNotWanted() {
        val corners = listOf("0 0 0", "1 0 0", "0 1 0")
        val facet = "facet normal 0 0 1\nouter loop\n${corners.joinToString("") { "vertex $it\n" }}endloop\nendfacet\n"
        val ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
        val mesh = """<object id="1" type="model">${ThreeMfFiles.TRIANGLE}</object>"""
        val files = mapOf(
            SceneFormat.OBJ to (corners.joinToString("") { "v $it\n" } + "f 1 2 3\n").toByteArray(),
            SceneFormat.STL to "solid a\n${facet}endsolid a\n".toByteArray(),
            SceneFormat.PLY to (ply + corners.joinToString("") { "$it\n" } + "3 0 1 2\n").toByteArray(),
            SceneFormat.OFF to ("OFF\n3 1 0\n" + corners.joinToString("") { "$it\n" } + "3 0 1 2\n").toByteArray(),
            SceneFormat.THREE_MF to ThreeMfFiles.of(ThreeMfFiles.model(mesh, """<item objectid="1"/>""")),
        )
        for ((format, bytes) in files) {
            fun mesh(options: LoadOptions) =
                Scenes.load(bytes.inputStream(), format, "a", null, options).scene.meshes.single()
            assertEquals(listOf(0f, 0f, 1f), mesh(LoadOptions()).normals?.take(3), "$format")
            val plain = mesh(LoadOptions(smoothNormals = false))
            assertNull(plain.normals, "$format")
            assertEquals(mesh(LoadOptions()).corners(), plain.corners(), "$format")
        }
    }
}
