package dev.lazyz.cli

import dev.lazyz.server.RenderServer
import dev.lazyz.server.ServerConfig
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.nio.file.Path
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.AfterAll
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/** The parameters of the render service mean the same as the options of `zcli render` with their names. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class RenderServiceTest {
    @TempDir
    lateinit var folder: Path

    @ParameterizedTest
    @ValueSource(
        strings = [
            "", "aa=1", "aa=8", "up=-z", "up=z", "background=transparent", "background=f80", "view=iso", "view=back",
            "azimuth=12.5&elevation=-30", "view=top&azimuth=5", "projection=orthographic", "margin=20", "zoom=2.5",
            "light=three-point", "light=flat", "light=sun&light-intensity=1.5", "light-intensity=0.5",
        ],
    )
    fun parametersMeanTheSameAsOptions(query: String) {
        val options = query.split('&').filter { it.isNotEmpty() }.map { "--$it" }.toTypedArray()
        val dark = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
            "property uchar red\nproperty uchar green\nproperty uchar blue\nelement face 1\n" +
            "property list uchar int vertex_indices\nend_header\n" +
            "0 0 0 20 9 9\n1 0 0 9 20 9\n0 1 0.5 9 9 20\n3 0 1 2\n"
        val facet = "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 1\nendloop\n" +
            "endfacet\nendsolid\n"
        val models = listOf(
            folder.wedge(),
            folder.resolve("a.stl").apply { writeText(facet) },
            folder.resolve("a.ply").apply { writeText(dark) },
        )
        for (model in models) {
            val picture = zcli("render", model, "-o", "-", "--size", "40x30", *options).output
            val request = HttpRequest.newBuilder(URI("http://127.0.0.1:${server.port}/render?size=40x30&$query"))
                .POST(HttpRequest.BodyPublishers.ofByteArray(model.readBytes()))
                .build()
            val answer = HttpClient.newHttpClient().send(request, HttpResponse.BodyHandlers.ofByteArray())
            assertEquals(200, answer.statusCode()) { answer.body().decodeToString() }
            assertArrayEquals(picture, answer.body()) { "$model with $query" }
        }
    }

    private companion object {
        val server = RenderServer(ServerConfig(port = 0, log = {})).start()

        @AfterAll
        @JvmStatic
        fun close() = server.close()
    }
}
