package dev.lazyz.aov

import dev.lazyz.Counters
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.filter.SampledFrame
import dev.lazyz.geometry.UpAxis
import dev.lazyz.world.surface.Surface
import java.io.IOException
import org.joml.Vector3d

/**
 * A frame, and the AOVs that are computed when it is rendered.
 *
 * ```
 * val frame = SuperSampling(4).frame(scene, Raster(640, 480))
 * val aovs = AovFrame(frame, setOf(Aov.DEPTH, Aov.NORMAL)).render(TiledRenderer())
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

    /**
     * One AOV of a picture: [Aov.channels] numbers for each pixel of [region], in rows from the top. The array is not
     * copied; do not change it. Immutable and thread safe.
     *
     * @property aov what the numbers mean
     * @property region the pixels
     * @property lowest the number that formats of limited range show as 0: the near plane for [Aov.DEPTH]
     * @property highest the number that they show as their maximum: the far plane for [Aov.DEPTH]
     * @property samplesPerPixel number of samples of a pixel, over which counts are sums; at least 1
     * @property names for [Aov.OBJECT], the name of each object of the scene by its number, see [Surface.name];
     *   otherwise empty
     */
    public class AovImage private constructor(
        public val aov: Aov,
        public val region: Region,
        public val lowest: Double,
        public val highest: Double,
        private val reals: FloatArray,
        private val integers: IntArray,
        public val samplesPerPixel: Int,
        public val names: List<String>,
    ) {
        init {
            require(samplesPerPixel >= 1) { "samplesPerPixel must be at least 1: $samplesPerPixel" }
            val size = region.size * aov.channels.size
            val found = if (aov.isInteger) integers.size else reals.size
            require(found.toLong() == size) { "'${aov.id}' of $region needs $size numbers: $found" }
        }

        /**
         * Creates an image of an AOV whose numbers are of single precision.
         *
         * @throws IllegalArgumentException if [aov] has integers, or [floats] has not the right size
         */
        public constructor(aov: Aov, region: Region, floats: FloatArray, lowest: Double, highest: Double) :
            this(aov, region, lowest, highest, floats, IntArray(0), 1, emptyList()) {
            require(!aov.isInteger) { "'${aov.id}' has integers" }
        }

        /**
         * Creates an image of an AOV whose numbers are integers.
         *
         * @param names see [AovImage.names]; the list is not copied
         * @throws IllegalArgumentException if [aov] has no integers, [ints] has not the right size, [samplesPerPixel]
         *   is below 1, or there are names and [aov] is not [Aov.OBJECT]
         */
        @JvmOverloads
        public constructor(
            aov: Aov,
            region: Region,
            ints: IntArray,
            samplesPerPixel: Int = 1,
            names: List<String> = emptyList(),
        ) : this(aov, region, aov.background, Int.MAX_VALUE.toDouble(), FloatArray(0), ints, samplesPerPixel, names) {
            require(aov.isInteger) { "'${aov.id}' has no integers" }
            require(names.isEmpty() || aov == Aov.OBJECT) { "'${aov.id}' has no names" }
        }

        /** Number of columns. */
        public val width: Int get() = region.width

        /** Number of rows. */
        public val height: Int get() = region.height

        /** The numbers: channels of a pixel, pixels of a row, rows from the top. Empty if [Aov.isInteger]. */
        public val floats: FloatArray get() = reals

        /** The numbers: pixels of a row, rows from the top. Empty unless [Aov.isInteger]. */
        public val ints: IntArray get() = integers

        /**
         * Returns number [channel] of the pixel with the given [index], counted in rows from the top, from 0.
         *
         * @throws IllegalArgumentException if there is no such channel
         * @throws IndexOutOfBoundsException if there is no such pixel
         */
        public fun numberAt(index: Int, channel: Int): Double {
            require(channel in aov.channels.indices) { "channel must be in ${aov.channels.indices}: $channel" }
            val at = index * aov.channels.size + channel
            return if (aov.isInteger) integers[at].toDouble() else reals[at].toDouble()
        }

        /**
         * Returns number [channel] at column [x] and row [y] of the whole picture.
         *
         * @throws IllegalArgumentException if the pixel is not in [region], or there is no such channel
         */
        @JvmOverloads
        public fun number(x: Int, y: Int, channel: Int = 0): Double {
            require(region.contains(x, y)) { "pixel must be within $region: ($x, $y)" }
            return numberAt((y - region.rowStart) * width + x - region.columnStart, channel)
        }

        /**
         * Returns the name of the object at column [x] and row [y] of the whole picture; an empty text if it has none,
         * and null if nothing is visible there.
         *
         * @throws IllegalArgumentException if the pixel is not in [region], or this is not [Aov.OBJECT]
         */
        public fun name(x: Int, y: Int): String? {
            require(aov == Aov.OBJECT) { "'${aov.id}' has no names: ask for '${Aov.OBJECT.id}'" }
            val number = number(x, y).toInt()
            return if (number < 0) null else names.getOrElse(number) { "" }
        }

        /**
         * Returns positions and normals in the coordinates of a model whose axis [up] points up, see [UpAxis.toModel].
         * Other AOVs are returned as they are.
         */
        public fun toModel(up: UpAxis): AovImage {
            if (up == UpAxis.Y || (aov != Aov.NORMAL && aov != Aov.POSITION)) return this
            val turned = FloatArray(reals.size)
            for (at in reals.indices step 3) {
                val v = up.toModel(Vector3d(reals[at].toDouble(), reals[at + 1].toDouble(), reals[at + 2].toDouble()))

                // A sum with 0 makes negative zeros positive
                turned[at] = (v.x + 0.0).toFloat()
                turned[at + 1] = (v.y + 0.0).toFloat()
                turned[at + 2] = (v.z + 0.0).toFloat()
            }
            return AovImage(aov, region, turned, lowest, highest)
        }

        /** Compares what it is, the region and the bits of all numbers. */
        override fun equals(other: Any?): Boolean = other is AovImage && aov == other.aov && region == other.region &&
            reals.contentEquals(other.reals) && integers.contentEquals(other.integers)

        override fun hashCode(): Int = (aov.hashCode() * 31 + reals.contentHashCode()) * 31 + integers.contentHashCode()

        override fun toString(): String = "AovImage(${aov.id}, $region)"
    }
}
