package dev.lazyz.cli.trace

import dev.lazyz.cli.gifFrames
import dev.lazyz.cli.image
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** `zcli trace`. */
class TraceTest {
    @TempDir
    lateinit var folder: Path

    private fun file(name: String): Path = folder.resolve(name)

    private fun trace(input: Any, output: String, vararg options: Any) =
        zcli("trace", input, "-o", file(output), "--size", "240x160", "--steps", "8", *options)

    private fun pictures(name: String): List<BufferedImage> = file(name).gifFrames()

    private fun BufferedImage.count(color: Int, columns: IntRange = 0 until 240): Int =
        columns.sumOf { x -> (0 until 160).count { y -> getRGB(x, y) == color } }

    @Test
    fun thePictureFillsRowByRow() {
        val text = trace("city", "city.gif", "--strategy", "lazy").done().text
        assertTrue(Regex("""lazy: [\d,]+ shading calls, 0 of them discarded\n""").matches(text), text)
        val film = pictures("city.gif")
        assertEquals(8 + 12, film.size, "steps, and a second")
        val waiting = film.map { it.count(FilmPanel.WAITING) }
        assertEquals(waiting.sortedDescending(), waiting)
        assertEquals(0, waiting[7])
        assertTrue(waiting[3] > 0)
        assertTrue(film.all { it.count(FilmPanel.DISCARDED) == 0 })

        // Half of the calls are made, above
        assertTrue((0 until 240).none { film[3].getRGB(it, 0) == FilmPanel.WAITING })
        assertTrue((0 until 240).any { film[3].getRGB(it, 159) == FilmPanel.WAITING })
    }

    @Test
    fun theLastPictureIsThatOfRender() {
        trace("teapot", "t.png", "--strategy", "zbuffer", "--view", "top", "--color", "tomato").done()
        trace("teapot", "t.gif", "--strategy", "zbuffer", "--view", "top", "--color", "tomato").done()
        zcli(
            "render", "teapot", "--aa", "1", "--size", "240x160", "-o", file("r.png"), "--view", "top",
            "--color", "tomato",
        ).done()
        val rendered = file("r.png").image
        val last = pictures("t.gif").last()
        val near = (0 until 160).all { y ->
            (0 until 240).all { x ->
                listOf(16, 8, 0).all { shift ->
                    val a = rendered.getRGB(x, y) shr shift and 0xFF
                    val b = last.getRGB(x, y) shr shift and 0xFF
                    kotlin.math.abs(a - b) <= 24
                }
            }
        }
        assertTrue(near)
        assertTrue(String(file("t.png").readBytes(), Charsets.ISO_8859_1).contains("acTL"))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun discardedCallsArePinkAndTwoStrategiesAreSideBySide() {
        val text = trace("city", "two.gif", "--strategy", "zbuffer,scanline").done().text
        val repeated = trace("city", "again.gif", "--strategy", "zbuffer", "--strategy", "scanline")
        assertEquals(text, repeated.done().text)
        assertEquals(listOf("zbuffer", "scanline"), text.lines().dropLast(1).map { it.substringBefore(':') })
        val film = pictures("two.gif")
        assertEquals(240 + 8 + 240, film[0].width)
        assertTrue(film.maxOf { it.count(FilmPanel.DISCARDED) } > 1000)
        assertTrue(film.all { it.count(FilmPanel.DISCARDED, 248 until 488) == 0 })

        // The same clock: scanline is ready while zbuffer still works
        val ready = film.indexOfFirst { it.count(FilmPanel.WAITING, 248 until 488) == 0 }
        assertTrue(ready in 1..5, "$ready")
        assertEquals(0, film.last().count(FilmPanel.DISCARDED))
    }

    @Test
    fun transparencyThatAFilmLosesCausesAWarning() {
        val run = trace("teapot", "t.gif", "--background", "transparent", "--steps", "2")
        assertTrue("zcli: warning: a film has no alpha" in run.errors, run.errors)
    }

    @Test
    fun mistakesAreReported() {
        trace("city", "a.jpg").mistake("-o must end in .gif or .png or .apng")
        trace("city", "a.gif", "--strategy", "lasy").mistake("no strategy 'lasy'; did you mean 'lazy'?")
        trace("city", "a.gif", "--strategy", "lazy,lazy").mistake("--strategy: 'lazy' is named twice")
        trace("city", "a.gif", "--strategy", "lazy,flow,tiled").mistake("one strategy or two")
        trace("city", "a.gif", "--threads", "2").mistake("--threads cannot be used here")
        trace("city", "a.gif", "--aa", "2").mistake("use --aa 1")
        trace("city", "a.gif", "--aa-filter", "mitchell", "--region", "9,9,9x9").mistake("--aa-filter box")
        trace("city", "a.gif", "--size", "262144").mistake("choose a smaller --size")
        trace("city", "a.gif", "--steps", "1000", "--size", "4000").mistake("and a film may use half of the")
        trace("city", "a.gif", "--size", "70000x1", "--steps", "2").mistake("a GIF has at most 65535", "a .png")
        trace("city", "a.gif", "--steps", "1").mistake("must be in 2..1000: 1")
        trace(file("none.obj"), "a.gif").mistake("none.obj")
        trace("city", "a.gif", "--strategy", "lazy", "--tile-size", "16").mistake("--tile-size")
        zcli("trace", "city").mistake("-o")
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun filmsOfTooManyCallsAreRefused() {
        // With 1000 steps both are too many: the film is refused before the calls are recorded
        val large = arrayOf("--size", "6000x6000", "--shading", "constant", "--strategy", "zbuffer")
        trace("layers", "a.png", *large).mistake("more than 16,777,216 shading calls")
        trace("layers", "a.gif", *large, "--steps", "1000").mistake("and a film may use half of the")
        for (name in listOf("a.gif", "a.png")) assertFalse(file(name).exists())
    }
}
