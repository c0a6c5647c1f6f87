package dev.lazyz.mcp

import dev.lazyz.Counters
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.scenes.pictures.CutPlane
import dev.lazyz.scenes.pictures.Picture
import dev.lazyz.scenes.pictures.PictureParameters
import dev.lazyz.scenes.pictures.PictureSettings
import dev.lazyz.scenes.writers.toPng
import dev.lazyz.strategies.tiled.TiledRenderer
import io.modelcontextprotocol.client.McpClient
import io.modelcontextprotocol.client.McpSyncClient
import io.modelcontextprotocol.client.transport.ServerParameters
import io.modelcontextprotocol.client.transport.StdioClientTransport
import io.modelcontextprotocol.json.McpJsonDefaults
import io.modelcontextprotocol.json.schema.JsonSchemaValidator
import io.modelcontextprotocol.spec.McpSchema
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import java.util.Base64
import java.util.concurrent.TimeUnit
import kotlin.io.path.createDirectory
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The program in a process of its own, through its pipes. */
class McpTest {
    @TempDir
    lateinit var place: Path

    private val folder by lazy { place.resolve("models").createDirectory() }

    @BeforeEach
    fun writeModel() = folder.resolve("cube.obj").writeText(cube(1.0))

    @Test
    fun aClientSeesModels() = client { client ->
        assertEquals("lazyz-mcp", client.serverInfo.name())
        val tools = client.listTools().tools().associateBy { it.name() }
        assertEquals(setOf("render", "compare", "measure", "pick"), tools.keys)
        val properties = tools.getValue("render").inputSchema()["properties"] as Map<*, *>
        val table = PictureParameters.all.map { it.name }
        assertEquals(listOf("file", "views", "drawing") + table, properties.keys.toList())
        assertEquals(listOf(1, 2, 4, 8).map { "$it" }, PictureParameters.AA.values.words.toList())
        assertEquals("number", (properties["aa"] as Map<*, *>)["type"])

        // The picture, a cut, and the side that the camera of a result shows
        val usual = PictureSettings()
        val picture = client.call("render", "file" to "cube.obj")
        assertEquals(hash(usual), picture.data["pixelHash"])
        assertEquals(listOf(false, false), listOf(picture.data["blank"], picture.data["cropped"]))
        assertEquals("Picture(640 x 480)", "${Picture.decode(picture.png())}")
        val cut = client.call("render", "file" to "cube.obj", "cut" to listOf("x=25%"), "aa" to 2, "up" to "z")
        val planes = listOf(CutPlane.parse("x=25%")!!)
        val chosen = usual.with(PictureParameters.CUT, planes).with(PictureParameters.AA, 2)
        assertEquals(hash(chosen.withWord(PictureParameters.UP, "z")), cut.data["pixelHash"])
        val seen = (picture.data["camera"] as Map<*, *>).map { "${it.key}" to it.value }.toTypedArray()
        val again = client.call("render", "file" to "cube.obj", *seen)
        assertEquals(picture.data["pixelHash"], again.data["pixelHash"])

        val away = client.call("render", "file" to "cube.obj", "eye" to "9,0,0", "target" to "20,0,0")
        assertEquals(listOf(true, true), listOf(away.data["blank"], away.data["cropped"]))
        val sheet = client.call("render", "file" to "cube.obj", "views" to "front,top", "size" to "64")
        assertEquals(setOf("front", "top"), (sheet.data["views"] as Map<*, *>).keys)
        val drawing = client.call("render", "file" to "cube.obj", "drawing" to true, "style" to "technical")
        val resource = (drawing.content()[0] as McpSchema.EmbeddedResource).resource()
        val svg = (resource as McpSchema.TextResourceContents).text()
        assertTrue("<svg" in svg && drawing.data["blank"] == false && drawing.data["lines"] == 6, "${drawing.data}")
    }

