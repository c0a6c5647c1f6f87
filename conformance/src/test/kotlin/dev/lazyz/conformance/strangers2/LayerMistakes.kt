package dev.lazyz.conformance.strangers2

import dev.lazyz.Frame
import dev.lazyz.RenderOptions
import dev.lazyz.Selector
import dev.lazyz.conformance.strangers.Stranger

private fun wrongLayers(id: String, what: String, vararg chapters: String, steps: () -> LayerSteps): Stranger =
    Stranger(id, what, chapters.toSet()) { Layers(steps(), RenderOptions()) }

/** Mistakes of blending. */
internal fun layerMistakes(): List<Stranger> = listOf(
    wrongLayers("ties-as-submitted", "where the last wins ties, equal depths are blended as submitted", "5.5", "5.3") {
        object : LayerSteps() {
            override fun sort(pass: LayerPass, column: Column) {
                super.sort(pass, column)
                val isLastFirst = pass.test.key(0, 1) < pass.test.key(0, 0)
                if (!isLastFirst || !pass.frame.hasTranslucency) return
                var from = 0
                while (from < column.size) {
                    var until = from + 1
                    while (until < column.size && column.keys[until] ushr 32 == column.keys[from] ushr 32) until++
                    column.keys.reverse(from, until)
                    from = until
                }
            }
        }
    },
    wrongLayers("sixteen-layers", "room for 16 fragments of a sample; later ones are dropped", "5.5", "7.6") {
        object : LayerSteps() {
            override fun keep(pass: LayerPass, column: Column, key: Long) {
                if (column.size < 16) column.add(key)
            }
        }
    },
    wrongLayers("zero-times-infinity", "what has alpha 0 is added too: infinite light becomes NaN", "5.5") {
        object : LayerSteps() {
            override fun isSeen(alpha: Float): Boolean = true
        }
    },
    wrongLayers("nothing-is-black", "where all weights are 0 the colour is black, not the backdrop's", "5.5") {
        object : LayerSteps() {
            override fun end(sums: Sums, red: Float, green: Float, blue: Float, alpha: Float) {
                if (clamp(alpha) > 0f) super.end(sums, red, green, blue, alpha)
                if (sums.weight == 0f && clamp(alpha) == 0f) sums.isDone = true
            }
        }
    },
    wrongLayers("first-seen", "depth and primitive are those of the first fragment with an alpha above 0", "5.5") {
        object : LayerSteps() {
            override fun front(sums: Sums): Int = maxOf(sums.firstSeen, 0)
        }
    },
    wrongLayers(
        "behind-the-bound", "translucent fragments behind the least depth that an opaque one may have are lost", "5.5",
    ) {
        object : LayerSteps() {
            override fun sort(pass: LayerPass, column: Column) {
                super.sort(pass, column)
                val isReversed = pass.test.key(1, 0) < pass.test.key(0, 0)
                var cut = Long.MAX_VALUE
                for (i in 0 until column.size) {
                    val index = pass.test.indexOf(column.keys[i])
                    val one = pass.frame.primitives[index]
                    val bound = if (isReversed) one.greatestDepth else one.leastDepth
                    if (!one.isTranslucent) cut = minOf(cut, pass.test.key(bound, index))
                }
                var count = 0
                for (i in 0 until column.size) {
                    val key = column.keys[i]
                    val isKept = key <= cut || !pass.frame.primitives[pass.test.indexOf(key)].isTranslucent
                    if (isKept) column.keys[count++] = key
                }
                column.size = count
            }
        }
    },
    wrongLayers("sees-through-opaque", "an opaque primitive with an alpha below 1 lets through what is behind", "5.5") {
        object : LayerSteps() {
            override fun letsThrough(cell: LayerCell, i: Int): Boolean =
                super.letsThrough(cell, i) || cell.shade(i).alpha < 1f
        }
    },
    wrongLayers("shades-ahead", "translucent fragments are shaded, too, where nearer ones let nothing through", "5.5") {
        object : LayerSteps() {
            override fun blend(cell: LayerCell) {
                var i = 0
                while (i < cell.size && cell.isTranslucent(i)) cell.shade(i++)
                super.blend(cell)
            }
        }
    },
)

/** Mistakes of selectors. */
internal fun selectionMistakes(): List<Stranger> = listOf(
    wrongLayers("behind-background", "a selector of one's own gets what is behind the background", "7.6", "4.3") {
        object : LayerSteps() {
            override fun passes(pass: LayerPass, key: Long): Boolean =
                super.passes(pass, key) || pass.options.selector != null
        }
    },
    wrongLayers("first-show-decides", "of several calls of show the first decides", "7.6") {
        object : LayerSteps() {
            override fun mayShow(cell: LayerCell): Boolean = !cell.isShown
        }
    },
    wrongLayers("silence-is-nearest", "a selector that shows nothing shows the nearest fragment", "7.6") {
        object : LayerSteps() {
            override fun choose(cell: LayerCell) {
                if (!cell.isShown) cell.show(0)
            }
        }
    },
    wrongLayers("nearest-blends", "the selector of the nearest blends where something is translucent", "7.5") {
        object : LayerSteps() {
            override fun selector(frame: Frame, options: RenderOptions): Selector? =
                super.selector(frame, options)?.takeIf { it !== Selector.nearest() || !frame.hasTranslucency }
        }
    },
)
