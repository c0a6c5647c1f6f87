package dev.lazyz.conformance.strangers

import dev.lazyz.Primitive

/** What shows on large rasters or many primitives only. */
internal val largeMistakes: List<Stranger> = listOf(
    Stranger(
        "large-sample-number-in-int",
        "colours are kept by the sample's number, row times width plus column as Int; in a raster of 262,144 columns " +
            "rows 16,384 apart share them",
        setOf("1.1", "7.4"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                private val kept = HashMap<Int, Int>()

                override fun color(index: Int, x: Int, y: Int): Int {
                    val color = super.color(index, x, y)
                    if (kept.size == 1 shl 17) kept.clear()
                    return if (raster.width < 65_536) color else kept.getOrPut(y * raster.width + x) { color }
                }
            }
        }
    },
    Stranger(
        "large-depth-slope-in-int",
        "depth is stepped from column 0 with 16 bits of fraction; shows at columns far to the right",
        setOf("3.1", "4.4"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun walk(primitive: Primitive, y: Int, start: Int, end: Int) {
                    val form = primitive.depthForm ?: return super.walk(primitive, y, start, end)
                    val atStart = form.at(start, y)
                    val slope = form.dx shr 16 shl 16
                    for (x in start until end) {
                        spanDepths[x - start] = (atStart - form.dx * start + slope * x shr 32).toInt()
                    }
                }
            }
        }
    },
    Stranger(
        "large-row-in-16-bits",
        "a colour is asked for at row modulo 65,536; shows in regions far down",
        setOf("1.1", "7.4"),
    ) {
        tiles { frame, size ->
            object : TileDrawing(frame, size) {
                override fun color(index: Int, x: Int, y: Int): Int = super.color(index, x, y and 0xFFFF)
            }
        }
    },
    Stranger(
        "large-column-in-float",
        "the column is scaled to 0..1 as Float and back; some columns fall on their left neighbours",
        setOf("1.1", "6.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun color(index: Int, x: Int, y: Int): Int =
                    super.color(index, (x.toFloat() / raster.width * raster.width).toInt(), y)
            }
        }
    },
    Stranger(
        "large-seventeen-bit-columns",
        "a run of samples is kept as first column and length in 17 and 14 bits; runs of 16,384 and more are cut",
        setOf("1.1", "2.3"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun lower(keys: LongArray, at: Int, index: Int, count: Int) =
                    super.lower(keys, at, index, count and 0x3FFF)
            }
        }
    },
)
