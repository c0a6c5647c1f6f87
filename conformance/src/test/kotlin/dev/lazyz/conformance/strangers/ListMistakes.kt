package dev.lazyz.conformance.strangers

import dev.lazyz.DepthTest
import dev.lazyz.Fragment
import dev.lazyz.Rgba

/** Lists of fragments, their order, and what a selector gets. */
internal val listMistakes: List<Stranger> = listOf(
    Stranger(
        "list-sorted-by-depth",
        "sorted by depth alone, in order of submission among equals; shows on ties where the last wins",
        setOf("5.3", "5.5"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun sorted(keys: LongArray): LongArray = keys
                    .sortedWith(compareBy({ it ushr 32 }, { test.indexOf(it) })).toLongArray()
            }
        }
    },
    Stranger(
        "list-comparator-overflows",
        "the comparator is the difference as Int; shows where fragments of a sample have other depths",
        setOf("5.5", "5.1"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun sorted(keys: LongArray): LongArray {
                    val list = keys.toTypedArray()
                    for (i in 1 until list.size) {
                        val key = list[i]
                        var at = i
                        while (at > 0 && (list[at - 1] - key).toInt() > 0) list[at] = list[--at]
                        list[at] = key
                    }
                    return list.toLongArray()
                }
            }
        }
    },
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
        "list-bubble-12",
        "12 bubbling passes are thought to be enough; shows where a sample has more than 13 fragments, " +
            "submitted far to near",
        setOf("5.5", "7.6"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun sorted(keys: LongArray): LongArray {
                    repeat(12) {
                        for (i in 1 until keys.size) {
                            if (keys[i - 1] > keys[i]) keys[i] = keys[i - 1].also { keys[i - 1] = keys[i] }
                        }
                    }
                    return keys
                }
            }
        }
    },
    Stranger(
        "list-nearest-first-only",
        "only the nearest is brought to the front; shows with selectors of the others, and when two are blended",
        setOf("7.6", "5.5"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun sorted(keys: LongArray): LongArray {
                    val least = keys.indices.minBy { keys[it] }
                    keys[0] = keys[least].also { keys[least] = keys[0] }
                    return keys
                }
            }
        }
    },
    Stranger(
        "list-behind-background",
        "fragments behind the background are kept if some other of the sample is before it; shows when they " +
            "are blended",
        setOf("4.3", "5.5", "7.6"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun isBeforeBackground(key: Long): Boolean = true

                override fun choose() {
                    if (super.isBeforeBackground(sorted[0])) super.choose()
                }
            }
        }
    },
    Stranger(
        "selector-stale-answer",
        "where the selector shows nothing, the sample shows what its left neighbour does",
        setOf("7.6"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun choose() {
                    val argb = lastArgb
                    super.choose()
                    if (shownIndex == DepthTest.BACKGROUND && x > region.columnStart) shownArgb = argb
                    lastArgb = shownArgb
                }

                private var lastArgb = backgroundArgb()
            }
        }
    },
    Stranger(
        "selector-color-with-nearest-depth",
        "a fragment that is shown in a colour of the selector's own has the nearest one's depth and primitive",
        setOf("7.6"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) =
                    super.show(0, red, green, blue, alpha)
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
    Stranger(
        "selector-shade-is-packed",
        "a cell keeps shaded colours as 8 bits; shows when dark or bright ones are blended, and in a selector's sums",
        setOf("5.5", "6.4"),
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun shade(i: Int): Fragment = super.shade(i).also {
                    val kept = Rgba.ofArgb(it.toArgb())
                    it.setColor(kept.red, kept.green, kept.blue, kept.alpha)
                }
            }
        }
    },
    Stranger(
        "selector-ignored-on-translucent-frames",
        "a frame with translucent primitives is blended, also where the options have a selector",
        setOf("7.6", "7.5"),
    ) {
        lists { frame, selector -> ListDrawing(frame, if (frame.hasTranslucency) null else selector) }
    },
)
