package dev.lazyz.world.material

import dev.lazyz.Rgba
import dev.lazyz.spi.Fragment
import kotlin.math.ceil
import kotlin.math.sqrt

/**
 * An image that colours a surface.
 *
 * Texture coordinates: u increases to the right and v downward; (0, 0) is the upper left corner of the upper left texel
 * and (1, 1) the lower right corner of the lower right one. This is the convention of glTF; a v of OBJ becomes `1 - v`.
 * Texels are 8-bit with straight alpha, `0xAARRGGBB`, in rows from the top. Filtering uses linear light.
 *
 * With a [mipFilter], the smaller copies of the image are computed when a sample first needs one; they take a third of
 * the image's memory. Samples with little of the texture in each, as in a close view, cost the same as without.
 *
 * The array of texels is not copied; do not change it. Immutable and thread safe.
 *
 * Sources: Lance Williams, "Pyramidal Parametrics", SIGGRAPH 1983; Paul Heckbert, "Fundamentals of Texture Mapping and
 * Image Warping", 1989, for the footprint; J. McCormack et al., "Feline: Fast Elliptical Lines for Anisotropic Texture
 * Mapping", SIGGRAPH 1999, for lookups along the longer axis, here all with the same weight.
 *
 * @property filter sampling between texels
 * @property wrapU sampling outside 0..1 in the direction of u
 * @property wrapV sampling outside 0..1 in the direction of v
 * @property name name for messages and files
 * @property mipFilter sampling where many texels fall on one sample
 */
