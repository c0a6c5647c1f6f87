package dev.lazyz.setup.planar

import dev.lazyz.ObservedPrimitive
import dev.lazyz.OpaquePrimitive
import dev.lazyz.Primitive
import dev.lazyz.shading.MaskedPrimitive
import dev.lazyz.shading.Vertices

/** The vertices that this primitive references and shares with others, or null if it is known to share none. */
internal fun Primitive.sharedVertices(): Vertices? = when (this) {
    is PlanarPrimitive -> vertices
    is MaskedPrimitive -> whole.sharedVertices()
    is OpaquePrimitive -> whole.sharedVertices()
    is ObservedPrimitive -> whole.sharedVertices()
    else -> null
}
