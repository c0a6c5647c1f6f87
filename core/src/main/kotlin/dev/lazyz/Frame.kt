package dev.lazyz

/**
 * Everything a renderer needs: a raster and primitives in submission order, set up once.
 *
 * All that could make two renderers disagree has happened by now; a renderer only chooses the order of evaluation.
 * Immutable and thread safe if its primitives are.
 *
 * @property raster the grid of samples
 * @property primitives what to render; the position in the list is the submission index, which decides ties
 */
public class Frame(public val raster: Raster, public val primitives: List<Primitive>) {
    /** Number of columns. */
    public val width: Int get() = raster.width

    /** Number of rows. */
    public val height: Int get() = raster.height

    override fun toString(): String = "Frame($raster, ${primitives.size} primitives)"
}
