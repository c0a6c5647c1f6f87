package dev.lazyz

import dev.lazyz.spi.Fragment
import dev.lazyz.spi.ShadingObserver
import java.util.function.IntPredicate

/**
 * The input of a renderer: a raster, primitives in submission order, and the part of the raster to render.
 *
 * All rounding has already happened when primitives are set up, so that renderers cannot differ in their result; a
 * renderer only chooses the order of evaluation. The list of primitives is not copied; do not change it. Immutable, and
 * thread safe if its primitives are.
 *
 * @property raster the grid of samples
 * @property region the samples to render; by default the whole raster
 * @throws IllegalArgumentException if [region] is not within the raster
 */
public class Frame internal constructor(
    public val raster: Raster,
    internal val content: FrameContent,
    public val region: Region,
) {
    @JvmOverloads
    public constructor(raster: Raster, primitives: List<Primitive>, region: Region = raster.region) :
        this(raster, FrameContent.of(primitives), region)

    init {
        require(raster.region.contains(region)) { "$region must be within $raster" }
    }

    /**
     * The primitives to render. The index in the list is the submission index, which resolves ties of depth. `size` has
     * constant cost. The triangles of a scene's opaque meshes become objects when the first element is accessed. If the
     * frame is streamed, the list can only be iterated, which reads the primitives again each time; `get` throws
     * [IllegalArgumentException], so that a renderer that needs it refuses the frame.
     */
    public val primitives: List<Primitive> get() = content.primitives

    /** Number of columns to render. */
    public val width: Int get() = region.width

    /** Number of rows to render. */
    public val height: Int get() = region.height

    /**
     * Whether the primitives are read while they are rendered, and not kept in memory, because the scene has a
     * `StreamedMesh`. Such a frame needs `TiledRenderer`, `ZBufferRenderer`, `HybridRenderer`, `HierarchicalRenderer`,
     * or another renderer that iterates the [primitives] only once; other renderers throw [IllegalArgumentException]
     * before they start. Translucent primitives need `TiledRenderer`.
     */
    public val isStreamed: Boolean get() = content.parts != null

    /**
     * Whether any primitive is translucent. Such a frame needs a renderer with [Capability.TRANSPARENCY]; other
     * renderers throw [IllegalArgumentException] before they start (contract rule 5.6). Cost: one pass over the
     * primitives, once.
     */
    public val hasTranslucency: Boolean get() = content.hasTranslucency

    /**
     * Returns this frame restricted to [region]. Its image is that rectangle of the whole image.
     *
     * @throws IllegalArgumentException if [region] is not within the raster
     */
    public fun within(region: Region): Frame = Frame(raster, content, region)

    /**
     * Returns this frame with only the primitives for whose index [test] returns true. The other primitives cover
     * nothing but keep their indices, so that images of parts can be merged into the image of the whole frame, see
     * [Image.merge].
     */
    public fun keeping(test: IntPredicate): Frame =
        Frame(
            raster,
            content.withAll { index, primitive -> if (test.test(index)) primitive else EmptyPrimitive },
            region,
        )

    /**
     * Returns this frame with all primitives opaque: their colours have alpha 1, and any renderer accepts them. Returns
     * this frame itself if nothing is translucent. Cost: one small object for each translucent primitive.
     */
    public fun asOpaque(): Frame =
        if (hasTranslucency) Frame(raster, content.asOpaque(), region) else this

    /**
     * Returns this frame with primitives whose colours are not computed: what is visible where, and how deep. The
     * colours of its image mean nothing, and shading calls in its counters cost nothing. For merging the visible parts
     * of images before any of them is shaded.
     */
    public fun unshaded(): Frame = Frame(raster, content.unshaded(), region)

    /** Returns this frame, whose primitives are shaded where [shading] says. */
    internal fun shadedAt(shading: PrimitiveShading): Frame = Frame(raster, content.shadedAt(shading), region)

    /**
     * Returns this frame with primitives that report each shading call to [observer]. Colours, depths and counters are
     * the same. The order of the calls is that of this frame for all built-in renderers but `TiledRenderer`, which
     * shades the fragments of one primitive together if it can: here it shades each tile row by row. Cost: an object
     * for each primitive.
     */
    public fun observed(observer: ShadingObserver): Frame {
        val all = content.withAll { index, primitive -> ObservedPrimitive(primitive, index, observer) }
        return Frame(raster, all, region)
    }

    /**
     * Returns what is seen at column [x] of row [y]: where a user clicks, for example. Null if it is the background.
     * Depth and primitive are those of the picture by every renderer without a selector: of translucent primitives, the
     * nearest is seen. With several samples a pixel, see `SampledFrame.at`.
     *
     * Cost: a look at the bounds of each primitive, some nanoseconds, and the spans of those that may be there; no
     * colours, and no objects for the triangles of meshes. The primitives of a streamed frame are read again. For
     * thousands of samples use `RaycastRenderer`, and for whole pictures `AovFrame`.
     *
     * @throws IllegalArgumentException if the sample is not in [region]
     * @throws InterruptedException if the calling thread is interrupted
     */
    @Throws(InterruptedException::class)
    public fun at(x: Int, y: Int): SeenPoint? = at(sample(x, y))

    /**
     * Returns what [renderer] shows at column [x] of row [y], as the other [at]: with a selector, what this selects.
     * Renders this one sample. Throws like [Renderer.render].
     */
    @Throws(InterruptedException::class)
    public fun at(x: Int, y: Int, renderer: Renderer): SeenPoint? {
        var point: SeenPoint? = null
        renderer.render(within(sample(x, y))) { _, _, depth, primitive ->
            val index = primitive[0]
            if (index != DepthTest.BACKGROUND) point = SeenPoint(this, x, y, depth[0], index, content.primitive(index))
        }
        return point
    }

    private fun sample(x: Int, y: Int): Region {
        require(region.contains(x, y)) { "sample must be within $region: ($x, $y)" }
        return Region(x, y, x + 1, y + 1)
    }

    /** Returns what is seen at that sample of [area] that wins the depth test; of several, the first in rows. */
    internal fun at(area: Region): SeenPoint? = NearestFragment(this, area).apply { draw(content, 0) }.point()

    override fun toString(): String = "Frame($raster, $region, ${content.size} primitives)"

    /**
     * What is seen at a sample of a frame, see [Frame.at]. Immutable.
     *
     * @property depth depth of the sample, 0..2^31-1, see [Depth]
     * @property primitive submission index of the visible primitive
     */
    public class SeenPoint internal constructor(
        frame: Frame,
        column: Int,
        row: Int,
        public val depth: Int,
        public val primitive: Int,
        seen: Primitive,
    ) {
        private val view = frame.content.view

        /** Number of the surface in `Scene.surfaces`, from 0; 0 for all primitives of a frame without a scene. */
        public val surface: Int = view.objectOf(primitive)

        /** Name of the surface, the path of its part in the file; empty if it has none. */
        public val part: String = view.objectNames.getOrElse(surface) { "" }

        /** Number of the triangle in its mesh, or of any other primitive in its surface, from 0. */
        public val triangle: Int = primitive - view.firstOf(surface)

        /** Position in world space; in pixels for what is given on the screen. 0 for what has none, such as edges. */
        public val x: Double
        public val y: Double
        public val z: Double

        /** Texture coordinates of the first set; v increases downward. 0 for surfaces without them. */
        public val u: Float
        public val v: Float

        /**
         * Distance from the eye along the line of sight, in units of the scene. Without a scene, 0 at the near plane
         * and 1 at the far plane.
         */
        public val distance: Double

        init {
            val fragment = Fragment()
            fragment.moveTo(column, row)
            distance = view.distance(frame.raster.convention.toUnit(depth), seen, fragment)
            fragment.moveTo(column, row)
            seen.geometry(fragment)
            x = view.originX + fragment.worldX
            y = view.originY + fragment.worldY
            z = view.originZ + fragment.worldZ
            u = fragment.u
            v = fragment.v
        }

        override fun toString(): String =
            "SeenPoint(surface $surface '$part', triangle $triangle, ($x, $y, $z), uv ($u, $v), distance $distance)"
    }
}

