package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.Primitive
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.setup.Viewport
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Surface
import java.util.function.UnaryOperator

/**
 * The edges of the meshes and polygons among [surfaces], drawn as lines. Add it to the scene that has the surfaces, as
 * its last surface; [EdgeStyle.drawnOn] does this.
 *
 * What is hidden is computed when the camera is known, in double precision, from the triangles and not from pixels: a
 * line ends exactly where its middle goes behind the outline of a surface. The visible parts are then drawn in front of
 * all surfaces, at the depth of the near plane, with their full width. So no line sinks into its own faces, and none
 * shines through. The outlines of polygons are drawn, too.
 *
 * Meshes and polygons hide lines unless their material is translucent. Samples that a mask removes do hide them. What
 * is not drawn, because it shows its back or is nearer than the near plane, does not. Spheres, points, lines and custom
 * surfaces do not hide lines, and have no edges. A surface that touches an edge, up to 2^-17 of the size of the scene,
 * does not hide it.
 *
 * Silhouettes of rough surfaces leave crumbs: visible parts between hidden parts. Those that are shorter than 8 times
 * the width and not near another line are left out.
 *
 * The number of primitives depends on the camera. The list of surfaces is not copied; do not change it. Immutable and
 * thread safe if its surfaces are.
 *
 * Cost: linear in the number of faces and edges, as long as few faces are long and thin on the raster. An edge that a
 * polygon may hide costs the square of the polygon's sides at most.
 * Neighbours of triangles are found once, and visibility each time the scene is set up.
 *
 * @param surfaces the surfaces of the scene
 * @property style how the edges are drawn
 */
public class EdgeDrawing(private val surfaces: List<Surface>, public val style: EdgeStyle) : Surface {
    @Volatile
    private var model: EdgeModel? = null

    /** The width of visible lines as they are drawn, samples; the unit of all lengths below. */
    private val width = maxOf(style.width, 1.0)

    override val pixelSize: Double get() = style.width

    /** Null: the surfaces have bounds of their own. */
    override val bounds: Box? get() = null

    override fun primitives(setUp: SetUp): Sequence<Primitive> = sequence {
        val viewport = Viewport(setUp.raster)
        val depth = viewport.depthOfUnit(0.0)
        val checkpoint = setUp.checkpoint
        val model = model(checkpoint)
        val view = view(model, setUp)
        view.divide(style.edges, style.hidden != HiddenLines.NONE)

        // The first submitted wins where visible and hidden lines cross
        val pen = Pen(setUp.raster, style.color, depth, width)
        for (line in lines(view.visible, model, checkpoint)) yieldAll(pen.strokes(line))
        if (style.hidden == HiddenLines.NONE) return@sequence
        val thinPen = Pen(setUp.raster, style.hiddenColor, depth, width * EdgeStyle.HIDDEN_SHARE)
        val dashes = Dashes(DASH * width, GAP * width)
        for (line in lines(view.hidden, model, checkpoint)) {
            if (style.hidden == HiddenLines.SOLID) {
                yieldAll(thinPen.strokes(line))
            } else {
                val parts = ArrayList<DoubleArray>()
                dashes.forEach(line) { parts += it }
                for (part in parts) yieldAll(thinPen.strokes(part))
            }
        }
    }

    /** Returns the edges, which are found once. */
    private fun model(checkpoint: Checkpoint): EdgeModel = model ?: synchronized(this) {
        model ?: EdgeModel(surfaces, style.creaseAngle, checkpoint).also { model = it }
    }

    private fun view(model: EdgeModel, setUp: SetUp): EdgeView {
        val camera = setUp.camera.relativeTo(model.origin)
        val size = surfaces.mapNotNull { it.bounds }.reduceOrNull(Box::union)?.let {
            maxOf(it.maxX - it.minX, it.maxY - it.minY, it.maxZ - it.minZ)
        }
        val margin = width / 2 + 2.0
        val space = ViewSpace(setUp.raster, camera)
        val facing = Facing(model, camera, setUp.checkpoint)
        val tolerance = (size ?: 0.0) * TOLERANCE
        return EdgeView(model, facing, space, tolerance, margin, setUp.workers, setUp.checkpoint)
    }

    private fun lines(pieces: Pieces, model: EdgeModel, checkpoint: Checkpoint): List<DoubleArray> {
        val lines = ArrayList<DoubleArray>()
        val whole = ShortPieces(pieces, model.pointCount, CRUMB * width, NEAR * width, checkpoint).removed()
        Polylines(whole, model.pointCount).forEach { lines += it }
        return lines
    }

    override fun withUpAxis(up: UpAxis): EdgeDrawing = EdgeDrawing(surfaces.map { it.withUpAxis(up) }, style)

    override fun withMaterials(change: UnaryOperator<Material>): EdgeDrawing =
        EdgeDrawing(surfaces.map { it.withMaterials(change) }, style)

    override fun magnified(factor: Int): EdgeDrawing = withStyle(style.withWidth(style.width * factor))

    /** Returns this drawing with another [style]. */
    public fun withStyle(style: EdgeStyle): EdgeDrawing = EdgeDrawing(surfaces, style)

    override fun toString(): String = "EdgeDrawing(${surfaces.size} surfaces, $style)"

    private companion object {
        /** How near a face that touches an edge may be, as a part of the size of the scene. */
        const val TOLERANCE = 1.0 / (1 shl 17)

        /** Lengths of dashes and of gaps, as multiples of the width of visible lines. */
        const val DASH = 5.0
        const val GAP = 3.5

        /** The length below which a part of a silhouette is left out, see [ShortPieces], as a multiple of the width. */
        const val CRUMB = 8.0

        /** The distance at which lines belong together, in the same unit. */
        const val NEAR = 1.0
    }
}
