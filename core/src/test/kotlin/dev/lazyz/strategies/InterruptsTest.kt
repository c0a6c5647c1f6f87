package dev.lazyz.strategies

import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Spans
import java.nio.file.Path
import kotlin.io.path.readLines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

/** The table of `docs/guides/servlet.md` says what each built-in renderer does when it is interrupted. */
class InterruptsTest {
    private val raster = Raster(32, 24)

    /** Primitives that cover the raster. The first one that is asked for a row interrupts the thread. */
    private inner class Walls {
        private val all = List(WALLS) { Wall(it) }
        var isInterrupted = false
        val askedLater = HashSet<Int>()
        val frame = Frame(raster, all)

        private inner class Wall(private val number: Int) : Primitive {
            override val rowStart = 0
            override val rowEnd = raster.height
            override val columnStart = 0
            override val columnEnd = raster.width

            override fun spans(y: Int, spans: Spans) {
                if (isInterrupted) askedLater += number
                if (!isInterrupted) Thread.currentThread().interrupt()
                isInterrupted = true
                spans.add(0, raster.width)
            }

            override fun depth(x: Int, y: Int) = 1000 + number

            override fun shade(fragment: Fragment) = fragment.setColor(1f, 1f, 1f)
        }
    }

    private fun observed(renderer: Renderer): String {
        val walls = Walls()
        var rows = 0
        val hasThrown = try {
            renderer.configured(RenderOptions(threads = 1)).render(walls.frame) { _, _, _, _ -> rows++ }
            false
        } catch (_: InterruptedException) {
            true
        }
        assertEquals(!hasThrown, Thread.interrupted(), "interrupt status after ${renderer.id}")
        return when {
            !hasThrown && rows == raster.height -> "completes the picture; the interrupt status stays set"
            rows == 1 -> "ends at the next row"
            rows == 0 && walls.askedLater.size < 2 -> "ends at the next primitive or row"
            rows == 0 && walls.askedLater.size == WALLS -> "paints all primitives, then ends at its first row"
            else -> "another way: thrown $hasThrown, $rows rows, primitives asked later ${walls.askedLater}"
        }
    }

    @Test
    fun theTableOfInterruptsIsTrue() {
        val row = Regex("""\| (`.*`) \| (.*) \|""")
        val table = Path.of("../docs/guides/servlet.md").readLines().mapNotNull { row.matchEntire(it)?.destructured }
            .flatMap { (names, text) -> names.split(", ").map { it.trim('`') to text } }
        val found = Renderers.builtIn.map { it.id to observed(it) }
        assertEquals(found.toMap(), table.toMap())
    }

    private companion object {
        const val WALLS = 10
    }
}
