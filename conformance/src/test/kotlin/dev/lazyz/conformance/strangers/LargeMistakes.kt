package dev.lazyz.conformance.strangers

import dev.lazyz.Primitive

/** What shows on large rasters or many primitives only. */
internal val largeMistakes: List<Stranger> = listOf(
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
)
