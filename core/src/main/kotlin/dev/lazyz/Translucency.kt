package dev.lazyz

/**
 * Refuses a frame with translucent primitives on behalf of a [renderer] that does not blend, before it starts
 * (contract rule 5.6).
 *
 * @throws IllegalArgumentException if the frame has translucent primitives
 */
internal fun requireOpaque(frame: Frame, renderer: Renderer) {
    if (!frame.hasTranslucency) return
    val index = frame.primitives.indexOfFirst { it.isTranslucent }
    requireOpaque(frame.primitives[index], index, renderer)
}

/** As [requireOpaque] for a frame: for the primitive that arrives as number [index] of a stream. */
internal fun requireOpaque(primitive: Primitive, index: Int, renderer: Renderer) {
    require(!primitive.isTranslucent) {
        "primitive $index is translucent and the renderer '${renderer.id}' does not blend: " +
            "use 'tiled' or 'lists', which do, or make it opaque with asOpaque()"
    }
}

/** A translucent primitive made opaque: the same coverage, depth and light, with alpha 1. */
internal class OpaquePrimitive(val whole: Primitive) : Primitive by whole {
    override val isTranslucent: Boolean get() = false

    override fun shade(fragment: Fragment) {
        whole.shade(fragment)
        fragment.setColor(fragment.red, fragment.green, fragment.blue)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)?.let { OpaqueCursor(it) }

    override fun toString(): String = "OpaquePrimitive($whole)"

    private class OpaqueCursor(private val whole: ShadingCursor) : ShadingCursor {
        override fun step() = whole.step()

        override fun shade(fragment: Fragment) {
            whole.shade(fragment)
            fragment.setColor(fragment.red, fragment.green, fragment.blue)
        }
    }
}
