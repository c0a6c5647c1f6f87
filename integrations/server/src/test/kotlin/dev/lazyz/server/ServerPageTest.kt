package dev.lazyz.server

import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `docs/server.md` describes every parameter, option and metric, and no others. */
class ServerPageTest {
    private val page = generateSequence(Path.of("").toAbsolutePath()) { it.parent }
        .map { it.resolve("docs/server.md") }.first { it.exists() }.readText()

    private fun found(pattern: String) = Regex(pattern).findAll(page).map { it.groupValues[1] }.toSet()

    @Test
    fun options() {
        val own = setOf("--version", "--help", "--data-binary")
        assertEquals(ServerOptions.options.map { it.name }.toSet(), found("(--[a-z][a-z-]+)\\b") - own)
        for (option in ServerOptions.options) assertTrue("`${option.name} ${option.form}`" in page, option.name)
    }

    @Test
    fun code() {
        RenderServer(ServerConfig(port = 0, queue = 16)).start().use { server ->
            println("http://127.0.0.1:${server.port}/")
        }
    }

    @Test
    fun metrics() = RenderServer(ServerConfig(port = 0, log = {})).start().use { server ->
        Client(server).get("/")
        Client(server).await("lazyz_requests_open", 0)
        val types = Regex("(?m)^# TYPE (\\S+)").findAll(server.metrics()).map { it.groupValues[1] }.toSet()
        val described = found("`((?:lazyz|jvm)_[a-z_]+)")
        assertEquals(types.filterNot { "memory_max" in it && it.startsWith("lazyz") }.toSet(), described)
    }
}
