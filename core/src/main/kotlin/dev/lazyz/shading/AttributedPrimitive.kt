package dev.lazyz.shading

import dev.lazyz.Fragment
import dev.lazyz.Primitive

/** A primitive whose interpolated attributes can be asked for without a shading call. */
internal interface AttributedPrimitive : Primitive {
    /** Fills in the attributes at the fragment's sample. */
    fun attributes(fragment: Fragment)
}
