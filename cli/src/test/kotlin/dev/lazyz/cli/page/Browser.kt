package dev.lazyz.cli.page

import dev.lazyz.scenes.html.Html.escaped
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.absolute
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.readText
import kotlin.io.path.writeText
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.jsonObject
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue

/**
 * Chromium without a window, which shows pages as a reader sees them. Tests are skipped on machines without it.
 *
 * @param folder for its files
 */
internal class Browser(private val folder: Path) {
    /**
     * What became of a page.
     *
     * @property facts what the probe returned
     * @property console what the browser wrote to its console
     */
    class Visit(val facts: JsonObject, val console: List<String>)

    /**
     * Shows [page] in a frame of [width] columns, and runs [probe] in it: statements of JavaScript that return an object.
     * They see `doc`, the document of the page, and `view`, its window, when it is loaded. The frame is there because
     * windows of Chromium are at least 500 columns wide.
     */
    fun visit(page: String, width: Int, probe: String): Visit {
        val program = NAMES.flatMap { name -> PLACES.map { it.resolve(name) } }.firstOrNull { it.exists() }
        assumeTrue(program != null, "there is no Chromium: none of $NAMES in $PLACES")
        val outer = folder.resolve("outer.html").absolute()
        outer.writeText(
            """
            <!DOCTYPE html><meta charset="utf-8"><link rel="icon" href="data:,">
            <iframe style="width:${width}px;height:900px;border:0" srcdoc="${escaped(page)}"></iframe>
            <pre></pre>
            <script>
            const frame = document.querySelector("iframe");
            const report = (value) => document.querySelector("pre").textContent = JSON.stringify(value);
            frame.addEventListener("load", async () => {
              const doc = frame.contentDocument;
              const view = frame.contentWindow;
              const pause = (ms) => new Promise((go) => setTimeout(go, ms));
              try { report(await (async () => { $probe })()); } catch (error) { report({ error: String(error) }); }
              frame.remove();
            });
            </script>
            """.trimIndent(),
        )
        val log = folder.resolve("console.txt")
        val dom = folder.resolve("dom.html")
        val process = ProcessBuilder(
            "$program", "--headless=new", "--no-sandbox", "--disable-gpu", "--disable-background-networking",
            "--user-data-dir=${folder.resolve("profile").createDirectories()}", "--enable-logging=stderr",
            "--window-size=1400,1000", "--virtual-time-budget=20000", "--dump-dom", "${outer.toUri()}",
        ).redirectError(log.toFile()).redirectOutput(dom.toFile()).start()
        assertTrue(process.waitFor(120, TimeUnit.SECONDS).also { if (!it) process.destroyForcibly() }, "it hangs")
        val text = dom.readText().substringAfter("<pre>", "").substringBefore("</pre>")
        assertTrue(text.isNotEmpty(), "no answer: ${log.readText()}")
        val facts = Json.parseToJsonElement(text.replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&"))
        assertEquals(null, facts.jsonObject["error"])
        return Visit(facts.jsonObject, log.readText().lines().filter { "CONSOLE" in it })
    }

    private companion object {
        val NAMES = listOf("chromium", "chromium-browser", "google-chrome", "chrome")
        val PLACES = System.getenv("PATH").orEmpty().split(java.io.File.pathSeparator).filter { it.isNotEmpty() }
            .map { Path.of(it) }
    }
}
