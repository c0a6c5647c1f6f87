package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Frame
import dev.lazyz.conformance.mutants.Mistake

/** Colours that are kept, shared or guessed. */
internal val shadingMistakes: List<Mistake> = listOf(
    Mistake(
        "color-linear-from-24",
        "runs of 24 and more are shaded at every eighth sample, with packed colours interpolated between",
    ) {
        tiles { frame, size -> InterpolatedTiles(frame, size) }
    },
    Mistake(
        "color-clamped-before-encoding",
        "packs colours by its own power of 1/2.2 in place of the sRGB curve; shows on dark greys",
    ) {
        tiles { frame, size -> PowerTiles(frame, size) }
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

/** Regions and what is handed out. */
internal val regionMistakes: List<Mistake> = listOf(
    Mistake("region-column-forgotten-in-shading", "colours are asked for at columns of the region") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun color(index: Int, x: Int, y: Int): Int = super.color(index, x - region.columnStart, y)
            }
        }
    },
)
