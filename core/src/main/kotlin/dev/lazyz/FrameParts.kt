package dev.lazyz

/**
 * The primitives of a frame in consecutive parts, for scenes that are larger than memory. A part is made when it is
 * needed, and not kept. Immutable; thread safe if [content] is.
 *
 * @property size number of primitives in all parts
 * @property hasTranslucency whether any primitive is translucent
 * @property content returns the parts in order. It is called for each pass over the primitives
 */
internal class FrameParts(
    val size: Int,
    val hasTranslucency: Boolean,
    private val content: () -> Iterator<FrameContent>,
) {
    /** Calls [action] for each part in order. [first] is the submission index of its first primitive. */
    inline fun forEach(action: (first: Int, part: FrameContent) -> Unit) {
        var first = 0
        for (part in parts()) {
            action(first, part)
            first += part.size
        }
    }

    fun parts(): Iterator<FrameContent> = content()

    /** Returns these parts, each replaced by the result of [change]. It must have as many primitives. */
    fun map(
        hasTranslucency: Boolean = this.hasTranslucency,
        change: (first: Int, part: FrameContent) -> FrameContent,
    ): FrameParts =
        FrameParts(size, hasTranslucency) { Changed(change) }

    private inner class Changed(private val change: (first: Int, part: FrameContent) -> FrameContent) :
        Iterator<FrameContent> {
        private val parts = content()
        private var first = 0

        override fun hasNext(): Boolean = parts.hasNext()

        override fun next(): FrameContent {
            val part = parts.next()
            return change(first, part).also { first += part.size }
        }
    }

    /** The primitives of all parts as a list that can only be iterated. */
    inner class Primitives : AbstractList<Primitive>() {
        override val size: Int get() = this@FrameParts.size

        override fun iterator(): Iterator<Primitive> =
            Iterable { content() }.asSequence().flatMap { it.primitives.asSequence() }.iterator()

        override fun get(index: Int): Primitive = throw UnsupportedOperationException(
            "the primitives of a streamed frame can only be iterated, not accessed by index",
        )
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
            "use 'tiled', 'zbuffer' or 'hybrid', or load the whole model"
    }
}

/**
 * Checks that the streamed [frame] has no translucent primitives: they would all have to be kept.
 *
 * @throws IllegalArgumentException otherwise
 */
internal fun requireOpaqueStream(frame: Frame) {
    require(!frame.hasTranslucency) {
        "the frame is streamed and has translucent primitives, which must be in memory: make it opaque with " +
            "asOpaque(), or load the whole model"
    }
}
