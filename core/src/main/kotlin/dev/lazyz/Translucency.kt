package dev.lazyz

/**
 * Checks that [frame] has no translucent primitives, for a [renderer] that does not blend (contract rule 5.6). Called
 * before the rendering starts.
 *
 * @throws IllegalArgumentException if the frame has translucent primitives
 */
internal fun requireOpaque(frame: Frame, renderer: Renderer) {
    if (!frame.hasTranslucency) return
    require(!frame.isStreamed) {
        "the frame is streamed and has translucent primitives, and the renderer '${renderer.id}' does not blend: " +
            "use 'tiled', which does, or make it opaque with asOpaque()"
    }
    throw opaqueNeeded(frame.primitives.indexOfFirst { it.isTranslucent }, renderer)
}

/** The exception for a translucent primitive, with submission index [index]. */
internal fun opaqueNeeded(index: Int, renderer: Renderer) = IllegalArgumentException(
    "primitive $index is translucent and the renderer '${renderer.id}' does not blend: " +
        "use 'tiled' or 'lists', which do, or make it opaque with asOpaque()",
)

/** An opaque version of a translucent primitive: the same coverage, depth and light, with alpha 1. */
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