public class Texture private constructor(
    private val levels: MipLevels,
    public val filter: Texture.Filter,
    public val wrapU: Texture.Wrap,
    public val wrapV: Texture.Wrap,
    public val name: String,
    public val mipFilter: MipFilter,
) {
    /**
     * Creates a texture; see the properties.
     *
     * @param argb the texels, width x height
     * @throws IllegalArgumentException if a side is not positive or [argb] does not hold width x height texels
     */
    @JvmOverloads
    public constructor(
        width: Int,
        height: Int,
        argb: IntArray,
        filter: Texture.Filter = Texture.Filter.BILINEAR,
        wrapU: Texture.Wrap = Texture.Wrap.REPEAT,
        wrapV: Texture.Wrap = Texture.Wrap.REPEAT,
        name: String = "",
        mipFilter: MipFilter = MipFilter.NONE,
        encoding: Texture.Encoding = Texture.Encoding.SRGB,
    ) : this(MipLevels(TextureLevel(width, height, argb, encoding)), filter, wrapU, wrapV, name, mipFilter)

    private val image: TextureLevel = levels.image

    /** Number of columns, at least 1. */
    public val width: Int get() = image.width

    /** Number of rows, at least 1. */
    public val height: Int get() = image.height

    /** What the codes mean. */
    public val encoding: Texture.Encoding get() = image.encoding

    /** Whether any texel is not fully opaque. Cost: one pass over the texels, once. */
    public val hasAlpha: Boolean get() = levels.hasAlpha

    /**
     * The mean of all texels in linear light, weighted by alpha; if all are transparent, the plain mean. Its alpha is
     * the mean of theirs. Cost: one pass over the texels, once.
     */
    public val meanColor: Rgba get() = levels.mean

    /**
     * Returns the texel at column [x] and row [y] as `0xAARRGGBB`.
     *
     * @throws IllegalArgumentException if [x] is not in 0 until [width], or [y] not in 0 until [height]
     */
    public fun texel(x: Int, y: Int): Int {
        require(x in 0 until width && y in 0 until height) { "texel must be within $width x $height: ($x, $y)" }
        return image.argb[y * width + x]
    }

    /** Returns this texture with other sampling rules; the texels are shared. */
    @JvmOverloads
    public fun withSampling(
        filter: Texture.Filter,
        wrapU: Texture.Wrap,
        wrapV: Texture.Wrap,
        mipFilter: MipFilter = this.mipFilter,
    ): Texture = Texture(levels, filter, wrapU, wrapV, name, mipFilter)

    /** Returns this texture with another [mipFilter]; the texels are shared. */
    public fun withMipFilter(mipFilter: MipFilter): Texture = withSampling(filter, wrapU, wrapV, mipFilter)

    /** Returns this texture with another meaning of its codes; the texels are shared. */
    public fun withEncoding(encoding: Texture.Encoding): Texture = if (encoding == this.encoding) {
        this
    } else {
        Texture(width, height, image.argb, filter, wrapU, wrapV, name, mipFilter, encoding)
    }

    /** Returns this texture with another [name]; the texels are shared. */
    public fun withName(name: String): Texture = Texture(levels, filter, wrapU, wrapV, name, mipFilter)

    /**
     * Samples the texture at ([u], [v]) and stores red, green, blue (linear) and alpha, each in 0..1, in [out] at 0..3.
     * Does not use the [mipFilter].
     *
     * A coordinate that is NaN or infinite is treated as texel position 0. Cost: one texel with
     * [Texture.Filter.NEAREST], four with [Texture.Filter.BILINEAR]; no allocation.
     */
    public fun sample(u: Float, v: Float, out: FloatArray) {
        out.fill(0f, 0, 4)
        image.add(this, u.toDouble(), v.toDouble(), 1f, out)
    }

    /**
     * Samples the texture at ([u], [v]) with the [mipFilter], and stores the result as the other [sample]. The
     * derivatives say how the coordinates change to the next column and to the next row, see [Fragment.dudx]; they span
     * the footprint of the sample, an ellipse in the texture.
     *
     * A footprint that is not larger than a texel, or NaN, costs one lookup in the image, as without mip levels;
     * otherwise, a lookup of a level is twice that, see [MipFilter].
     */
    public fun sample(u: Float, v: Float, dudx: Float, dvdx: Float, dudy: Float, dvdy: Float, out: FloatArray) {
        // The footprint in texels, x M x = 1, and the squares of its axes: the eigenvalues of M
        if (mipFilter == MipFilter.NONE) return sample(u, v, out)
        val ax = dudx.toDouble() * width
        val ay = dvdx.toDouble() * height
        val bx = dudy.toDouble() * width
        val by = dvdy.toDouble() * height
        val xx = ax * ax + bx * bx
        val yy = ay * ay + by * by
        val xy = ax * ay + bx * by
        val mean = (xx + yy) / 2
        val half = (xx - yy) / 2
        val root = sqrt(half * half + xy * xy)
        val longest = mean + root
        if (!(longest > 1.0)) return sample(u, v, out)
        out.fill(0f, 0, 4)
        if (mipFilter == MipFilter.TRILINEAR || longest > LONGEST) {
            return addLevels(u.toDouble(), v.toDouble(), longest, 1f, out)
        }

        // Lookups along the longer axis, each with a footprint as round as possible, and not smaller than a texel
        val major = sqrt(longest)
        val minor = sqrt(maxOf(mean - root, 1.0))
        val probes = ceil(minOf(major / minor, MAX_PROBES.toDouble())).toInt()
        if (probes == 1) return addLevels(u.toDouble(), v.toDouble(), longest, 1f, out)
        val directionX = if (half >= 0.0) half + root else xy
        val directionY = if (half >= 0.0) xy else root - half
        val scale = major / sqrt(directionX * directionX + directionY * directionY)
        val du = directionX * scale / width
        val dv = directionY * scale / height
        val weight = 1f / probes
        for (i in 0 until probes) {
            val t = (i + 0.5) / probes - 0.5
            addLevels(u + t * du, v + t * dv, longest / (probes * probes), weight, out)
        }
    }

    /**
     * Adds [weight] times the texture at ([u], [v]) to [out]: the two levels whose texels are nearest in size to a
     * footprint of [square] square texels, with the weights of [MipLevels.levelOf].
     */
    private fun addLevels(u: Double, v: Double, square: Double, weight: Float, out: FloatArray) {
        val level = minOf(MipLevels.levelOf(square), levels.last.toFloat())
        val lower = maxOf(level, 0f).toInt()
        val fraction = maxOf(level, 0f) - lower
        if (fraction < 1f) levels[lower].add(this, u, v, weight * (1f - fraction), out)
        if (fraction > 0f) levels[lower + 1].add(this, u, v, weight * fraction, out)
    }

    override fun toString(): String = "Texture($width x $height, $filter, $mipFilter, $wrapU, $wrapV, \"$name\")"

    /** What the red, green and blue codes of a [Texture] mean. */
    public enum class Encoding {
        /** Colours, with the sRGB curve. */
        SRGB,

        /** Numbers in 0..1, code / 255: for example normals or roughness. */
        LINEAR,
    }

    /** How a [Texture] is sampled between texels. */
    public enum class Filter {
        /** The texel that contains the point. */
        NEAREST,

        /** The four texels around the point, weighted by distance in linear light. */
        BILINEAR,
    }

    /** How a [Texture] is sampled outside 0..1. */
    public enum class Wrap {
        /** The image is repeated. */
        REPEAT,

        /** The nearest texel at the border is used. */
        CLAMP,

        /** The image is repeated, and every other copy is mirrored. */
        MIRROR,
    }

    /** How a [Texture] is sampled where several texels fall on one sample of the picture. */
    public enum class MipFilter {
        /** As if texels were large: single texels are picked, so distant textures can shimmer. */
        NONE,

        /**
         * Smaller copies of the image (mip levels), interpolated between two levels. The level is that of the longer
         * side of the sample's footprint, so surfaces that are seen at an angle are blurred. Two lookups a sample.
         */
        TRILINEAR,

        /**
         * As [TRILINEAR], with up to [Texture.MAX_PROBES] lookups along the longer side of the footprint, and the level
         * of the shorter side: sharp at an angle, too. The best pictures.
         */
        ANISOTROPIC,
    }

    public companion object {
        /** The most lookups of [MipFilter.ANISOTROPIC] for a sample. */
        public const val MAX_PROBES: Int = 16

        /** A footprint whose longer axis has more than this square is as large as any image. */
        private const val LONGEST = 1e12
    }
}
