package dev.lazyz.scenes

import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.images.PngFile
import dev.lazyz.scenes.threemf.ThreeMfFiles
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Each limit is reached, and says its name. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class LoadLimitsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun trianglesAndVerticesOfEveryFormatAreCounted() {
        for ((name, text) in squares) {
            val path = Files.write(folder.resolve(name), text)
            assertEquals(1, Scenes.load(path).scene.surfaces.size, name)
            val triangles = message(path, LoadLimits(triangles = 1))
            assertTrue("more than 1 triangles: 2" in triangles && "--max-triangles" in triangles, triangles)
            val vertices = message(path, LoadLimits(vertices = 3))
            assertTrue("more than 3 vertices" in vertices && "--max-vertices" in vertices, vertices)
            val bytes = message(path, LoadLimits(decodedBytes = 100))
            assertTrue("bytes of decoded data" in bytes && "--max-decoded" in bytes, bytes)
            val time = message(path, LoadLimits(time = Duration.ZERO))
            assertTrue("0 ms" in time && time.endsWith("raise LoadLimits.time (zcli: --max-seconds)"), time)
            for (kept in listOf(triangles, vertices, bytes)) assertTrue(kept.endsWith(", and -Xmx if need be"), kept)
            Scenes.load(path, LoadLimits(decodedBytes = 1000, triangles = 2, vertices = 6))
        }
    }

    /** They are not kept in memory. */
    @Test
    fun limitsOfStreamedTrianglesNeedNoMoreMemory() {
        val path = Files.write(folder.resolve("square.stl"), squares.getValue("square.stl"))
        val error = assertThrows(SceneFormatException::class.java) {
            Scenes.stream(path, limits = LoadLimits(triangles = 1), spool = folder).close()
        }
        val advice = "raise LoadLimits.triangles (zcli: --max-triangles)"
        assertTrue(error.message.orEmpty().endsWith(advice), error.message)
    }

    @Test
    fun itemsOfEveryFormatAreCounted() {
        val facets = String(squares.getValue("square.stl"))
        val package3mf = ThreeMfFiles.of(
            ThreeMfFiles.model("<object id=\"1\">${ThreeMfFiles.TRIANGLE}</object>", "<item objectid=\"1\"/>"),
        )
        val off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
        val gltf1 = "{\"asset\": {\"version\": \"1.0\"}, \"nodes\": {\"a\": {}, \"b\": {}}}"
        val files = squares + mapOf(
            "square.obj" to "v 0 0 0\nv 1 0 0\nv 0 1 0\no a\nf 1 2 3\no b\nf 1 2 3\n".toByteArray(),
            "square.stl" to (facets + facets).toByteArray(),
            "one.gltf" to gltf1.toByteArray(),
            "a.3mf" to package3mf,
        )
        for ((name, bytes) in files) {
            val path = Files.write(folder.resolve(name), bytes)
            val message = message(path, LoadLimits(items = 1))
            assertTrue("more than 1 items such as objects and materials: 2" in message, message)
            assertTrue("LoadLimits.items (zcli: --max-items)" in message, message)
            assertTrue("--max-decoded" in message(path, LoadLimits(decodedBytes = 63)), name)
        }

        // Of OFF there are none
        val path = Files.writeString(folder.resolve("a.off"), off)
        assertEquals(1, Scenes.load(path, LoadLimits(items = 0)).scene.surfaces.size)
    }

    @Test
    fun materialsOfALibraryAreItems() {
        val path = obj("a.png", "b.png", "c.png")
        val library = 1
        val parts = 4
        val message = message(path, LoadLimits(items = library + parts + 2L))
        assertTrue("more than 7 items" in message && "a.mtl" in message, message)
        assertEquals(3, Scenes.load(path, LoadLimits(items = library + parts + 3L)).scene.surfaces.size)
    }

    @Test
    fun texelsAreCountedBeforeTheyAreDecoded() {
        Files.write(folder.resolve("t.png"), PngFile.of(100, 100, 8, PngFile.GREY, List(100) { ByteArray(100) }))
        val path = obj("t.png")
        assertTrue(Scenes.load(path).warnings.isEmpty())
        val message = message(path, LoadLimits(texels = 9_999))
        assertTrue("more than 9999 pixels of textures: 10000" in message && "--max-texels" in message, message)
    }

    /** Of each texture the texels and mip levels are kept. */
    @Test
    fun memoryForDecodingIsCountedForTheLargestTextureOnly() {
        val names = listOf("a.png", "b.png", "c.png", "d.png")
        for (name in names) {
            val side = if (name == "b.png") 100 else 50
            Files.write(
                folder.resolve(name),
                PngFile.of(side, side, 8, PngFile.GREY, List(side) { ByteArray(side) }),
            )
        }
        val path = obj(*names.toTypedArray())
        val need = 6L * (100 * 100 + 3 * 50 * 50) + 6L * 100 * 100
        val message = message(path, LoadLimits(decodedBytes = need))
        assertTrue("more than $need bytes of decoded data" in message, message)
        val mesh = 2000
        assertTrue(Scenes.load(path, LoadLimits(decodedBytes = need + mesh)).warnings.isEmpty())
    }

    @Test
    fun oneFileUnderSeveralNamesIsOneTexture() {
        Files.createDirectory(folder.resolve("sub"))
        Files.write(folder.resolve("t.png"), PngFile.of(10, 10, 8, PngFile.GREY, List(10) { ByteArray(10) }))
        val path = obj("t.png", "./t.png", "sub/../t.png", "T.PNG")
        assertTrue(Scenes.load(path, LoadLimits(texels = 100)).warnings.isEmpty())
    }

    @Test
    fun nestingIsLimited() {
        val path = Files.writeString(folder.resolve("a.json"), """{"lazyz": 1, "surfaces": [[[[[]]]]]}""")
        val message = message(path, LoadLimits(nesting = 4))
        assertTrue("is nested more than 4 deep; if it can be trusted, raise LoadLimits.nesting" in message, message)
    }

    @Test
    fun aScenesMeshesAreCountedTogether() {
        Files.write(folder.resolve("square.obj"), squares.getValue("square.obj"))
        val twice = """{"lazyz": 1, "surfaces": [{"mesh": "square.obj"}, {"mesh": "./square.obj"}]}"""
        val path = Files.writeString(folder.resolve("a.json"), twice)
        assertEquals(2, Scenes.load(path, LoadLimits(triangles = 4)).scene.surfaces.size)
        assertTrue("--max-triangles" in message(path, LoadLimits(triangles = 3)))
    }

    @Test
    fun pointsAndSegmentsAreCounted() {
        val points = """{"points": {"positions": [0, 0, 0, 1, 0, 0]}}"""
        val lines = """{"lines": {"positions": [0, 0, 0, 1, 0, 0], "segments": [0, 1, 1, 0, 0, 1]}}"""
        val path = Files.writeString(folder.resolve("a.json"), """{"lazyz": 1, "surfaces": [$points, $lines]}""")
        assertEquals(2, Scenes.load(path, LoadLimits(triangles = 3, vertices = 4)).scene.surfaces.size)
        assertTrue("--max-triangles" in message(path, LoadLimits(triangles = 2)))
        assertTrue("--max-vertices" in message(path, LoadLimits(vertices = 3)))
        Files.writeString(folder.resolve("a.obj"), "v 0 0 0\nv 1 0 0\nl 1 2 1 2\np 1 2\n")
        assertEquals(2, Scenes.load(folder.resolve("a.obj"), LoadLimits(triangles = 3)).scene.surfaces.size)
        assertTrue("--max-triangles" in message(folder.resolve("a.obj"), LoadLimits(triangles = 2)))
    }

    @Test
    fun filesOutsideAreReadOnlyIfThatIsAllowed() {
        val inner = Files.createDirectory(folder.resolve("inner"))
        Files.write(folder.resolve("square.obj"), squares.getValue("square.obj"))
        val text = """{"lazyz": 1, "surfaces": [{"mesh": "../square.obj"}]}"""
        val path = Files.writeString(inner.resolve("a.json"), text)
        val message = message(path, LoadLimits())
        assertTrue("lies outside $inner" in message && "--allow-outside" in message, message)
        val loaded = Scenes.load(path, LoadLimits(references = ReferencePolicy.ANYWHERE))
        assertEquals(1, loaded.scene.surfaces.size)
    }

    @Test
    fun pipesAndDevicesAreRefusedAtOnce() {
        val pipe = folder.resolve("pipe.obj")
        assumeTrue(ProcessBuilder("mkfifo", pipe.toString()).start().waitFor() == 0, "no pipes with names here")
        val refused = "$pipe: is a pipe or a device, not a file; send its bytes as a stream"
        assertEquals(refused, message(pipe, LoadLimits()))
        val path = Files.writeString(folder.resolve("a.json"), """{"lazyz": 1, "surfaces": [{"mesh": "pipe.obj"}]}""")
        assertTrue("pipe.obj is missing" in message(path, LoadLimits()))
    }

    @Test
    fun limitsThatMakeNoSenseAreRefused() {
        for (make in listOf({
            LoadLimits(triangles = -1)
        }, { LoadLimits(nesting = 0) }, { LoadLimits(nesting = 1001) })) {
            assertThrows(IllegalArgumentException::class.java) { make() }
        }
    }

    private fun message(path: Path, limits: LoadLimits): String =
        assertThrows(SceneFormatException::class.java) { Scenes.load(path, limits) }.message.orEmpty()

    /** A triangle with as many materials as there are [textures]. */
    private fun obj(vararg textures: String): Path {
        val materials = textures.withIndex().joinToString("\n") { (i, texture) -> "newmtl m$i\nmap_Kd $texture" }
        Files.writeString(folder.resolve("a.mtl"), materials)
        val faces = textures.indices.joinToString("\n") { "usemtl m$it\nf 1/1 2/1 3/1" }
        return Files.writeString(folder.resolve("a.obj"), "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n$faces\n")
    }

    private companion object {
        /** A square of two triangles in each format. */
        val squares: Map<String, ByteArray> = mapOf(
            "square.obj" to "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n",
            "square.stl" to "solid s\n" + listOf("0 0 0,1 0 0,1 1 0", "0 0 0,1 1 0,0 1 0").joinToString("") { corners ->
                "facet normal 0 0 1\nouter loop\n" + corners.split(',').joinToString("") { "vertex $it\n" } +
                    "endloop\nendfacet\n"
            } + "endsolid s\n",
            "square.ply" to "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n" +
                "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n" +
                "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n",
            "square.gltf" to """{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
                "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
                "accessors": [{"componentType": 5126, "count": 6, "type": "VEC3"}]}""",
            "square.json" to """{"lazyz": 1, "surfaces": [{"mesh": {"positions": [0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0],
                "triangles": [0, 1, 2, 0, 2, 3]}}]}""",
        ).mapValues { (_, text) -> text.toByteArray() }
    }
}
