package dev.lazyz.scenes

import dev.lazyz.scenes.formats.FormatSniffer
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.world.surface.Mesh
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.assertThrows
import org.junit.jupiter.api.io.TempDir

class ScenesTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun aFileIsReadByItsEnding() {
        val path = file("ball.JSON", """{"lazyz": 1, "surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}}]}""")
        assertEquals(1, Scenes.load(path).scene.surfaces.size)
    }

    @Test
    fun anEndingThatSaysNothingLeavesItToTheContent() {
        val path = file("scene.txt", "\uFEFF\n {\"lazyz\": 1, \"size\": [3, 4]}")
        assertEquals(ImageSize(3, 4), Scenes.load(path).size)
    }

    @Test
    fun theContentShowsTheFormat() {
        val binaryStl = ByteArray(84 + 50).also { it[80] = 1 }
        assertEquals(SceneFormat.STL, FormatSniffer.format(binaryStl))
        assertEquals(SceneFormat.STL, FormatSniffer.format("solid a\n facet normal 0 0 1\n".toByteArray()))
        assertEquals(SceneFormat.PLY, FormatSniffer.format("ply\nformat ascii 1.0\n".toByteArray()))
        assertEquals(SceneFormat.OFF, FormatSniffer.format("STCNOFF # a\n1 1 1\n".toByteArray()))
        assertEquals(SceneFormat.THREE_MF, FormatSniffer.format("PK\u0003\u0004".toByteArray()))
        assertEquals(SceneFormat.GLB, FormatSniffer.format("glTF\u0002\u0000".toByteArray()))
        assertEquals(SceneFormat.GLTF, FormatSniffer.format("{ \"asset\": {}}".toByteArray()))
        assertEquals(SceneFormat.OBJ, FormatSniffer.format("# a cube\n\nmtllib a.mtl\nv 0 0 0\n".toByteArray()))
        assertEquals(null, FormatSniffer.format("very interesting\n".toByteArray()))
        assertEquals(null, FormatSniffer.format(ByteArray(0)))
        assertEquals(null, FormatSniffer.format("{}".toByteArray()))
    }

    @Test
    fun messagesSayWhatIsWrongWithTheFile() {
        val missing = folder.resolve("no.obj")
        assertEquals("$missing: there is no such file; check the name", message(missing))
        assertEquals("$folder: is a folder; name a file in it", message(folder))
        val empty = file("empty.obj", "")
        assertEquals("$empty: is empty; check that it was written completely", message(empty))
        assertTrue("is empty" in message(file("empty", "")))
        val odd = file("odd.xyz", "1 2 3\n")
        assertEquals(
            "$odd: is of no known format; known are .obj, .stl, .ply, .off, .3mf, .gltf, .glb, .json",
            message(odd),
        )
    }

    @Test
    fun filesThatCannotBeReadAreDistinguishedFromDamagedOnes() {
        for (path in listOf(folder.resolve("no.obj"), folder)) {
            assertThrows<SceneReadException> { Scenes.load(path) }
            assertThrows<SceneReadException> { Scenes.stream(path) }
            assertThrows<SceneReadException> { Scenes.texture(path) }
            assertThrows<SceneReadException> { Picture.read(path) }
        }
        val damaged = listOf(file("empty.obj", ""), file("odd.obj", "f 1 2 9\n"), file("a.json", sceneWith("b.obj")))
        for (path in damaged) {
            val thrown = assertThrows<SceneFormatException> { Scenes.load(path) }
            assertFalse(thrown is SceneReadException, thrown.message)
        }
    }

    @Test
    fun aSceneFileNamesItsMeshesRelativeToItself() {
        val inner = Files.createDirectory(folder.resolve("inner"))
        val missing = Files.writeString(inner.resolve("a.json"), sceneWith("b.obj"))
        assertEquals("$missing, surfaces[0].mesh: the file b.obj is missing; put it into $inner", message(missing))
        val absolute = Files.writeString(inner.resolve("c.json"), sceneWith("/b.obj"))
        assertEquals("$absolute, surfaces[0].mesh: must be relative to the scene file: /b.obj", message(absolute))
    }

    private fun sceneWith(mesh: String): String = """{"lazyz": 1, "surfaces": [{"mesh": "$mesh"}]}"""

    @Test
    fun aFileWithoutPermissionIsAnError() {
        val locked = file("locked.json", "{}")
        assumeTrue(locked.toFile().setReadable(false) && !Files.isReadable(locked), "all is permitted to this user")
        assertTrue("permission denied" in message(locked), message(locked))
    }

    private fun message(path: Path): String =
        assertThrows(SceneFormatException::class.java) { Scenes.load(path) }.message.orEmpty()

    private fun file(name: String, text: String): Path = Files.writeString(folder.resolve(name), text)

    /** Also those that cannot be decoded; not those that are missing. */
    @Test
    fun filesThatAModelRefersToAreListed() {
        file("wood.png", "no image")
        file("m.mtl", "newmtl m\nmap_Kd wood.png\nmap_Ks wood.png\nmap_d missing.png\n")
        val model = file("m.obj", "mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
        val files = listOf("m.mtl", "wood.png").map { folder.resolve(it) }
        assertEquals(files, Scenes.load(model).files)
        val scene = file("s.json", """{"lazyz": 1, "surfaces": [{"mesh": "m.obj"}]}""")
        assertEquals(listOf(model) + files, Scenes.load(scene).files)
        assertEquals(files, Scenes.load(model).let { it.withScene(it.scene) }.files)
        assertEquals(emptyList<Path>(), Scenes.load(file("p.obj", "v 0 0 0\n")).files)
    }

    @Test
    fun bytesAreReadLikeAStream() {
        val bytes = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".toByteArray()
        assertEquals(SceneFormat.OBJ, Scenes.formatOf(bytes))
        assertNull(Scenes.formatOf("no model".toByteArray()))
        val mesh = Scenes.load(bytes, SceneFormat.OBJ).scene.surfaces.single() as Mesh
        assertEquals(1, mesh.triangleCount)
        val empty = assertThrows(SceneFormatException::class.java) {
            Scenes.load(ByteArray(0), SceneFormat.OBJ, "upload")
        }
        assertTrue(empty.message!!.startsWith("upload: is empty"), empty.message)
    }

    @Test
    fun anInterruptEndsTheReading() {
        val bytes = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n".toByteArray()
        Thread.currentThread().interrupt()
        val end = assertThrows(SceneFormatException::class.java) { Scenes.load(bytes, SceneFormat.OBJ) }
        assertTrue(Thread.interrupted())
        assertTrue("the thread is interrupted" in end.message!!, end.message)
    }
}
