package dev.lazyz.conformance.strangers


/** Regions and what is handed out. */
internal val regionMistakes: List<Stranger> = listOf(
    Stranger(
        "region-column-forgotten-in-shading",
        "colours are asked for at columns of the region",
        setOf("7.4", "6.1"),
    ) {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun color(index: Int, x: Int, y: Int): Int = super.color(index, x - region.columnStart, y)
            }
        }
    },
)
