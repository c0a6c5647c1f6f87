package dev.lazyz.conformance.cases

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingCursor
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Surface

/**
 * A translucent version of [whole]: unchanged except that the alpha of its colours is used (contract rule 5.5).
 *
 * The colours of `Frames.tint` have any alpha from 0 to 1. Immutable and thread safe if [whole] is.
 *
 * @param layers divisor of alpha, so that about this number of layers show through each other; at least 1
 */
public class Glass @JvmOverloads constructor(private val whole: Primitive, private val layers: Int = 1) :
    Primitive by whole.recoloured({ it.setColor(it.red, it.green, it.blue, it.alpha / layers) }) {
    init {
        require(layers >= 1) { "layers must be at least 1: $layers" }
    }

    override val isTranslucent: Boolean get() = true

    override fun toString(): String = "Glass($whole, $layers)"
}

/**
 * Returns this frame with each primitive as [Glass] for the given number of [layers], except those with an index in
 * [opaque], which stay as they are.
 */
internal fun FrameCase.thin(layers: Int, opaque: Set<Int> = emptySet()): FrameCase = FrameCase(
    Frame(
        frame.raster,
        frame.primitives.mapIndexed { i, it -> if (i in opaque) it else Glass(it, layers) },
        frame.region,
    ),
    "$code\n    .let { frame -> Frame(frame.raster, frame.primitives.mapIndexed { i, it -> " +
        "if (i in setOf<Int>(${opaque.joinToString()})) it else Glass(it, $layers) }) }",
)

/**
 * Returns this frame with [Glass] for each primitive whose index, modulo 16, is the number of a bit set in [choice].
 */
public fun Frame.glazed(choice: Int): Frame =
    Frame(raster, primitives.mapIndexed { i, it -> if (choice shr i % 16 and 1 == 1) Glass(it) else it }, region)

/** The choice of all primitives, for [glazed]. */
internal const val ALL_GLASS: Int = 0xFFFF

/** Returns this frame with [Glass] for the primitives that [choice] selects. */
internal fun FrameCase.glazed(choice: Int): FrameCase =
    FrameCase(frame.glazed(choice), "$code\n    .glazed($choice)", sceneOf { glazed(it, choice) })

/**
 * Returns the surfaces with the selected ones blended; null if one of these is not a polygon with a shader, or covers
 * nothing.
 */
private fun FrameCase.glazed(surfaces: List<Surface>, choice: Int): List<Surface>? {
    val chosen = surfaces.indices.filter { choice shr it % 16 and 1 == 1 }
    val blended = chosen.associateWith { i ->
        val polygon = surfaces[i] as? Polygon ?: return null
        val shader = polygon.material.shader
        if (shader == null || frame.primitives[i].run { rowStart >= rowEnd }) return null
        polygon.withMaterials { Material(alphaMode = AlphaMode.BLEND, shader = shader, name = it.name) }
    }
    return surfaces.mapIndexed { i, surface -> blended[i] ?: surface }
}

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
