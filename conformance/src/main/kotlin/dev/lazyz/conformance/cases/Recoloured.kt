package dev.lazyz.conformance.cases

import dev.lazyz.Fragment
import dev.lazyz.Primitive
import dev.lazyz.ShadingCursor

/** Returns this primitive with changed colours. [change] is applied to each fragment after shading. */
internal fun Primitive.recoloured(change: (Fragment) -> Unit): Primitive = Recoloured(this, change)

private class Recoloured(private val whole: Primitive, private val change: (Fragment) -> Unit) : Primitive by whole {
    override fun shade(fragment: Fragment) {
        whole.shade(fragment)
        change(fragment)
    }

    override fun shadingCursor(x: Int, y: Int): ShadingCursor? = whole.shadingCursor(x, y)?.let { cursor ->
        object : ShadingCursor {
            override fun step() = cursor.step()

            override fun shade(fragment: Fragment) {
                cursor.shade(fragment)
                change(fragment)
            }
        }
    }
}
