package dev.lazyz

/**
 * The primitives of a frame in consecutive parts, for scenes that are larger than memory. A part is made when it is
 * needed, and not kept. Immutable; thread safe if the parts are.
 *
 * @property size number of primitives in all parts
 * @property hasTranslucency whether any primitive is translucent
 * @param parts returns the parts in order
 */
internal class FrameParts(val size: Int, val hasTranslucency: Boolean, private val parts: () -> Iterator<FramePart>) :
    Iterable<FramePart> {
    override fun iterator(): Iterator<FramePart> = parts()

    /** Returns these parts, each with its content replaced by the result of [change]. It must have the same size. */
    fun map(hasTranslucency: Boolean = this.hasTranslucency, change: (FramePart) -> FrameContent): FrameParts =
        FrameParts(size, hasTranslucency) {
            parts().asSequence().map { FramePart(it.first, it.size, it.reach) { change(it) } }.iterator()
        }

    /** The primitives of all parts as a list that can only be iterated. */
    fun primitives(): List<Primitive> = object : AbstractList<Primitive>() {
        override val size: Int get() = this@FrameParts.size

        override fun iterator(): Iterator<Primitive> =
            this@FrameParts.asSequence().flatMap { it.content().primitives.asSequence() }.iterator()

        override fun get(index: Int): Primitive = throw IllegalArgumentException(
            "the primitives of a streamed frame can only be iterated, not accessed by index: use 'tiled', 'zbuffer', " +
                "'hybrid' or 'hierarchical', or load the whole model",
        )
    }
}

/**
 * Consecutive primitives of a streamed frame.
 *
 * @property first submission index of the first primitive
 * @property size number of primitives
 * @property reach a rectangle outside of which they cover nothing, or null if it is not known; it may be empty
 * @param read makes the primitives, which takes time and memory. Thread safe
 */
internal class FramePart(val first: Int, val size: Int, val reach: Reach?, private val read: () -> FrameContent) {
    fun content(): FrameContent = read()
}

/** A rectangle of samples: columns [left] until [right], rows [top] until [bottom]. It may lie outside the raster. */
internal class Reach(private val left: Int, private val top: Int, private val right: Int, private val bottom: Int) {
    /** Returns the part of [region] that is in this rectangle, or null if there is none. */
    fun within(region: Region): Region? {
        val columnStart = maxOf(left, region.columnStart)
        val rowStart = maxOf(top, region.rowStart)
        val columnEnd = minOf(right, region.columnEnd)
        val rowEnd = minOf(bottom, region.rowEnd)
        if (columnStart >= columnEnd || rowStart >= rowEnd) return null
        return Region(columnStart, rowStart, columnEnd, rowEnd)
    }
}

/**
 * Checks that the primitives of [frame] are in memory, for a [renderer] that needs them more than once or in another
 * order. Called before the rendering starts.
 *
 * @throws IllegalArgumentException if the frame is streamed, see [Frame.isStreamed]
 */
internal fun requireInMemory(frame: Frame, renderer: Renderer) {
    require(!frame.isStreamed) {
        "the frame is streamed, and the renderer '${renderer.id}' needs all primitives in memory: " +
            "use 'tiled', 'zbuffer', 'hybrid' or 'hierarchical', or load the whole model"
    }
}
