package dev.lazyz.cli.page

import dev.lazyz.cli.gifFrames
import dev.lazyz.cli.trace.FilmPanel
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.readText
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.BeforeEach
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.CsvSource

/** Pages of `zcli` in a browser, on phones and desktops: nothing is loaded, too wide or broken. */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class PagesInBrowserTest {
    @TempDir
    lateinit var folder: Path

    private lateinit var browser: Browser

    /** Before pages are made, which would be in vain without a browser. */
    @BeforeEach
    fun find() {
        browser = Browser(folder)
    }

    private val size = arrayOf("--size", "200x150")

    private fun report(): String {
        zcli("report", "city", "-o", folder.resolve("a.html"), "--repeat", "1", *size).done()
        return folder.resolve("a.html").readText()
    }

    private fun trace(name: String) {
        val film = arrayOf("--strategy", "zbuffer,lazy", "--steps", "8")
        zcli("trace", "city", "-o", folder.resolve(name), *film, *size).done()
    }

    private fun film(): String {
        trace("a.html")
        return folder.resolve("a.html").readText()
    }

    private fun requireSound(page: String, width: Int) {
        val visit = browser.visit(
            page,
            width,
            """
            const loaded = [];
            for (const image of doc.querySelectorAll("symbol image")) {
              const copy = new Image();
              copy.src = image.getAttribute("href");
              await copy.decode();
              loaded.push(copy.naturalWidth);
            }
            const wide = [...doc.querySelectorAll("main *")].filter((part) => !part.closest(".scroll table")
              && part.getBoundingClientRect().right > view.innerWidth + 1);
            return {
              viewport: view.innerWidth, width: doc.documentElement.scrollWidth, loaded,
              wide: wide.map((part) => part.outerHTML.slice(0, 80)),
              hidden: [...doc.querySelectorAll("svg.picture")].filter((part) => part.clientHeight < 50).length,
              requests: view.performance.getEntriesByType("resource").map((entry) => entry.name)
                .filter((name) => !name.startsWith("data:")),
            };
            """,
        )
        assertEquals(emptyList<String>(), visit.console)
        val facts = visit.facts
        assertEquals(width, facts.getValue("viewport").jsonPrimitive.int)
        assertEquals(width, facts.getValue("width").jsonPrimitive.int, "scrolls sideways")
        assertEquals(JsonArray(emptyList()), facts["wide"])
        assertEquals(0, facts.getValue("hidden").jsonPrimitive.int, "pictures are not visible")
        assertEquals(JsonArray(emptyList()), facts["requests"])
        val pictures = Html(page).pictures.values.map { it.width }
        assertEquals(pictures, facts.getValue("loaded").jsonArray.map { it.jsonPrimitive.int })
    }

    @ParameterizedTest
    @CsvSource("390", "1280")
    fun aReportIsSound(width: Int) = requireSound(report(), width)

    @ParameterizedTest
    @CsvSource("390", "1280")
    fun aFilmIsSound(width: Int) = requireSound(film(), width)

    @ParameterizedTest
    @CsvSource("390", "1280")
    fun changesAreSound(width: Int) {
        zcli("diff", "teapot", "city", "-o", folder.resolve("a.html"), *size)
        requireSound(folder.resolve("a.html").readText(), width)
    }

    /** Each step has as many grey and pink pixels as the picture of the GIF, and the keys and buttons work. */
    @Test
    fun aFilmShowsTheStepsOfTheGif() {
        val page = film()
        trace("a.gif")
        val expected = folder.resolve("a.gif").gifFrames().take(8).map { frame ->
            listOf(0 until 200, 208 until 408).flatMap { columns ->
                listOf(FilmPanel.WAITING, FilmPanel.DISCARDED).map { color ->
                    columns.sumOf { x -> (0 until 150).count { y -> frame.getRGB(x, y) == color } }
                }
            }
        }
        val facts = browser.visit(
            page,
            800,
            """
            while (doc.querySelector(".controls").hidden) await pause(20);
            const slider = doc.getElementById("step");
            const count = () => [...doc.querySelectorAll("canvas")].flatMap((canvas) => {
              const data = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data;
              let [grey, pink] = [0, 0];
              for (let i = 0; i < data.length; i += 4) {
                if (data[i + 3] === 255 && data[i] === 200 && data[i + 1] === 200) grey++;
                if (data[i + 3] === 255 && data[i] === 255 && data[i + 1] === 20) pink++;
              }
              return [grey, pink];
            });
            const last = doc.querySelector("figcaption").textContent;
            const go = (step) => { slider.value = step; slider.dispatchEvent(new view.Event("input")); };
            const forward = [];
            go(0);
            const begin = count();
            for (let step = 1; step <= 8; step++) { doc.getElementById("forward").click(); forward.push(count()); }
            const end = doc.querySelector("figcaption").textContent;
            doc.getElementById("back").click();
            const before = count();
            go(8);
            const play = doc.getElementById("play");
            play.click();
            const playing = play.textContent;
            for (let i = 0; i < 100 && play.textContent !== "Play"; i++) await pause(50);
            return { begin, forward, before, last, end, playing, paused: play.textContent, step: slider.value,
              aria: slider.getAttribute("aria-valuetext"), shown: doc.getElementById("shown").textContent };
            """,
        ).facts
        fun numbers(key: String) = facts.getValue(key).jsonArray.map { it.jsonPrimitive.int }
        fun text(key: String) = facts.getValue(key).jsonPrimitive.content
        assertEquals(
            expected,
            facts.getValue("forward").jsonArray.map { s ->
                s.jsonArray.map { it.jsonPrimitive.int }
            }
        )
        val (greyLeft, pinkLeft, greyRight, pinkRight) = numbers("begin")
        assertEquals(greyLeft to 0, greyRight to pinkLeft + pinkRight)
        assertTrue(greyLeft > 10_000)
        assertEquals(expected[6], numbers("before"), "backward")
        assertEquals(text("last"), text("end"))
        assertTrue(Regex("""[\d,]+ calls, [\d,]+ discarded""").matches(text("last")), text("last"))
        assertEquals(listOf("Pause", "Play", "8"), listOf("playing", "paused", "step").map { text(it) })
        assertEquals(listOf("step 8 of 8", "step 8 of 8"), listOf("aria", "shown").map { text(it) })
    }
}