    @Test
    fun aClientMeasuresAndCompares() = client { client ->
        folder.resolve("large.obj").writeText(cube(2.0))
        val numbers = client.call("measure", "file" to "large.obj").data["numbers"] as Map<*, *>
        assertEquals(
            listOf(64.0, 96.0, -2.0, 12, 1, 0, 1, 0),
            listOf("volume", "area", "minX", "triangles", "parts", "openEdges", "shells", "holes").map { numbers[it] },
        )
        val compared = client.call("compare", "old" to "cube.obj", "new" to "large.obj", "size" to "64")
        assertEquals(3, compared.content().count { it is McpSchema.ImageContent })
        assertEquals(listOf(8.0, 64.0, 56.0), (compared.data["numbers"] as Map<*, *>)["volume"])
        val hit = client.call("pick", "file" to "cube.obj", "x" to 32, "y" to 32, "size" to "64", "view" to "front")
        assertEquals(1.0, (hit.data["position"] as List<*>)[2] as Double, 1e-3)
        val miss = client.call("pick", "file" to "cube.obj", "x" to 0, "y" to 0)
        assertEquals(false, miss.data["hit"])
    }

    @Test
    fun whatIsOutsideOrTooLargeIsRefused() = client { client ->
        place.resolve("secret.obj").writeText(cube(1.0))
        place.resolve("secret.png").writeBytes(PNG)
        Files.createSymbolicLink(folder.resolve("link.obj"), place.resolve("secret.obj"))
        for (name in listOf("../secret.obj", "link.obj", "${place.resolve("secret.obj")}")) {
            assertEquals("'$name' is outside of the folder of this server", client.refusal("file" to name))
        }
        val texture = client.refusal("file" to "cube.obj", "matcap" to "../secret.png")
        assertEquals("'../secret.png' is outside of the folder of this server", texture)
        folder.resolve("evil.obj").writeText("mtllib evil.mtl\n${cube(1.0).replace("f ", "usemtl m\nf ")}")
        folder.resolve("evil.mtl").writeText("newmtl m\nmap_Kd ../secret.png\n")
        val left = client.call("render", "file" to "evil.obj").data["warnings"] as List<*>
        assertTrue("texture ../secret.png lies outside" in "$left", "$left")

        folder.resolve("bomb.gltf").writeText(BOMB)
        val bomb = client.refusal("file" to "bomb.gltf")
        assertTrue(bomb.startsWith("bomb.gltf, accessors[0].count: 2000000000 elements"), bomb)
        folder.resolve("bomb.json").writeText("""{"lazyz": 1, "size": [90000, 90000], "surfaces": []}""")
        val size = client.refusal("file" to "bomb.json", "format" to "scene")
        assertTrue("pixels in all: 90000x90000" in size, size)
        val wrong = client.refusal("file" to "cube.obj", "azimut" to 3)
        assertTrue(wrong.startsWith("there is no parameter 'azimut'; there are file, "), wrong)
        assertEquals(
            "cut: a list has no lists",
            client.refusal(
                "file" to "cube.obj",
                "cut" to listOf(SLOW.toList())
            )
        )
    }

    @Test
    fun whatTakesTooLongIsCancelled() = client(seconds = 1) { client ->
        assertEquals("this takes more than 1 s; choose a smaller picture, aa or model", client.refusal(*SLOW))
    }

