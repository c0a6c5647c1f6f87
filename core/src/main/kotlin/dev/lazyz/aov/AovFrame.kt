package dev.lazyz.aov

import dev.lazyz.Counters
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame
import dev.lazyz.geometry.UpAxis
import java.io.IOException

/**
 * A frame, and the AOVs that are computed when it is rendered.
 *
 * ```
 * val frame = SuperSampling(4).frame(scene, Raster(640, 480))
 * val aovs = AovFrame(frame, setOf(Aov.DEPTH, Aov.NORMAL)).render(Tiled())
 * val distance = aovs[Aov.DEPTH].number(x = 320, y = 240)
 * ```
 *
 * Works with every [Renderer], by the rows that it hands out: attributes are computed for the visible primitive of each
 * pixel, after hidden surfaces are removed, by the functions that shading uses. The set is not copied; do not change
 * it. Immutable and thread safe, if the frame's primitives are.
 *
 * Memory: 4 bytes for each number, see [Aov.channels], and 24 bytes a column. Cost: an evaluation of the attributes for
 * each covered pixel, on the calling thread; for [Aov.OVERDRAW] one pass over the spans of all primitives; for
 * [Aov.SHADING_CALLS] another rendering.
 *
 * @property frame the samples and how they become pixels
 * @property aovs what is computed; may be empty
 * @throws IllegalArgumentException if an AOV of the frame's pixels has more numbers than an array: render regions; or
 *   if the frame is streamed, and an AOV is not [Aov.OBJECT], [Aov.PRIMITIVE] or [Aov.COVERAGE]
 */
public class AovFrame(public val frame: SampledFrame, public val aovs: Set<Aov>) {
    init {
        for (aov in aovs) {
            Aov.requireRoom(aov, frame)
            require(!frame.frame.isStreamed || aov in Aov.WITHOUT_PRIMITIVES) {
                "'${aov.id}' needs all primitives in memory, and those of a streamed frame are not"
            }
        }
    }

    /** Computes the AOVs, without the picture. Throws like the other [render]. */
    @Throws(InterruptedException::class)
    public fun render(renderer: Renderer): AovImages = render(renderer) { _, _, _, _ -> }

    /**
     * Renders the pixels to [sink], as [SampledFrame.render] does, and computes the AOVs.
     *
     * @throws IllegalArgumentException as [SampledFrame.render]
     */
    @Throws(InterruptedException::class, IOException::class)
    public fun render(renderer: Renderer, sink: RowSink): AovImages {
        val images = ArrayList<AovImage>()
        val points = PointAovs(frame, aovs.filter { it.isOfPoint || it == Aov.COVERAGE })
        val counters = frame.render(renderer, sink) { rest ->
            RowSink { y, argb, depth, primitive ->
                points.row(y, argb, depth, primitive)
                rest.row(y, argb, depth, primitive)
            }
        }
        images += points.images()
        if (Aov.OVERDRAW in aovs) images += WorkAovs.overdraw(frame)
        if (Aov.SHADING_CALLS in aovs) images += WorkAovs.shadingCalls(frame, renderer)
        return AovImages(images.sortedBy { it.aov }, counters)
    }

    override fun toString(): String = "AovFrame($frame, ${aovs.joinToString { it.id }})"
}

/**
 * The AOVs of a rendering. Immutable.
 *
 * @property images the images, in the order of [Aov]
 * @property counters the work of the rendering of the picture
 */
public class AovImages internal constructor(public val images: List<AovImage>, public val counters: Counters) {
    /**
     * Returns the image of [aov].
     *
     * @throws IllegalArgumentException if it was not requested
     */
    public operator fun get(aov: Aov): AovImage =
        requireNotNull(images.firstOrNull { it.aov == aov }) { "'${aov.id}' was not requested: $this" }

    /** Returns positions and normals in the coordinates of a model, see [AovImage.toModel]. */
    public fun toModel(up: UpAxis): AovImages = AovImages(images.map { it.toModel(up) }, counters)

    override fun toString(): String = "AovImages(${images.joinToString { it.aov.id }})"
}
