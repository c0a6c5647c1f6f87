package dev.lazyz.scenes.aov

import dev.lazyz.Region
import dev.lazyz.aov.AovImage
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Surface

/**
 * What is visible of an object. Immutable.
 *
 * @property id its number in [Scene.surfaces]
 * @property name its name, see [Surface.name]; can be empty
 * @property pixels number of pixels that it has in the [AovImage]
 * @property region the smallest region with all of them
 */
public class VisibleObject internal constructor(
    public val id: Int,
    public val name: String,
    public val pixels: Int,
    public val region: Region,
) {
    override fun toString(): String = "VisibleObject($id, \"$name\", $pixels pixels in $region)"
}

/** Collects the pixels of an object. Not thread safe. */
internal class Extent {
    private var pixels = 0
    private var left = Int.MAX_VALUE
    private var top = Int.MAX_VALUE
    private var right = -1
    private var bottom = -1

    fun add(x: Int, y: Int) {
        pixels++
        left = minOf(left, x)
        top = minOf(top, y)
        right = maxOf(right, x)
        bottom = maxOf(bottom, y)
    }

    fun of(id: Int, name: String) = VisibleObject(id, name, pixels, Region(left, top, right + 1, bottom + 1))
}
