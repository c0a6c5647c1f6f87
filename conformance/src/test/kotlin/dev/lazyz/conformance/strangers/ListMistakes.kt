package dev.lazyz.conformance.strangers

import dev.lazyz.Rgba

/** Lists of fragments, their order, and what a selector gets. */
internal val listMistakes: List<Stranger> = listOf(
    Stranger(
        "list-of-16-fragments",
        "a sample has room for 16 fragments; the farthest of them gives way; shows on 17 layers of blending " +
            "or selection",
        setOf("5.5", "7.6"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun sorted(keys: LongArray): LongArray =
                    super.sorted(keys).let { it.copyOf(minOf(it.size, 16)) }
            }
        }
    },
    Stranger(
        "selector-asked-twice",
        "the selector is asked once for depth, once for colour: twice the shading",
        setOf("8.2"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun choose() {
                    super.choose()
                    super.choose()
                }
            }
        }
    },
    Stranger(
        "selector-background-white",
        "the cell's background is white, whatever the raster's",
        setOf("5.5", "7.6"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override val background: Rgba get() = Rgba.WHITE
            }
        }
    },
)
