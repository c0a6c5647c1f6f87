package dev.lazyz.conformance.mutants.skeletons

import dev.lazyz.Frame
import dev.lazyz.Renderer
import dev.lazyz.Rgba
import dev.lazyz.conformance.mutants.Mistake

/** Makes a renderer whose mixtures are made by [make]. */
private fun mixing(make: () -> Mixture): Renderer = lists { frame, selector ->
    object : ListDrawing(frame, selector) {
        override fun mixture(): Mixture = make()
    }
}

/** Makes a renderer that finishes a blended colour by [end], given the sums and the backdrop's number. */
private fun ending(end: ListDrawing.(Mixture, Int) -> Unit): Renderer = lists { frame, selector ->
    object : ListDrawing(frame, selector) {
        override fun blendBackdrop(over: Mixture, i: Int) = end(over, i)
    }
}

/** Rule 5.5 and 5.6. */
internal val blendMistakes: List<Mistake> = listOf(
    Mistake("blend-stops-early", "stops at a transmittance below 1/256; shows with bright colours behind") {
        mixing {
            object : Mixture() {
                override val isOpen: Boolean get() = transmittance >= 1f / 256f
            }
        }
    },
    Mistake("blend-alpha-not-clamped", "alpha above 1 and NaN are used as they are") {
        mixing {
            object : Mixture() {
                override fun opacity(alpha: Float): Float = maxOf(alpha, 0f)
            }
        }
    },
    Mistake("blend-in-double", "sums in double precision; shows in the last bit of some colours") {
        mixing { DoubleMixture() }
    },
    Mistake("blend-backdrop-opaque", "the backdrop's own alpha is taken for 1") {
        ending { over, i ->
            if (over.isOpen && i < size) {
                val last = shade(i)
                over.end(last.red, last.green, last.blue, 1f)
            } else {
                over.end(background.red, background.green, background.blue, background.alpha)
            }
        }
    },
    Mistake("blend-background-opaque", "the background's alpha is taken for 1; shows where it is not") {
        ending { over, i ->
            if (over.isOpen && i < size) {
                val last = shade(i)
                over.end(last.red, last.green, last.blue, last.alpha)
            } else {
                over.end(background.red, background.green, background.blue, 1f)
            }
        }
    },
    Mistake("blend-shades-hidden-backdrop", "the backdrop is shaded although nothing shines through") {
        ending { over, i ->
            if (i < size) {
                val last = shade(i)
                over.end(last.red, last.green, last.blue, last.alpha)
            } else {
                over.end(background.red, background.green, background.blue, background.alpha)
            }
        }
    },
    Mistake("translucency-outside-region", "translucent primitives that do not reach the region are not refused") {
        plain {
            object : PlainDrawing(it) {
                override fun refuseTranslucent(id: String) {
                    if (primitives.any { each -> each.isTranslucent && reaches(each) }) super.refuseTranslucent(id)
                }
            }
        }
    },
    Mistake("translucency-refused-late", "a translucent primitive is refused on its first row") {
        sweep { frame, coherence ->
            object : SweepDrawing(frame, coherence) {
                override fun refuseTranslucent(id: String) = Unit

                override fun enter(index: Int, y: Int) {
                    require(!primitives[index].isTranslucent) { "primitive $index is translucent: use asOpaque()" }
                    super.enter(index, y)
                }
            }
        }
    },
    Mistake("translucency-drawn-as-opaque", "a frame with translucent primitives is drawn without a word") {
        tiles { frame: Frame, size: Int ->
            object : TileDrawing(frame, size) {
                override fun refuseTranslucent(id: String) = Unit
            }
        }
    },
)

private class DoubleMixture : Mixture() {
    private val sums = DoubleArray(3)
    private var through = 1.0

    override fun add(red: Float, green: Float, blue: Float, opacity: Float) {
        if (isPassedOver(opacity)) return
        val weight = through * opacity
        sums[0] += weight * red
        sums[1] += weight * green
        sums[2] += weight * blue
        weights = (weights + weight).toFloat()
        through *= 1.0 - opacity
        transmittance = through.toFloat()
        this.red = sums[0].toFloat()
        this.green = sums[1].toFloat()
        this.blue = sums[2].toFloat()
    }
}

/** Lists of fragments, their order, and what a selector gets. */
internal val listMistakes: List<Mistake> = listOf(
    Mistake(
        "list-of-16-fragments",
        "a sample has room for 16 fragments; the farthest of them gives way; shows on 17 layers of " +
            "blending or selection",
    ) {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun sorted(keys: LongArray): LongArray =
                    super.sorted(keys).let { it.copyOf(minOf(it.size, 16)) }
            }
        }
    },
    Mistake("selector-asked-twice", "the selector is asked once for depth, once for colour: twice the shading") {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override fun choose() {
                    super.choose()
                    super.choose()
                }
            }
        }
    },
    Mistake("selector-background-white", "the cell's background is white, whatever the raster's") {
        lists { frame, selector ->
            object : ListDrawing(frame, selector) {
                override val background: Rgba get() = Rgba.WHITE
            }
        }
    },
)
