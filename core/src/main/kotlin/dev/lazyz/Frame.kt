package dev.lazyz

/**
 * Everything a renderer needs: a raster, primitives in submission order, set up once, and the part of the raster to render.
 *
 * All that could make two renderers disagree has happened by now; a renderer only chooses the order of evaluation.
 * Immutable and thread safe if its primitives are.
 *
 * @property raster the grid of samples
 * @property region the samples to render; the whole raster unless it is given
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
     * What to render; the position in the list is the submission index, which decides ties. Its size costs nothing; the
     * triangles of a scene's meshes are made when the first element is asked for.
     */
    public val primitives: List<Primitive> get() = content.primitives

    /** Number of columns to render. */
    public val width: Int get() = region.width

    /** Number of rows to render. */
    public val height: Int get() = region.height

    /**
     * Whether some primitive is translucent, so that the picture needs a renderer that blends: one with
     * [Capability.TRANSPARENCY]. Others refuse the frame before they start (contract rule 5.6). Cost: one pass over the
     * primitives, once.
     */
    public val hasTranslucency: Boolean get() = content.hasTranslucency

    /** Returns the part of this frame within [region]: the picture is that rectangle of the whole picture. */
    public fun within(region: Region): Frame = Frame(raster, content, region)

    /**
     * Returns the part of this frame with those primitives whose index passes [test]. The others cover nothing but keep
     * their indices, so that pictures of parts can be merged into the picture of the whole, see [Image.merge].
     */
    public fun keeping(test: (index: Int) -> Boolean): Frame =
        Frame(
            raster,
            primitives.mapIndexed { index, primitive ->
                if (test(index)) primitive else EmptyPrimitive
            },
            region
        )

    /**
     * Returns this frame with its translucent primitives made opaque: their colours have alpha 1, and any renderer takes
     * them. The frame itself if nothing is translucent; otherwise cost: one small object a translucent primitive.
     */
    public fun asOpaque(): Frame =
        if (hasTranslucency) Frame(raster, content.withSingles { it.asOpaque() }, region) else this

    override fun toString(): String = "Frame($raster, $region, ${content.size} primitives)"
}
