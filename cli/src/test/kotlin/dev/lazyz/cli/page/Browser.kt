package dev.lazyz.cli.page

import com.sun.net.httpserver.HttpServer
import dev.lazyz.scenes.html.Html.escaped
import java.io.File
import java.net.InetAddress
import java.net.InetSocketAddress
import java.nio.file.Path
import java.util.concurrent.CompletableFuture
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import java.util.concurrent.TimeoutException
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assumptions.assumeTrue

/**
 * Chromium without a window, which shows pages as a reader sees them. On machines without it, a test that makes an
 * instance is skipped.
 *
 * @param folder for its files
 */
internal class Browser(private val folder: Path) {
    private val program = NAMES.flatMap { name -> PLACES.map { it.resolve(name) } }.firstOrNull { it.exists() }

    init {
        assumeTrue(program != null, "there is no Chromium: none of $NAMES in $PLACES")
    }

    /**
     * What became of a page.
     *
     * @property facts what the probe returned
     * @property console what the browser wrote to its console
     */
    class Visit(val facts: JsonObject, val console: List<String>)

    /**
     * Shows [page] in a frame of [width] columns, and runs [probe] in it: statements of JavaScript that return an
     * object. They see `doc`, the document of the page, and `view`, its window, when it is loaded. The frame is there
     * because windows of Chromium are at least 500 columns wide.
     */
    fun visit(page: String, width: Int, probe: String): Visit {
        val answer = CompletableFuture<String>()
        val requests = ConcurrentLinkedQueue<String>()
        val server = HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), 0), 0)
        server.createContext("/") { exchange ->
            requests += "${exchange.requestMethod} ${exchange.requestURI}"
            val body = if (exchange.requestMethod == "GET") outer(page, width, probe) else ""
            val sent = exchange.requestBody.readAllBytes().decodeToString()
            exchange.responseHeaders.add("Content-Type", "text/html; charset=utf-8")
            exchange.sendResponseHeaders(200, 0)
            exchange.responseBody.use { it.write(body.toByteArray()) }
            if (exchange.requestMethod == "POST") answer.complete(sent)
        }
        server.start()
        val log = folder.resolve("console.txt")
        val process = ProcessBuilder(
            "$program", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
            "--user-data-dir=${folder.resolve("profile").createDirectories()}", "--enable-logging=stderr",
            "--window-size=1400,1000", "--hide-scrollbars", "http://127.0.0.1:${server.address.port}/",
        ).redirectErrorStream(true).redirectOutput(log.toFile()).start()
        try {
            val facts = Json.parseToJsonElement(answer.get(10, TimeUnit.MINUTES)).jsonObject
            assertEquals(null, facts["error"])
            assertEquals(listOf("GET /", "POST /answer"), requests.toList())
            return Visit(facts, log.readText().lines().filter { "CONSOLE" in it })
        } catch (late: TimeoutException) {
            throw AssertionError("no answer: ${log.readText()}", late)
        } finally {
            server.stop(0)
            process.destroy()
            process.waitFor(10, TimeUnit.SECONDS)
        }
    }

    private fun outer(page: String, width: Int, probe: String): String = """
        <!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,">
        <script>
        document.addEventListener("load", async ({ target: frame }) => {
          const doc = frame.contentDocument;
          const view = frame.contentWindow;
          const pause = (ms) => new Promise((go) => setTimeout(go, ms));
          let facts;
          try { facts = await (async () => { $probe })(); } catch (error) { facts = { error: String(error) }; }
          fetch("/answer", { method: "POST", body: JSON.stringify(facts) });
        }, true);
        </script>
        <iframe style="width:${width}px;height:900px;border:0" srcdoc="${escaped(page)}"></iframe>
    """.trimIndent()

    private companion object {
        val NAMES = listOf("chromium", "chromium-browser", "google-chrome", "chrome")
        val PLACES = System.getenv("PATH").orEmpty().split(File.pathSeparator).filter { it.isNotEmpty() }
            .map { Path.of(it) }
    }
}
