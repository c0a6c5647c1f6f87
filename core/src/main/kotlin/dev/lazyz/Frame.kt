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

    override fun toString(): String = "Frame($raster, $region, ${content.size} primitives)"
}

/** What a frame knows about the scene that it was set up from. Immutable and thread safe. */
internal interface FrameView {
    /** [distance] at the near plane. */
    val near: Double

    /** [distance] at the far plane. */
    val far: Double

    /** The point, in world space, that [Fragment.worldX], [Fragment.worldY] and [Fragment.worldZ] are relative to. */
    val originX: Double
    val originY: Double
    val originZ: Double

    /**
     * Returns the distance from the eye along the line of sight, world units, of what is at the fraction [unit] of the
     * range of depths: 0 at the near plane, 1 at the far plane.
     */
    fun distance(unit: Double): Double

    /**
     * Returns the distance from the eye along the line of sight, world units, of a position as [Fragment] has it,
     * relative to [originX], [originY] and [originZ]. NaN if the frame was not set up from a scene.
     */
    fun distance(x: Float, y: Float, z: Float): Double

    /** Returns the number of the surface, in the order of the scene, whose primitive has the submission [index]. */
    fun objectOf(index: Int): Int

    /** The names of the surfaces, in the order of the scene; empty if the frame was not set up from one. */
    val objectNames: List<String>
}

/** The view of a frame that was not set up from a scene: distances are fractions, and all primitives are one object. */
internal object NoView : FrameView {
    override val near: Double get() = 0.0
    override val far: Double get() = 1.0
    override val originX: Double get() = 0.0
    override val originY: Double get() = 0.0
    override val originZ: Double get() = 0.0

    override fun distance(unit: Double): Double = unit

    override fun distance(x: Float, y: Float, z: Float): Double = Double.NaN

    override fun objectOf(index: Int): Int = 0

    override val objectNames: List<String> get() = emptyList()
}
