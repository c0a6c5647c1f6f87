package dev.lazyz.shading

import dev.lazyz.Primitive
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.Shader

/** A primitive whose interpolated attributes can be computed without a shading call. */
internal interface AttributedPrimitive : Primitive {
    /** Computes the colour from the [attributes]. */
    val shader: Shader

    /** Sets the attributes of [fragment] that shading needs to those at its sample. */
    fun attributes(fragment: Fragment)

    override fun shade(fragment: Fragment) {
        attributes(fragment)
        shader.shade(fragment)
    }

    override fun geometry(fragment: Fragment): Unit = attributes(fragment)
}