    /** After a cancellation comes no answer, and the next request has its turn; with the pipe, the process ends. */
    @Test
    fun requestsAreCancelledAndTheProcessEndsWithItsInput() {
        val words = command(600)
        val process = ProcessBuilder(words).redirectError(place.resolve("errors").toFile()).start()
        val input = process.outputStream.bufferedWriter()
        val output = process.inputStream.bufferedReader()

        fun send(text: String) {
            input.write("$text\n")
            input.flush()
        }

        fun call(id: Int) {
            val arguments = McpJsonDefaults.getMapper().writeValueAsString(SLOW.toMap())
            send(request(id, "tools/call", """{"name": "render", "arguments": $arguments}"""))
        }
        send(request(0, "initialize", INITIALIZE))
        assertTrue("lazyz-mcp" in output.readLine())
        send("""{"jsonrpc": "2.0", "method": "notifications/initialized"}""")
        send("""{"jsonrpc": """)
        assertTrue("-32700" in output.readLine())
        send(request(1, "tools/call", "[1]"))
        assertTrue(""""the parameters are invalid"""" in output.readLine())
        call(2)
        send("""{"jsonrpc": "2.0", "method": "notifications/cancelled", "params": {"requestId": 2}}""")
        send(request(3, "tools/call", """{"name": "measure", "arguments": {"file": "cube.obj"}}"""))
        assertTrue(""""id":3""" in output.readLine())
        call(4)
        input.close()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES))
        assertEquals(0, process.exitValue())
        assertEquals("", place.resolve("errors").toFile().readText())
    }

    private fun client(seconds: Int = 600, use: (McpSyncClient) -> Unit) {
        val words = command(seconds)
        val server = ServerParameters.builder(words[0]).args(words.drop(1)).build()
        val client = McpClient.sync(StdioClientTransport(server, McpJsonDefaults.getMapper()))
            .jsonSchemaValidator { _, _ -> JsonSchemaValidator.ValidationResponse.asValid(null) }
            .initializationTimeout(PATIENCE).requestTimeout(PATIENCE).build()
        client.use {
            it.initialize()
            use(it)
        }
    }

    private fun command(seconds: Int): List<String> {
        val classPath = System.getProperty("java.class.path").split(File.pathSeparator)
            .joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val options = listOf("-Xmx512m", "-XX:TieredStopAtLevel=1", "-cp", classPath, "dev.lazyz.mcp.MainKt")
        return listOf(java) + options + listOf("$folder", "--max-seconds=$seconds")
    }

    private fun hash(settings: PictureSettings): String =
        settings.frame(Scenes.load(folder.resolve("cube.obj"))).render(TiledRenderer()).pixelHash()

    private fun McpSyncClient.call(tool: String, vararg arguments: Pair<String, Any?>): McpSchema.CallToolResult {
        val result = callTool(McpSchema.CallToolRequest.builder(tool).arguments(arguments.toMap()).build())
        assertFalse(result.isError) { "${result.content()}" }
        return result
    }

    private fun McpSyncClient.refusal(vararg arguments: Pair<String, Any?>): String {
        val result = callTool(McpSchema.CallToolRequest.builder("render").arguments(arguments.toMap()).build())
        assertTrue(result.isError)
        return (result.content().single() as McpSchema.TextContent).text()
    }

    private val McpSchema.CallToolResult.data get() = structuredContent() as Map<*, *>

    private fun McpSchema.CallToolResult.png(): ByteArray =
        Base64.getDecoder().decode((content()[0] as McpSchema.ImageContent).data())

    private companion object {
        val PATIENCE: Duration = Duration.ofMinutes(10)
        val SLOW = arrayOf("file" to "cube.obj", "size" to "1800x1800", "aa" to 8, "ambient-occlusion" to true)
        const val INITIALIZE =
            """{"protocolVersion": "2025-06-18", "capabilities": {}, "clientInfo": {"name": "test", "version": "1"}}"""

        /** A picture of one pixel. */
        val PNG: ByteArray = Image(
            Region(0, 0, 1, 1), intArrayOf(-1), intArrayOf(0), intArrayOf(0), Counters.NONE,
        ).toPng()

        /** A few bytes that ask for 24 GB. */
        const val BOMB = """{"asset": {"version": "2.0"},
            "scene": 0, "scenes": [{"nodes": [0]}], "nodes": [{"mesh": 0}],
            "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"componentType": 5126, "count": 2000000000, "type": "VEC3"}]}"""

        fun request(id: Int, method: String, params: String) =
            """{"jsonrpc": "2.0", "id": $id, "method": "$method", "params": $params}"""

        /** An OBJ file of a cube around the origin, [half] of whose side is given. */
        fun cube(half: Double): String {
            val corners = (0 until 8).joinToString("") { corner ->
                "v " + (0 until 3).joinToString(" ") { "${if (corner shr it and 1 == 0) -half else half}" } + "\n"
            }
            return corners + "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"
        }
    }
}
