package dev.lazyz.drawing

import dev.lazyz.Checkpoint
import dev.lazyz.OwnCheckpoint
import dev.lazyz.Primitive
import dev.lazyz.Raster
import dev.lazyz.RenderOptions
import dev.lazyz.Workers
import dev.lazyz.drawing.EdgeStyle.EdgeSet
import dev.lazyz.drawing.EdgeStyle.HiddenLines
import dev.lazyz.geometry.Box
import dev.lazyz.geometry.UpAxis
import dev.lazyz.sections.Section.Hatching
import dev.lazyz.setup.Viewport
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.SetUp
import dev.lazyz.world.surface.Surface
import java.util.concurrent.atomic.AtomicReference
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
public class EdgeDrawing private constructor(
    private val surfaces: List<Surface>,
    public val style: EdgeStyle,
    private val known: AtomicReference<EdgeModel>,
) : Surface {
    public constructor(surfaces: List<Surface>, style: EdgeStyle) : this(surfaces, style, AtomicReference())

    /** The width of visible lines as samples show them; the unit of all lengths below. */
    private val width = maxOf(style.width, 1.0)

    override val pixelSize: Double get() = style.width

    /** Null: the surfaces have bounds of their own. */
    override val bounds: Box? get() = null

    override fun primitives(setUp: SetUp): Sequence<Primitive> = sequence {
        val viewport = Viewport(setUp.raster)
        val depth = viewport.depthOfUnit(0.0)
        val checkpoint = setUp.checkpoint
        val model = model(checkpoint)
        val view = view(model, setUp.raster, setUp.camera, width, setUp.workers, checkpoint)

        // The first submitted wins where visible and hidden lines cross
        val pen = Pen(setUp.raster, style.color, depth, width)
        for (line in polylines(whole(view.visible, model, width, checkpoint), model)) yieldAll(pen.strokes(line))
        if (style.hidden == HiddenLines.NONE) return@sequence
        val thinPen = Pen(setUp.raster, style.hiddenColor, depth, width * EdgeStyle.HIDDEN_SHARE)
        val dashes = Dashes(DASH * width, GAP * width)
        for (line in polylines(whole(view.hidden, model, width, checkpoint), model)) {
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
    private fun model(checkpoint: Checkpoint): EdgeModel = known.get() ?: synchronized(known) {
        known.get() ?: EdgeModel(surfaces, style.creaseAngle, checkpoint).also(known::set)
    }

    /** Returns the edges that [camera] shows on [raster], divided into visible and hidden parts. */
    private fun view(
        model: EdgeModel,
        raster: Raster,
        camera: Camera,
        width: Double,
        workers: Workers,
        checkpoint: Checkpoint,
    ): EdgeView {
        val near = camera.relativeTo(model.origin)
        val size = surfaces.mapNotNull { it.bounds }.reduceOrNull(Box::union)?.let {
            maxOf(it.maxX - it.minX, it.maxY - it.minY, it.maxZ - it.minZ)
        }
        val margin = width / 2 + 2.0
        val space = ViewSpace(raster, near)
        val facing = Facing(model, near, checkpoint)
        val tolerance = (size ?: 0.0) * TOLERANCE
        return EdgeView(model, facing, space, tolerance, margin, workers, checkpoint).also {
            it.divide(style.edges, if (style.hidden == HiddenLines.NONE) 0 else style.hiddenBehind)
        }
    }

    /** Returns [pieces] without crumbs; of all edges, none is one. */
    private fun whole(pieces: Pieces, model: EdgeModel, width: Double, checkpoint: Checkpoint): Pieces =
        if (style.edges == EdgeSet.ALL) {
            pieces
        } else {
            ShortPieces(pieces, model.pointCount, CRUMB * width, NEAR * width, checkpoint).removed()
        }

    private fun polylines(pieces: Pieces, model: EdgeModel): List<DoubleArray> {
        val lines = ArrayList<DoubleArray>()
        Polylines(pieces, model.pointCount).forEach { lines += it }
        return lines
    }

    /**
     * Returns the lines that [camera] shows on [raster], of which only the size counts: first the hidden parts, if
     * they are drawn, then the visible ones, and both in the order of [LineKind]. They are the lines of a picture with
     * 4 x 4 samples a pixel, not rounded. A line can reach beyond the raster by half its width and two pixels.
     *
     * @param options [RenderOptions.threads] and [RenderOptions.executor] are used, the others are not
     * @throws InterruptedException if the calling thread is interrupted
     */
    @JvmOverloads
    @Throws(InterruptedException::class)
    public fun lines(raster: Raster, camera: Camera, options: RenderOptions = RenderOptions()): List<DrawnLine> =
        OwnCheckpoint().use { checkpoint ->
            val model = model(checkpoint)
            val width = maxOf(style.width, LEAST_WIDTH)
            val view = view(model, raster, camera, width, options.workers, checkpoint)
            listOf(true, false).filter { !it || style.hidden != HiddenLines.NONE }.flatMap { isHidden ->
                val whole = whole(if (isHidden) view.hidden else view.visible, model, width, checkpoint)
                LineKind.entries.flatMap { kind ->
                    polylines(whole.of(kind), model).map { DrawnLine(kind, isHidden, it) }
                }
            }
        }

    /**
     * Returns the caps that show their front to [camera], as they are on [raster], of which only the size counts. As
     * all that a section leaves is behind its planes, nothing hides them, except what it cannot cut. Caps that show
     * their back are behind their own solids.
     *
     * @throws InterruptedException if the thread is interrupted
     */
    @Throws(InterruptedException::class)
    public fun caps(raster: Raster, camera: Camera): List<DrawnCap> {
        val view = CapView(ViewSpace(raster, camera), Scene(surfaces).origin)
        return surfaces.filterIsInstance<Polygon>().filter { it.isCap }.mapNotNull(view::of)
    }

    override fun withUpAxis(up: UpAxis): EdgeDrawing = EdgeDrawing(surfaces.map { it.withUpAxis(up) }, style)

    override fun withMaterials(change: UnaryOperator<Material>): EdgeDrawing =
        EdgeDrawing(surfaces.map { it.withMaterials(change) }, style)

    override fun magnified(factor: Int): EdgeDrawing = withStyle(style.withWidth(style.width * factor))

    /** Returns this drawing with another [style]. What was found out about edges is kept if it still holds. */
    public fun withStyle(style: EdgeStyle): EdgeDrawing =
        EdgeDrawing(surfaces, style, if (style.creaseAngle == this.style.creaseAngle) known else AtomicReference())

    override fun toString(): String = "EdgeDrawing(${surfaces.size} surfaces, $style)"

    /**
     * A visible or hidden part of edges of one kind, joined where two of them meet: a line of a drawing before it
     * becomes samples, see [lines]. Immutable if the array is not changed.
     *
     * @property points columns and rows of its points in turn, two or more points, pixels. The upper left corner of the
     *   raster is (0, 0). If the last point equals the first, the line is closed
     */
    public class DrawnLine internal constructor(
        public val kind: LineKind,
        public val isHidden: Boolean,
        public val points: DoubleArray,
    ) {
        override fun toString(): String = "DrawnLine($kind, hidden $isHidden, ${points.size / 2} points)"
    }

    /** What a line of a drawing is a part of, see [FeatureEdges]. If several are true, the first one counts. */
    public enum class LineKind {
        /** An edge of a cap, where a section cut a solid. */
        SECTION,

        /** A boundary of a mesh, or a side of a polygon. */
        BOUNDARY,

        /** A crease. */
        CREASE,

        /** A silhouette. */
        OUTLINE,

        /** Another edge between two triangles. Only [EdgeStyle.EdgeSet.ALL] has them. */
        FACET,
    }

    /**
     * A cap on the raster, see [caps]. Immutable if the arrays are not changed.
     *
     * @property cap the cap in the scene
     * @property contours closed contours of what is near the raster, with the non-zero rule: columns and rows of their
     *   points in turn, pixels
     * @property stripes if the material of the cap is a [Hatching], the contours of its stripes, in the same form; none
     *   if there would be more than [MAX_STRIPES], or the cap is more than 2^53 periods from the origin of the scene
     */
    public class DrawnCap internal constructor(
        public val cap: Polygon,
        public val contours: List<DoubleArray>,
        public val stripes: List<DoubleArray>,
    ) {
        override fun toString(): String = "DrawnCap(${contours.size} contours, ${stripes.size} stripes)"

        public companion object {
            /** The most stripes of a cap. */
            public const val MAX_STRIPES: Int = 1000
        }
    }

    public companion object {
        /** Length of the dashes of hidden lines, as a multiple of the width of visible lines. */
        public const val DASH: Double = 5.0

        /** Length of the gaps between them, in the same unit. */
        public const val GAP: Double = 3.5

        /** How near a face that touches an edge may be, as a part of the size of the scene. */
        private const val TOLERANCE = 1.0 / (1 shl 17)

        /** The length below which a part of a silhouette is left out, see [ShortPieces], as a multiple of the width. */
        private const val CRUMB = 8.0

        /** The distance at which lines belong together, in the same unit. */
        private const val NEAR = 1.0

        /** The width of a line as one of 4 x 4 samples of a pixel shows it, pixels. */
        private const val LEAST_WIDTH = 0.25
    }
}
