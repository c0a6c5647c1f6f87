package dev.lazyz.world

import dev.lazyz.Primitive
import dev.lazyz.geometry.Box

/**
 * Something to see, in world space: a [Mesh], a [Polygon], a [Sphere], [Points], [Lines], or a kind of one's own.
 *
 * To add a kind, turn the shape into primitives with [SetUp]'s functions, or into [Primitive]s of one's own.
 * Implementations are immutable and thread safe.
 */
public interface Surface {
    /** A box around the surface, or null if there is nothing in it. */
    public val bounds: Box?

    /**
     * Returns the surface's primitives in submission order, set up for one raster and camera.
     *
     * A degenerate or invisible part yields a primitive that covers nothing rather than none, so that numbering does
     * not depend on the camera. The sequence may be walked more than once.
     */
    public fun primitives(setUp: SetUp): Sequence<Primitive>

    /** Returns this surface with its materials replaced by what [change] makes of them; itself if it has none. */
    public fun withMaterials(change: (Material) -> Material): Surface = this
}
