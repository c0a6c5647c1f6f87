package dev.lazyz.conformance.strangers2

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.conformance.strangers.Stranger
import java.util.concurrent.atomic.AtomicReference

private fun wrongBuffer(id: String, what: String, vararg chapters: String, steps: () -> BufferSteps): Stranger =
    Stranger(id, what, chapters.toSet()) { Buffered(steps()) }

/** Mistakes in a renderer with a buffer of the whole picture. */
internal fun bufferMistakes(): List<Stranger> = listOf(
    wrongBuffer("float-depths", "compares depths as floats: surfaces within 64 units tie", "4.1", "5.1") {
        object : BufferSteps() {
            override fun isVisible(pass: BufferPass, key: Long, old: Long): Boolean {
                val depth = (key ushr 32).toFloat()
                val other = (old ushr 32).toFloat()
                return depth < other || (depth == other && key.toInt() < old.toInt())
            }
        }
    },
    wrongBuffer("same-object", "what is submitted twice in a row has its first index, though the last may win", "5.3") {
        object : BufferSteps() {
            override fun drawAll(pass: BufferPass) {
                var last: Primitive? = null
                var first = 0
                for ((index, primitive) in pass.frame.primitives.withIndex()) {
                    if (primitive !== last) first = index
                    last = primitive
                    draw(pass, first, primitive)
                }
            }
        }
    },
    wrongBuffer("one-curved-span", "of what has no linear depth the first span of a row is drawn", "2.8", "2.6") {
        object : BufferSteps() {
            override fun spanCount(pass: BufferPass, primitive: Primitive): Int =
                if (primitive.depthForm == null) minOf(pass.spans.count, 1) else pass.spans.count
        }
    },
    wrongBuffer("uncleared-after-failure", "the buffer is kept, and not cleared where a shader throws", "7.1") {
        object : KeptBuffer() {
            override fun drawAll(pass: BufferPass) = try {
                super.drawAll(pass)
            } catch (e: RuntimeException) {
                keep(pass)
                throw e
            }

            override fun end(pass: BufferPass) {
                pass.clear()
                keep(pass)
            }
        }
    },
    wrongBuffer("four-at-a-time", "spans of 64 columns and more end at a multiple of four columns", "2.3") {
        object : BufferSteps() {
            override fun span(pass: BufferPass, index: Int, primitive: Primitive, y: Int, start: Int, end: Int) {
                val count = if (end - start < 64) end - start else (end - start) / 4 * 4
                super.span(pass, index, primitive, y, start, start + count)
            }
        }
    },
    wrongBuffer("background-of-the-test", "nothing is behind the background, wherever it lies", "4.3", "5.1") {
        object : BufferSteps() {
            override fun pass(frame: Frame): BufferPass {
                val pass = super.pass(frame)
                val isReversed = pass.test.key(1, 0) < pass.test.key(0, 0)
                val far = if (isReversed) 0 else Int.MAX_VALUE
                pass.keys.fill(pass.test.key(far, DepthTest.BACKGROUND))
                return pass
            }

            override fun depthOf(pass: BufferPass, key: Long): Int =
                if (pass.test.indexOf(key) >= 0) super.depthOf(pass, key) else pass.frame.raster.backgroundDepth
        }
    },
    wrongBuffer("within-the-planes", "depths are clamped to the near and the far plane's", "4.4", "2.8") {
        object : BufferSteps() {
            override fun sample(pass: BufferPass, index: Int, primitive: Primitive, x: Int, y: Int, depth: Int) =
                super.sample(pass, index, primitive, x, y, depth.coerceIn(Depth.NEAR, Depth.FAR))
        }
    },
    wrongBuffer("sorts-by-a-depth", "asks for the depth at the middle of bounds, where nothing may be", "9.4", "7.7") {
        object : BufferSteps() {
            override fun drawAll(pass: BufferPass) {
                val primitives = pass.frame.primitives
                val middles = IntArray(primitives.size) {
                    val one = primitives[it]
                    one.depth((one.columnStart + one.columnEnd) / 2, (one.rowStart + one.rowEnd) / 2)
                }
                for (index in primitives.indices.sortedBy { pass.test.key(middles[it], it) }) {
                    draw(pass, index, primitives[index])
                }
            }
        }
    },
    wrongBuffer("notes-each-primitive", "keeps a note of the bounds of each primitive until the end", "7.6") {
        object : BufferSteps() {
            override fun drawAll(pass: BufferPass) {
                val notes = ArrayList<IntArray>()
                for ((index, one) in pass.frame.primitives.withIndex()) {
                    notes.add(intArrayOf(one.rowStart, one.rowEnd, one.columnStart, one.columnEnd))
                    draw(pass, index, one)
                }
                pass.notes = notes
            }
        }
    },
    wrongBuffer("nearest-first-wins", "draws nearest first, and the first drawn wins a tie", "5.2") {
        object : BufferSteps() {
            override fun drawAll(pass: BufferPass) {
                val primitives = pass.frame.primitives
                val isReversed = pass.test.key(1, 0) < pass.test.key(0, 0)
                val order = primitives.indices.sortedBy {
                    val one = primitives[it]
                    pass.test.key(if (isReversed) one.greatestDepth else one.leastDepth, it)
                }
                for (index in order) draw(pass, index, primitives[index])
            }

            override fun isVisible(pass: BufferPass, key: Long, old: Long): Boolean {
                val isFirst = pass.test.key(0, 0) < pass.test.key(0, 1)
                val isBackground = pass.test.indexOf(old) == DepthTest.BACKGROUND
                return if (isFirst && !isBackground) key ushr 32 < old ushr 32 else key < old
            }
        }
    },
)

/** A buffer that is kept from one rendering to the next of the same size and background. */
private abstract class KeptBuffer : BufferSteps() {
    private val kept = AtomicReference<Kept?>()

    private class Kept(val keys: LongArray, val argb: IntArray, val key: Long, val color: Int)

    override fun pass(frame: Frame): BufferPass {
        val old = kept.getAndSet(null) ?: return super.pass(frame)
        val pass = BufferPass(frame, old.keys, old.argb)
        val isLike = old.keys.size == frame.width * frame.height && old.key == pass.backgroundKey &&
            old.color == frame.raster.background.toArgb()
        return if (isLike) pass else super.pass(frame)
    }

    fun keep(pass: BufferPass) =
        kept.set(Kept(pass.keys, pass.argb, pass.backgroundKey, pass.frame.raster.background.toArgb()))
}
