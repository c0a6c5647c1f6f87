package dev.lazyz.conformance.strangers

import dev.lazyz.Frame
import dev.lazyz.Renderer

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
internal val blendMistakes: List<Stranger> = listOf(
    Stranger(
        "blend-stops-early",
        "stops at a transmittance below 1/256; shows with bright colours behind",
        setOf("5.5"),
    ) {
        mixing {
            object : Mixture() {
                override val isOpen: Boolean get() = transmittance >= 1f / 256f
            }
        }
    },
    Stranger("blend-alpha-not-clamped", "alpha above 1 and NaN are used as they are", setOf("5.5")) {
        mixing {
            object : Mixture() {
                override fun opacity(alpha: Float): Float = maxOf(alpha, 0f)
            }
        }
    },
    Stranger(
        "blend-in-double",
        "sums in double precision; shows in the last bit of some colours",
        setOf("5.5", "6.3"),
    ) {
        mixing { DoubleMixture() }
    },
    Stranger("blend-backdrop-opaque", "the backdrop's own alpha is taken for 1", setOf("5.5")) {
        ending { over, i ->
            if (over.isOpen && i < size) {
                val last = shade(i)
                over.end(last.red, last.green, last.blue, 1f)
            } else {
                over.end(background.red, background.green, background.blue, background.alpha)
            }
        }
    },
    Stranger("blend-background-opaque", "the background's alpha is taken for 1; shows where it is not", setOf("5.5")) {
        ending { over, i ->
            if (over.isOpen && i < size) {
                val last = shade(i)
                over.end(last.red, last.green, last.blue, last.alpha)
            } else {
                over.end(background.red, background.green, background.blue, 1f)
            }
        }
    },
    Stranger(
        "blend-shades-hidden-backdrop",
        "the backdrop is shaded although nothing shines through",
        setOf("5.5", "8.1"),
    ) {
        ending { over, i ->
            if (i < size) {
                val last = shade(i)
                over.end(last.red, last.green, last.blue, last.alpha)
            } else {
                over.end(background.red, background.green, background.blue, background.alpha)
            }
        }
    },
    Stranger(
        "translucency-outside-region",
        "translucent primitives that do not reach the region are not refused",
        setOf("5.6", "7.4"),
    ) {
        plain {
            object : PlainDrawing(it) {
                override fun refuseTranslucent(id: String) {
                    if (primitives.any { each -> each.isTranslucent && reaches(each) }) super.refuseTranslucent(id)
                }
            }
        }
    },
    Stranger("translucency-refused-late", "a translucent primitive is refused on its first row", setOf("5.6")) {
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
    Stranger(
        "translucency-drawn-as-opaque",
        "a frame with translucent primitives is drawn without a word",
        setOf("5.6"),
    ) {
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
