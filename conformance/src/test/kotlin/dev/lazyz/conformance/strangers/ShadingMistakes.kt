package dev.lazyz.conformance.strangers

import dev.lazyz.Fragment
import dev.lazyz.Frame

/** Colours that are kept, shared or guessed. */
internal val shadingMistakes: List<Stranger> = listOf(
    Stranger(
        "color-of-run-ends",
        "a run of 12 and more whose ends have one colour gets that colour throughout; shows on textures and lights",
        setOf("6.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun colorRun(index: Int, y: Int, start: Int, end: Int) {
                    super.colorRun(index, y, start, end)
                    if (end - start >= 12 && argb[start] == argb[end - 1]) argb.fill(argb[start], start, end)
                }
            }
        }
    },
    Stranger(
        "color-of-level-primitive",
        "a primitive of constant depth has one colour for a run; shows on gradients and textures seen face on",
        setOf("6.1", "6.2"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun colorRun(index: Int, y: Int, start: Int, end: Int) {
                    super.colorRun(index, y, start, end)
                    val form = primitives[index].depthForm ?: return
                    if (form.dx == 0L && form.dy == 0L) argb.fill(argb[start], start, end)
                }
            }
        }
    },
    Stranger(
        "color-index-in-byte",
        "runs compare the low 8 bits of indices; neighbours whose indices differ by 256 share a colour",
        setOf("6.1", "7.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun isSameRun(first: Int, second: Int): Boolean = first and 0xFF == second and 0xFF &&
                    (first < 0) == (second < 0)
            }
        }
    },
    Stranger(
        "color-block-remainder",
        "shades in blocks of 8, of the rest but the first: the others of a run's rest get that colour",
        setOf("6.1"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun colorRun(index: Int, y: Int, start: Int, end: Int) {
                    super.colorRun(index, y, start, end)
                    val rest = (end - start) % 8
                    if (end - start > 8 && rest > 0) argb.fill(argb[end - rest], end - rest, end)
                }
            }
        }
    },
    Stranger(
        "color-run-stops-at-256",
        "a run of more than 256 samples goes on with the first column's attributes; shows on wide primitives",
        setOf("6.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun colorRun(index: Int, y: Int, start: Int, end: Int) {
                    super.colorRun(index, y, start, end)
                    for (i in start + 256 until end) argb[i] = argb[i - 256]
                }
            }
        }
    },
    Stranger(
        "color-linear-from-24",
        "runs of 24 and more are shaded at every eighth sample, with packed colours interpolated between",
        setOf("6.1", "6.4"),
    ) {
        tiles { frame, size -> InterpolatedTiles(frame, size) }
    },
    Stranger(
        "color-of-primitive-above",
        "a visible sample below a sample of the same primitive and depth takes its colour; shows on gradients face on",
        setOf("6.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private var above = emptyList<IntArray>()

                override fun colorRow(y: Int) {
                    super.colorRow(y)
                    if (above.isNotEmpty()) {
                        for (i in 0 until width) {
                            if (above[0][i] == indices[i] && above[1][i] == depths[i]) argb[i] = above[2][i]
                        }
                    }
                    above = listOf(indices.clone(), depths.clone(), argb.clone())
                }
            }
        }
    },
    Stranger(
        "color-keeps-last-alpha",
        "the alpha of a frame without translucency is taken for 1; shows with a shader that sets another",
        setOf("6.1", "6.4"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun color(index: Int, x: Int, y: Int): Int = super.color(index, x, y) or (0xFF shl 24)
            }
        }
    },
    Stranger(
        "color-fragment-not-moved-down",
        "the fragment is moved to a new row only if the column changes too; shows on primitives one column wide",
        setOf("6.1"),
    ) {
        plain {
            object : PlainDrawing(it) {
                private val own = Fragment()
                private var lastX = -1
                private var lastY = -1

                override fun color(index: Int, x: Int, y: Int): Int {
                    counters.shadingCalls++
                    if (x != lastX || y == lastY) lastY = y
                    lastX = x
                    own.moveTo(x, lastY)
                    primitives[index].shade(own)
                    return own.toArgb()
                }
            }
        }
    },
    Stranger(
        "color-clamped-before-encoding",
        "packs colours by its own power of 1/2.2 in place of the sRGB curve; shows on dark greys",
        setOf("6.4"),
    ) {
        tiles { frame, size -> PowerTiles(frame, size) }
    },
    Stranger(
        "color-nan-is-white",
        "a NaN component of a colour becomes 255; shows with a shader that divides 0 by 0",
        setOf("6.4"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun color(index: Int, x: Int, y: Int): Int {
                    val color = super.color(index, x, y)
                    return if (fragment.red.isNaN()) color or 0xFF0000 else color
                }
            }
        }
    },
)

/** Shades every eighth sample of wide runs, and the last. */
private class InterpolatedTiles(frame: Frame, tileSize: Int) : TileDrawing(frame, tileSize) {
    override fun colorRun(index: Int, y: Int, start: Int, end: Int) {
        super.colorRun(index, y, start, end)
        if (end - start < 24) return
        for (i in start until end - 8 step 8) {
            for (k in 1 until 8) argb[i + k] = between(argb[i], argb[minOf(i + 8, end - 1)], k)
        }
    }

    private fun between(first: Int, last: Int, k: Int): Int {
        var mixed = 0
        for (shift in 0..24 step 8) {
            val mean = ((first ushr shift and 0xFF) * (8 - k) + (last ushr shift and 0xFF) * k) / 8
            mixed = mixed or (mean shl shift)
        }
        return mixed
    }
}

/** Encodes by a power. */
private class PowerTiles(frame: Frame, tileSize: Int) : TileDrawing(frame, tileSize) {
    override fun color(index: Int, x: Int, y: Int): Int {
        val color = super.color(index, x, y)
        val alpha = color and (0xFF shl 24)
        return alpha or (encode(fragment.red) shl 16) or (encode(fragment.green) shl 8) or encode(fragment.blue)
    }

    private fun encode(value: Float): Int =
        (StrictMath.pow(value.coerceIn(0f, 1f).toDouble(), 1 / 2.2) * 255 + 0.5).toInt()
}
