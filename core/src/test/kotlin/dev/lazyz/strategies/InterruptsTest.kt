package dev.lazyz.strategies

import dev.lazyz.Capability
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Renderer
import dev.lazyz.Selector
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Spans
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.EnumSource

/** An interrupt ends each built-in renderer after little more work. Here work is calls of the primitives. */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class InterruptsTest {
    private val raster = Raster(SIDE, SIDE)

    /**
     * The kinds of calls, and how many may follow an interrupt. A strategy may finish a row of a band, or of a tile.
     */
    enum class Call(val most: Int) {
        SPANS(BAND),
        DEPTH(BAND * SIDE),
        SHADE(1),
        SELECT(0),
        ROW(0),
    }

    /**
     * A frame of primitives that cover the raster, the farthest first. It interrupts its thread in call number [moment]
     * of the kind [kind], and counts what follows.
     */
    private class Walls(raster: Raster, isTranslucent: Boolean, private val kind: Call, private val moment: Int) {
        private val calls = IntArray(Call.entries.size)
        private val after = IntArray(Call.entries.size)
        private var isInterrupted = false
        val frame = Frame(raster, List(WALLS) { Wall(it, isTranslucent) })

        fun count(call: Call) {
            if (isInterrupted) after[call.ordinal]++
            if (call != kind || ++calls[call.ordinal] != moment) return
            isInterrupted = true
            Thread.currentThread().interrupt()
        }

        fun excess(): List<String> {
            assertTrue(isInterrupted, "$kind was called ${calls[kind.ordinal]} times")
            return Call.entries.filter { after[it.ordinal] > it.most }.map { "$it: ${after[it.ordinal]}" }
        }

        /** Its depth is no linear form, so it is evaluated sample by sample. */
        private inner class Wall(private val number: Int, override val isTranslucent: Boolean) : Primitive {
            override val rowStart = 0
            override val rowEnd = SIDE
            override val columnStart = 0
            override val columnEnd = SIDE

            override fun spans(y: Int, spans: Spans) {
                count(Call.SPANS)
                spans.add(0, SIDE)
            }

            override fun depth(x: Int, y: Int): Int {
                count(Call.DEPTH)
                return 1_000_000 - 1000 * number + x * y % 7
            }

            override fun shade(fragment: Fragment) {
                count(Call.SHADE)
                fragment.setColor(1f, 1f, 1f, if (isTranslucent) 0.001f else 1f)
            }
        }
    }

    private fun assertEnds(renderer: Renderer, isTranslucent: Boolean, kind: Call, moment: Int) {
        val what = "${renderer.id}, $kind $moment, translucent: $isTranslucent"
        val walls = Walls(raster, isTranslucent, kind, moment)
        val selector = if (kind == Call.SELECT) Selector { walls.count(kind) } else null
        val configured = renderer.configured(RenderOptions(threads = 1, selector = selector))
        assertThrows(InterruptedException::class.java, {
            configured.render(walls.frame) { _, _, _, _ -> walls.count(Call.ROW) }
        }, what)
        assertFalse(Thread.interrupted(), what)
        assertEquals(emptyList<String>(), walls.excess(), what)
    }

    @ParameterizedTest
    @EnumSource
    fun littleFollowsAnInterrupt(kind: Call) {
        for (renderer in Renderers.builtIn) {
            if (kind == Call.SELECT && Capability.SELECTION !in renderer.capabilities) continue
            for (moment in if (kind == Call.ROW) listOf(70) else listOf(1, 70)) {
                assertEnds(renderer, isTranslucent = false, kind, moment)
                if (Capability.TRANSPARENCY !in renderer.capabilities) continue
                assertEnds(renderer, isTranslucent = true, kind, moment)
            }
        }
    }

    @Test
    fun whoIsInterruptedBeforehandGetsNothing() {
        for (renderer in Renderers.builtIn) {
            val walls = Walls(raster, isTranslucent = false, Call.ROW, 1)
            Thread.currentThread().interrupt()
            assertThrows(InterruptedException::class.java, {
                renderer.render(walls.frame) { _, _, _, _ -> walls.count(Call.ROW) }
            }, renderer.id)
            assertFalse(Thread.interrupted(), renderer.id)
        }
    }

    private companion object {
        const val WALLS = 20
        const val SIDE = 130

        /** Most rows of a band or of a tile. */
        const val BAND = 64
    }
}
