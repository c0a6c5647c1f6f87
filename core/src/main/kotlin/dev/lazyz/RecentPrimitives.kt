package dev.lazyz

/** The primitives of [content] by submission index, without objects for all of them. Keeps recent ones; one thread. */
internal class RecentPrimitives(content: FrameContent) {
    private val read = content.reader()

    /** Recent primitives, by the lower bits of their indices. */
    private val known = arrayOfNulls<Primitive>(KNOWN)
    private val indices = IntArray(KNOWN) { DepthTest.BACKGROUND }

    /** Returns the primitive with submission index [index], which is visible somewhere. */
    operator fun get(index: Int): Primitive {
        val slot = index and KNOWN - 1
        if (indices[slot] != index) {
            known[slot] = read(index)
            indices[slot] = index
        }
        return checkNotNull(known[slot])
    }

    private companion object {
        /** Number of primitives that are kept, a power of two. */
        const val KNOWN = 4096
    }
}
