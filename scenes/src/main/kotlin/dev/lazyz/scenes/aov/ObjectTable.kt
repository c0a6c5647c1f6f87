package dev.lazyz.scenes.aov

import dev.lazyz.Region
import dev.lazyz.aov.Aov
import dev.lazyz.aov.AovFrame.AovImage
import dev.lazyz.scenes.json.JsonWriter
import dev.lazyz.world.Scene
import dev.lazyz.world.surface.Surface
import java.util.TreeMap

/**
 * The objects that are visible in an image of [Aov.OBJECT], in the order of their numbers.
 *
 * ```
 * val objects = AovFrame(frame, setOf(Aov.OBJECT)).render(TiledRenderer())[Aov.OBJECT]
 * for (part in ObjectTable.of(objects)) println("${part.name}: ${part.pixels} pixels")
 * ```
 */
public object ObjectTable {
    /**
     * Returns what is visible of each object in [image]; nothing for objects that are not. Cost: a look at each pixel.
     *
     * @throws IllegalArgumentException if [image] is not [Aov.OBJECT]
     */
    @JvmStatic
    public fun of(image: AovImage): List<VisibleObject> {
        require(image.aov == Aov.OBJECT) { "'${image.aov.id}' has no objects: ask for '${Aov.OBJECT.id}'" }
        val extents = TreeMap<Int, Extent>()
        val left = image.region.columnStart
        val top = image.region.rowStart
        for ((index, id) in image.ints.withIndex()) {
            if (id >= 0) extents.getOrPut(id) { Extent() }.add(left + index % image.width, top + index / image.width)
        }
        return extents.map { (id, extent) -> extent.of(id, image.names.getOrElse(id) { "" }) }
    }

    /** Writes the table of [image] as JSON. */
    internal fun write(out: Appendable, image: AovImage) {
        JsonWriter(out).members {
            key("objects").items(of(image)) { part ->
                members {
                    key("id").integer(part.id)
                    key("name").text(part.name)
                    key("pixels").integer(part.pixels)
                    key("columns").integers(part.region.columnStart, part.region.columnEnd)
                    key("rows").integers(part.region.rowStart, part.region.rowEnd)
                }
            }
        }
        out.append('\n')
    }
}

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
