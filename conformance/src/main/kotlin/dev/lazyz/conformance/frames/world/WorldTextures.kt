package dev.lazyz.conformance.frames.world

import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.scenes.Tint
import dev.lazyz.world.material.MipFilter
import dev.lazyz.world.material.Texture
import dev.lazyz.world.material.TextureEncoding
import dev.lazyz.world.material.TextureFilter
import dev.lazyz.world.material.TextureMap
import dev.lazyz.world.material.TextureWrap
import dev.lazyz.world.material.UvTransform
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/** Generates small textures with every filter, and how they are laid on surfaces. */
internal object WorldTextures {
    /** Generates textures of any colours. Half of them are opaque. */
    fun colors(): Arbitrary<Coded<TextureMap>> = maps(TextureEncoding.SRGB, TextureEncoding.LINEAR, 0)

    /** Generates textures of any numbers. */
    fun numbers(): Arbitrary<Coded<TextureMap>> = maps(TextureEncoding.LINEAR, TextureEncoding.SRGB, 0)

    /** Generates textures of normals, whose blue is at least half: they point outward. */
    fun normals(): Arbitrary<Coded<TextureMap>> = maps(TextureEncoding.LINEAR, TextureEncoding.SRGB, 0x80)

    /**
     * Generates textures with the encoding [usual], sometimes [other], whose texels have at least the bits [least].
     * Some have a mip filter, some use the second texture coordinates, some transform the coordinates.
     */
    private fun maps(usual: TextureEncoding, other: TextureEncoding, least: Int): Arbitrary<Coded<TextureMap>> =
        Combinators.combine(textures(usual, other, least), oneOf(0, 0, 0, 1), transforms())
            .`as` { texture, uvSet, transform ->
                val words = listOfNotNull(
                    texture.code,
                    "$uvSet".takeIf { uvSet != 0 || transform != UvTransform.IDENTITY },
                    code(transform).takeIf { transform != UvTransform.IDENTITY },
                )
                Coded(TextureMap(texture.value, uvSet, transform), words.joinToString(", ", "TextureMap(", ")"))
            }

    /** Generates transforms: mostly none, otherwise larger and smaller ones, rotated, mirrored and moved. */
    private fun transforms(): Arbitrary<UvTransform> = mixed(
        3 to Arbitraries.just(UvTransform.IDENTITY),
        1 to oneOf(
            UvTransform(offsetU = 0.5, offsetV = 0.25),
            UvTransform(6.0, 6.0),
            UvTransform(0.5, 2.0, 30.0, 0.25, -0.5),
            UvTransform(-1.0, 1.0, 90.0, 1.0, 0.0),
        ),
    )

    private fun textures(usual: TextureEncoding, other: TextureEncoding, least: Int): Arbitrary<Coded<Texture>> {
        val sizes = oneOf(2 to 2, 1 to 1, 3 to 5, 1 to 4, 8 to 8)
        val wraps = oneOf(*TextureWrap.values())
        val mipFilters = oneOf(MipFilter.NONE, MipFilter.NONE, MipFilter.TRILINEAR, MipFilter.ANISOTROPIC)
        val encodings = oneOf(usual, usual, usual, usual, other)
        return Combinators
            .combine(sizes, ints(0, 0xFF), oneOf(*TextureFilter.values()), wraps, wraps, mipFilters, encodings)
            .`as` { (width, height), seed, filter, wrapU, wrapV, mipFilter, encoding ->
                val texels = IntArray(width * height) { texel(seed, it) or least }
                val words = listOfNotNull(
                    "$width, $height, intArrayOf(${texels.joinToString()})",
                    "TextureFilter.$filter, TextureWrap.$wrapU, TextureWrap.$wrapV",
                    "mipFilter = MipFilter.$mipFilter".takeIf { mipFilter != MipFilter.NONE },
                    "encoding = TextureEncoding.$encoding".takeIf { encoding != TextureEncoding.SRGB },
                )
                Coded(
                    Texture(
                        width, height, texels, filter, wrapU, wrapV, mipFilter = mipFilter, encoding = encoding,
                    ),
                    words.joinToString(", ", "Texture(", ")"),
                )
            }
    }

    /** Returns any colour. Half of all textures are opaque. */
    private fun texel(seed: Int, number: Int): Int {
        val bits = Tint.hash(seed, number, 0, 0)
        val alpha = if (seed % 2 == 0) 0xFF else ALPHAS[bits ushr 24 and 3]
        return alpha shl 24 or (bits and 0xFFFFFF)
    }

    private val ALPHAS = intArrayOf(0xFF, 0xFF, 0x80, 0)

    private fun code(it: UvTransform): String =
        "UvTransform(${it.scaleU}, ${it.scaleV}, ${it.rotation}, ${it.offsetU}, ${it.offsetV})"
}
