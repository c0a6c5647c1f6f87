package dev.lazyz.setup

import dev.lazyz.Primitive

/** The vertices that this primitive shares with others and keeps alive, or null if it is known to share none. */
internal fun Primitive.sharedVertices(): Vertices? = when (this) {
    is PlanarPrimitive -> vertices
    is MaskedPrimitive -> whole.sharedVertices()
    is OpaquePrimitive -> whole.sharedVertices()
    else -> null
}
