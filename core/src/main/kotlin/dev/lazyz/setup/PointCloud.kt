package dev.lazyz.setup

import dev.lazyz.EmptyPrimitive
import dev.lazyz.HeapLayout
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.raster.ScreenGrid
import dev.lazyz.shading.AttributedPrimitive
import dev.lazyz.shading.Lighting
import dev.lazyz.shading.MaterialShader
import dev.lazyz.spi.Fragment
import dev.lazyz.spi.LinearForm
import dev.lazyz.spi.Shader
import dev.lazyz.spi.Spans
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.AlphaMode
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.material.Material.Sides
import dev.lazyz.world.surface.Points

/** Sets up the points of one [Points] surface, and holds the data that they share. Immutable and thread safe. */
internal class PointCloud(private val points: Points, private val stage: VertexStage, lighting: Lighting) {
    private val material: Material = points.material.withoutTexture(
        when {
            points.normals == null -> Shading.CONSTANT
            points.material.shading == Shading.FLAT || points.material.shading == Shading.GOURAUD -> Shading.PHONG
            else -> points.material.shading
        },
    )
    private val materialShader = MaterialShader(material, lighting, isPrelit = false)

    val raster: Raster get() = stage.viewport.raster

    /** Half the side of the squares, grid steps. */
    val half: Int = ScreenGrid.half(points.size)

    /** The shader of all points. */
    val shader: Shader get() = material.shader ?: materialShader

    /** Returns the points as primitives, each set up when the sequence reaches it. */
    fun primitives(): Sequence<Primitive> = (0 until points.pointCount).asSequence().map { primitive(it) }

    private fun primitive(number: Int): Primitive {
        val p = points.positions
        var primitive: Primitive = EmptyPrimitive
        stage.toClip(
            p[3 * number].toDouble(), p[3 * number + 1].toDouble(), p[3 * number + 2].toDouble(),
        ) { x, y, z, w ->
            if (stage.clipper.isInside(x, y, z, w)) primitive = primitive(number, x, y, z, w)
        }
        return primitive
    }

    private fun primitive(number: Int, x: Double, y: Double, z: Double, w: Double): Primitive {
        val viewport = stage.viewport
        val point = PointPrimitive(this, number, viewport.gridX(x, w), viewport.gridY(y, w), viewport.depth(z, w))
        return if (!point.isVisible || isTurnedAway(number) || isCutOut(number)) EmptyPrimitive else point
    }

    /** Whether the visible side of a point is not drawn. */
    private fun isTurnedAway(number: Int): Boolean =
        material.sides == Sides.FRONT && points.normals != null && towardEye(number) < 0.0

    private fun isCutOut(number: Int): Boolean {
        if (material.alphaMode != AlphaMode.MASK) return false
        val fragment = Fragment().also { attributes(number, it) }
        return !materialShader.reaches(fragment, material.alphaCutoff)
    }

    /** Whether a point is translucent, because of the material or its colour. */
    fun isTranslucent(number: Int): Boolean {
        val colors = points.colors
        return material.isTranslucent ||
            (material.alphaMode == AlphaMode.BLEND && colors != null && colors[4 * number + 3] != 1f)
    }

    /** Sets the attributes of [fragment] to those of a point, which are the same at all its samples. */
    fun attributes(number: Int, fragment: Fragment) {
        fragment.worldX = points.positions[3 * number]
        fragment.worldY = points.positions[3 * number + 1]
        fragment.worldZ = points.positions[3 * number + 2]
        val normals = points.normals
        if (normals != null) {
            val sign = if (towardEye(number) < 0.0) -1f else 1f
            fragment.normalX = sign * normals[3 * number]
            fragment.normalY = sign * normals[3 * number + 1]
            fragment.normalZ = sign * normals[3 * number + 2]
        }
        val colors = points.colors ?: return
        fragment.vertexRed = colors[4 * number]
        fragment.vertexGreen = colors[4 * number + 1]
        fragment.vertexBlue = colors[4 * number + 2]
        fragment.vertexAlpha = colors[4 * number + 3]
    }

    /** Positive if the normal of a point points to the viewer's side. The points must have normals. */
    private fun towardEye(number: Int): Double {
        val p = points.positions
        val n = points.normals!!
        val at = 3 * number
        return stage.towardEye(
            p[at].toDouble(), p[at + 1].toDouble(), p[at + 2].toDouble(),
            n[at].toDouble(), n[at + 1].toDouble(), n[at + 2].toDouble(),
        )
    }
}

/** Returns this material for points and lines: without its maps, and with the given [shading]. */
internal fun Material.withoutTexture(shading: Shading): Material =
    withoutMaps().withShading(shading)

/**
 * A point on the raster: a square around its snapped vertex, with constant depth (contract rule 2.9).
 *
 * A frame can have tens of millions of points, so a point has only four numbers and a reference to its [cloud]: 32
 * bytes.
 *
 * @param number number of the point in the cloud
 * @param x column position of the vertex on the 1/256 pixel grid
 * @param y row position of the vertex on the 1/256 pixel grid
 */
internal class PointPrimitive(
    private val cloud: PointCloud,
    private val number: Int,
    private val x: Int,
    private val y: Int,
    private val depth: Int,
) : AttributedPrimitive {
    override val rowStart: Int get() = maxOf(ScreenGrid.firstSample(y - cloud.half), 0)
    override val rowEnd: Int get() = minOf(ScreenGrid.firstSample(y + cloud.half), cloud.raster.height)
    override val columnStart: Int get() = maxOf(ScreenGrid.firstSample(x - cloud.half), 0)
    override val columnEnd: Int get() = minOf(ScreenGrid.firstSample(x + cloud.half), cloud.raster.width)
    override val depthForm: LinearForm get() = LinearForm.constant(depth)
    override val leastDepth: Int get() = depth
    override val greatestDepth: Int get() = depth
    override val isTranslucent: Boolean get() = cloud.isTranslucent(number)
    override val shader: Shader get() = cloud.shader
    override val heldBytes: Long get() = HeapLayout.POINT

    /** Whether the point covers any sample. */
    val isVisible: Boolean get() = rowStart < rowEnd && columnStart < columnEnd

    override fun spans(y: Int, spans: Spans) {
        if (y in rowStart until rowEnd) spans.add(columnStart, columnEnd)
    }

    override fun depth(x: Int, y: Int): Int = depth

    override fun attributes(fragment: Fragment): Unit = cloud.attributes(number, fragment)

    override fun toString(): String =
        "PointPrimitive(rows $rowStart..<$rowEnd, columns $columnStart..<$columnEnd, depth $depth)"
}
