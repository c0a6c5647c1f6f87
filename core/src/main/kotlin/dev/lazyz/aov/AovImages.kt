package dev.lazyz.aov

import dev.lazyz.Counters
import dev.lazyz.geometry.UpAxis

/**
 * The AOVs of a rendering. Immutable.
 *
 * @property images the images, in the order of [Aov]
 * @property counters the work of the rendering of the picture
 */
public class AovImages internal constructor(public val images: List<AovImage>, public val counters: Counters) {
    /**
     * Returns the image of [aov].
     *
     * @throws IllegalArgumentException if it was not requested
     */
    public operator fun get(aov: Aov): AovImage =
        requireNotNull(images.firstOrNull { it.aov == aov }) { "'${aov.id}' was not requested: $this" }

    /** Returns positions and normals in the coordinates of a model, see [AovImage.toModel]. */
    public fun toModel(up: UpAxis): AovImages = AovImages(images.map { it.toModel(up) }, counters)

    override fun toString(): String = "AovImages(${images.joinToString { it.aov.id }})"
}
