package dev.lazyz.conformance.census

import dev.lazyz.conformance.census.FrameTrait.AMBIENT_VISIBILITY
import dev.lazyz.conformance.census.FrameTrait.CROSSING
import dev.lazyz.conformance.census.FrameTrait.DEEP
import dev.lazyz.conformance.census.FrameTrait.ENVIRONMENT
import dev.lazyz.conformance.census.FrameTrait.FALLOFF
import dev.lazyz.conformance.census.FrameTrait.FORMLESS
import dev.lazyz.conformance.census.FrameTrait.GREATER
import dev.lazyz.conformance.census.FrameTrait.GREATER_OR_EQUAL
import dev.lazyz.conformance.census.FrameTrait.HIDDEN
import dev.lazyz.conformance.census.FrameTrait.LARGER_IS_NEARER
import dev.lazyz.conformance.census.FrameTrait.LESS
import dev.lazyz.conformance.census.FrameTrait.LESS_OR_EQUAL
import dev.lazyz.conformance.census.FrameTrait.LIGHT_INTENSITY
import dev.lazyz.conformance.census.FrameTrait.LINES
import dev.lazyz.conformance.census.FrameTrait.LIT
import dev.lazyz.conformance.census.FrameTrait.MANY_SPANS
import dev.lazyz.conformance.census.FrameTrait.MASKED
import dev.lazyz.conformance.census.FrameTrait.MEETING
import dev.lazyz.conformance.census.FrameTrait.MESH
import dev.lazyz.conformance.census.FrameTrait.MIP_FILTER
import dev.lazyz.conformance.census.FrameTrait.NEAR_PLANE
import dev.lazyz.conformance.census.FrameTrait.NORMAL_MAP
import dev.lazyz.conformance.census.FrameTrait.NOTHING_VISIBLE
import dev.lazyz.conformance.census.FrameTrait.NO_PRIMITIVES
import dev.lazyz.conformance.census.FrameTrait.PHYSICAL
import dev.lazyz.conformance.census.FrameTrait.POINTS
import dev.lazyz.conformance.census.FrameTrait.SECOND_UVS
import dev.lazyz.conformance.census.FrameTrait.SEVERAL_VISIBLE
import dev.lazyz.conformance.census.FrameTrait.SMALLER_IS_NEARER
import dev.lazyz.conformance.census.FrameTrait.SPHERE
import dev.lazyz.conformance.census.FrameTrait.SPOT
import dev.lazyz.conformance.census.FrameTrait.TEXTURED
import dev.lazyz.conformance.census.FrameTrait.TIE
import dev.lazyz.conformance.census.FrameTrait.TONE_MAPPING
import dev.lazyz.conformance.census.FrameTrait.TRANSLUCENT

/**
 * Pairs of traits: those that a run of the suite must contain, those that are impossible, and those that the suite
 * lacks.
 */
internal object PairsOfTraits {
    /** Sets of traits that exclude each other, and why. */
    private val exclusive: List<Pair<String, Set<FrameTrait>>> = listOf(
        "a raster has one depth test" to setOf(LESS, LESS_OR_EQUAL, GREATER, GREATER_OR_EQUAL),
        "a raster has one convention" to setOf(SMALLER_IS_NEARER, LARGER_IS_NEARER),
    )

    /** Traits that exclude each of a set of others, and why. */
    private val excluded: List<Triple<String, FrameTrait, Set<FrameTrait>>> = listOf(
        Triple(
            "what is not there has no traits",
            NO_PRIMITIVES,
            setOf(
                SEVERAL_VISIBLE, TIE, HIDDEN, CROSSING, MEETING, DEEP, MANY_SPANS, TRANSLUCENT, FORMLESS, MESH, SPHERE,
                POINTS, LINES, TEXTURED, MIP_FILTER, SECOND_UVS, NORMAL_MAP, PHYSICAL, ENVIRONMENT, MASKED, NEAR_PLANE,
            ),
        ),
        Triple("ties and crossings are visible", NOTHING_VISIBLE, setOf(SEVERAL_VISIBLE, TIE, CROSSING)),
    )

    private val ofScenes = setOf(
        MESH, SPHERE, POINTS, LINES, SPOT, FALLOFF, LIGHT_INTENSITY, AMBIENT_VISIBILITY, TONE_MAPPING, TEXTURED,
        MIP_FILTER, SECOND_UVS, NORMAL_MAP, PHYSICAL, ENVIRONMENT, MASKED, NEAR_PLANE,
    )

    /**
     * Compatible traits that do not occur together in the suite's frames, or not so that a census finds it, and why.
     */
    private val unmet: List<Triple<String, FrameTrait, Set<FrameTrait>>> = listOf(
        Triple("not every pair with lights is met at the default effort", LIT, FrameTrait.entries.toSet()),
        Triple("surfaces of the suite's scenes are too simple", MANY_SPANS, ofScenes),
    )

    /** Returns why no frame has both; null if some may. */
    fun whyNever(one: FrameTrait, other: FrameTrait): String? =
        exclusive.firstOrNull { (_, set) -> one in set && other in set }?.first ?: reason(excluded, one, other)

    private fun reason(list: List<Triple<String, FrameTrait, Set<FrameTrait>>>, a: FrameTrait, b: FrameTrait): String? =
        list.firstOrNull { (_, trait, set) -> (a == trait && b in set) || (b == trait && a in set) }?.first

    /** All pairs that a run of the suite must contain. */
    val expected: List<Pair<FrameTrait, FrameTrait>> = FrameTrait.entries.flatMap { one ->
        FrameTrait.entries
            .filter { it > one && whyNever(one, it) == null && reason(unmet, one, it) == null }
            .map { one to it }
    }
}
