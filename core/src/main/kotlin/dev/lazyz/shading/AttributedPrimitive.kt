package dev.lazyz.shading

import dev.lazyz.Fragment
import dev.lazyz.Primitive

/** A primitive whose interpolated attributes can be computed without a shading call. */
internal interface AttributedPrimitive : Primitive {
    /** Sets the attributes of [fragment] that shading needs to those at its sample. */
    fun attributes(fragment: Fragment)

    override fun geometry(fragment: Fragment): Unit = attributes(fragment)
}
