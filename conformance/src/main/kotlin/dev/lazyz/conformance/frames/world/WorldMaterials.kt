package dev.lazyz.conformance.frames.world

import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.Coded
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.cases.ints
import dev.lazyz.conformance.cases.mixed
import dev.lazyz.conformance.cases.oneOf
import dev.lazyz.world.material.AlphaMode
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Shading
import dev.lazyz.world.material.Sides
import net.jqwik.api.Arbitraries
import net.jqwik.api.Arbitrary
import net.jqwik.api.Combinators

/**
 * Generates materials: every shading, highlights, emission, masks, one and two sides; and what [WorldMaps] adds, for
 * example textures.
 */
internal object WorldMaterials {
    /** Colours whose components are multiples of 1/8, mostly opaque. */
    val colors: Arbitrary<Rgba> = Combinators
        .combine(ints(0, 0x1FF), oneOf(1f, 1f, 1f, 1f, 0.5f, 0.5f, 0.75f, 0.25f, 0f))
        .`as` { bits, alpha -> Rgba((bits and 7) / 8f, (bits shr 3 and 7) / 8f, (bits shr 6) / 8f, alpha) }

    /** Generates materials that do not blend. Some have a mask. */
    fun opaque(): Arbitrary<Coded<Material>> =
        materials(mixed(8 to Arbitraries.just(AlphaMode.OPAQUE), 1 to Arbitraries.just(AlphaMode.MASK)))

    /** Generates materials most of which blend. */
    fun blended(): Arbitrary<Coded<Material>> =
        materials(mixed(6 to Arbitraries.just(AlphaMode.BLEND), 2 to oneOf(AlphaMode.OPAQUE, AlphaMode.MASK)))

    /**
     * Generates materials that are lit with the normals of the vertices and visible from both sides. Some have a normal
     * map.
     */
    fun twoSided(): Arbitrary<Coded<Material>> = Combinators
        .combine(
            colors, oneOf(Shading.PHONG, Shading.BLINN_PHONG, Shading.GOURAUD), highlights(), WorldMaps.onlyNormals(),
        )
        .`as` { color, shading, highlight, normals ->
            coded(Look(color, shading, highlight, Rgba.BLACK), Cut(), normals)
        }

    private fun materials(modes: Arbitrary<AlphaMode>): Arbitrary<Coded<Material>> {
        val emissions = mixed(3 to Arbitraries.just(Rgba.BLACK), 1 to colors.map { it.scaled(0.25f) })
        val shadings = oneOf(Shading.PHONG, Shading.BLINN_PHONG, Shading.GOURAUD, Shading.CONSTANT, Shading.FLAT)
        val looks = Combinators.combine(colors, shadings, highlights(), emissions).`as`(::Look)
        val sides = mixed(11 to Arbitraries.just(Sides.BOTH), 1 to Arbitraries.just(Sides.FRONT))
        val cuts = Combinators.combine(modes, oneOf(0.5f, 0.25f, 128 / 255f), sides).`as`(::Cut)
        return Combinators.combine(looks, cuts, WorldMaps.any()).`as`(::coded)
    }

    /** Generates no highlight, or an exponent and a colour. */
    private fun highlights(): Arbitrary<Highlight> = mixed(
        2 to Arbitraries.just(Highlight(Rgba.BLACK, 32)),
        3 to Combinators.combine(colors, oneOf(1, 2, 5, 32, 1024)).`as`(::Highlight),
    )

    private class Highlight(val color: Rgba, val shininess: Int)

    private class Look(val color: Rgba, val shading: Shading, val highlight: Highlight, val emission: Rgba,)

    private class Cut(val mode: AlphaMode = AlphaMode.OPAQUE, val cutoff: Float = 0.5f, val sides: Sides = Sides.BOTH,)

    private fun coded(look: Look, cut: Cut, changes: List<MaterialChange>): Coded<Material> {
        val highlight = look.highlight
        val words = listOfNotNull(
            code(look.color),
            "shading = Shading.${look.shading}",
            "specular = ${code(highlight.color)}, shininess = ${highlight.shininess}"
                .takeIf { highlight.color != Rgba.BLACK },
            "emission = ${code(look.emission)}".takeIf { look.emission != Rgba.BLACK },
            "alphaMode = AlphaMode.${cut.mode}".takeIf { cut.mode != AlphaMode.OPAQUE },
            "alphaCutoff = ${code(cut.cutoff)}".takeIf { cut.mode == AlphaMode.MASK },
            "sides = Sides.${cut.sides}".takeIf { cut.sides != Sides.BOTH },
        )
        val cutoff = if (cut.mode == AlphaMode.MASK) cut.cutoff else 0.5f
        val plain = Material(
            look.color, null, look.shading, highlight.color, highlight.shininess, look.emission, cut.mode, cutoff,
            cut.sides,
        )
        return Coded(
            changes.fold(plain) { material, change -> change.value(material) },
            words.joinToString(prefix = "Material(", postfix = ")") + changes.joinToString("") { it.code },
        )
    }
}