/** The fragment of the samples of [area] that wins the depth test. */
private class NearestFragment(private val frame: Frame, private val area: Region) {
    private val test = frame.raster.depthTest
    private val spans = area.spans()
    private var least = test.key(frame.raster.backgroundDepth, DepthTest.BACKGROUND)
    private var x = 0
    private var y = 0
    private var seen: Primitive? = null

    /** Draws [content], whose first primitive has the submission index [first]. */
    fun draw(content: FrameContent, first: Int) {
        content.parts?.forEach { part ->
            endIfInterrupted()
            if (part.reach == null || part.reach.within(area) != null) draw(part.content(), first + part.first)
        }
        val read = content.reader()
        content.forEachIn(area) { index, box -> draw(read(index), first + index, box) }
    }

    private fun draw(primitive: Primitive, index: Int, box: Region) {
        for (row in box.rowStart until box.rowEnd) {
            spans.clear()
            primitive.spans(row, spans)
            for (i in 0 until spans.count) {
                for (column in spans.start(i) until spans.end(i)) {
                    val key = test.key(primitive.depth(column, row), index)
                    if (key >= least) continue
                    least = key
                    x = column
                    y = row
                    seen = primitive
                }
            }
        }
    }

    fun point(): Frame.SeenPoint? =
        seen?.let { Frame.SeenPoint(frame, x, y, test.depthOf(least), test.indexOf(least), it) }
}

/**
 * Calls [action] with the index and the bounds in [region] of each primitive that may cover a sample there, but not
 * with those of parts. Makes no objects of primitives.
 */
internal inline fun FrameContent.forEachIn(region: Region, action: (index: Int, bounds: Region) -> Unit) {
    for (batch in batches) {
        for (number in 0 until batch.count) {
            if (Checkpoint.isDue(number)) endIfInterrupted()
            val bounds = if (batch.isDrawn(number)) batch.boundsIn(region, number) else null
            if (bounds != null) action(batch.first + number, bounds)
        }
    }
    for ((number, primitive) in singles.withIndex()) {
        endIfInterrupted()
        val bounds =
            region.intersect(primitive.columnStart, primitive.rowStart, primitive.columnEnd, primitive.rowEnd)
        if (bounds != null) action(index(number), bounds)
    }
}

/**
 * Checks that the primitives of [frame] are in memory, for a [renderer] that needs them more than once or in another
 * order. Called before the rendering starts.
 *
 * @throws IllegalArgumentException if the frame is streamed, see [Frame.isStreamed]
 */
internal fun requireInMemory(frame: Frame, renderer: Renderer) {
    require(!frame.isStreamed) {
        "the frame is streamed, and the renderer '${renderer.id}' needs all primitives in memory: " +
            "use 'tiled', 'zbuffer', 'hybrid' or 'hierarchical', or load the whole model"
    }
}
