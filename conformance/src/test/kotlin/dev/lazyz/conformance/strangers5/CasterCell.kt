package dev.lazyz.conformance.strangers5

import dev.lazyz.Cell
import dev.lazyz.Counters
import dev.lazyz.Fragment
import dev.lazyz.Frame
import dev.lazyz.Rgba

/** All fragments of the sample that a ray goes through. */
internal class CasterCell(
    private val frame: Frame,
    private val spans: CasterSpans,
    private val colors: Chains,
    @Suppress("unused") private val counters: Counters.Builder,
    private val mistake: Mistake?,
) : Cell {
    private val test = frame.raster.depthTest
    private val mixer = Mixer(mistake)
    override var x: Int = 0
        private set
    override var y: Int = 0
        private set
    override var size: Int = 0
        private set
    override val background: Rgba get() = frame.raster.background

    /** Number of the fragment that is shown, or -1; and its colour, unless it is its own. */
    var shown: Int = -1
        private set
    private var hasColor = false
    private var color = 0

    /** Whether anything but the background is shown. */
    val isShown: Boolean get() = shown >= 0

    /** Bytes held besides those of the spans. */
    val bytes: Long get() = 20L

    /** Goes to a [column] of the region. */
    fun moveTo(column: Int, y: Int) {
        x = frame.region.columnStart + column
        this.y = y
        size = spans.gather(column)
        if (mistake != Mistake.CASTER_STALE_SHOW || shown >= size) shown = -1
    }

    private fun key(i: Int): Long {
        require(i in 0 until size) { "there are $size fragments: $i" }
        return spans.keys[i]
    }

    override fun depth(i: Int): Int = test.depthOf(key(i))

    override fun primitive(i: Int): Int = test.indexOf(key(i))

    override fun isTranslucent(i: Int): Boolean = frame.primitives[primitive(i)].isTranslucent

    override fun shade(i: Int): Fragment = colors.shade(x, y, primitive(i))

    override fun show(i: Int) {
        key(i)
        shown = i
        hasColor = false
    }

    override fun show(i: Int, red: Float, green: Float, blue: Float, alpha: Float) {
        key(i)
        shown = i
        hasColor = true
        color = Rgba(red, green, blue, alpha).toArgb()
    }

    /** Blends what there is, as rule 5.5 says. */
    fun blend() {
        if (!isTranslucent(0)) {
            show(0)
            return
        }
        mixer.begin()
        var i = 0
        while (i < size && mixer.isOpen && isTranslucent(i)) mixer.add(shade(i++))
        color = if (mixer.isOpen && i < size) {
            val backdrop = shade(i)
            mixer.finish(backdrop.red, backdrop.green, backdrop.blue, backdrop.alpha)
        } else {
            mixer.finish(background)
        }
        shown = 0
        hasColor = true
    }

    /** Returns the colour that is shown. */
    fun color(): Int = if (hasColor) color else shade(shown).toArgb()
}
