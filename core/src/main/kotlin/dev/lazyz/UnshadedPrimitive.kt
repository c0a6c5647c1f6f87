package dev.lazyz

/** A primitive with the coverage and depth of [whole], whose colour is not computed: black. */
internal class UnshadedPrimitive(private val whole: Primitive) : Primitive by whole {
    override val shadingStartCost: Int get() = 0

    override fun shade(fragment: Fragment) {
        fragment.setColor(0f, 0f, 0f)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = null

    override fun toString(): String = "UnshadedPrimitive($whole)"
}
