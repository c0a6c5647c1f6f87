package dev.lazyz.conformance.corpus

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.Rasters
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.oracle.ExactPolygon
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.rules.Rule
import dev.lazyz.conformance.rules.Symptom
import dev.lazyz.scenes.Tint
import java.util.Random
import net.jqwik.api.Shrinkable

/** A scene of the corpus with its name, which can be shrunk. */
internal class CorpusCase(val group: CorpusGroup, val name: String, val shrinkable: Shrinkable<CorpusScene>) {
    val scene: CorpusScene = shrinkable.value()

    /** The scene as JSON. */
    fun json(): String = scene.json(group.members(name))
}

/** What is around the shapes of a group. */
internal enum class Surroundings {
    /** The usual depth test and a transparent background. */
    PLAIN,

    /** The usual depth test and any background. */
    COLORED,

    /** Another depth test, or another depth of the background, which may be that of a shape. */
    ANY,
}

/**
 * Scenes of the corpus for the same rule of the contract, which the suite's generators make.
 *
 * @param mix what the frames are made of
 * @param needs traits that each frame has
 * @param situations each scene has one of them, in turn, at a sample that is compared
 * @param shapes makes the primitives
 */
internal class CorpusGroup private constructor(
    val rule: SuiteRule,
    private val mix: FrameMix,
    private val around: Surroundings = Surroundings.PLAIN,
    private val needs: Set<FrameTrait> = emptySet(),
    private val situations: List<Situation> = listOf({ it.shown != null }),
    private val shapes: (List<ExactPolygon>) -> List<CorpusShape> = CorpusShapes::flat,
) {
    /** The scenes: [tries] times the usual number, made from the [suite]'s seed. */
    fun cases(suite: Long, tries: Double): List<CorpusCase> {
        val generator = Frames.of(mix).map(::scene).generator(GENERATOR_SIZE)
        val count = (rule.tries * tries).toInt().coerceAtLeast(1)
        val made = generateSequence(rule.seed(suite)) { it + 1 }.map { generator.next(Random(it)) }.iterator()
        return List(count) { i ->
            val situation = situations[i % situations.size]
            val found = made.asSequence().take(MOST_TRIES).firstOrNull { isUseful(it.value(), situation) }
            checkNotNull(found) { "$this has no frame for its situation ${i % situations.size}" }
            CorpusCase(this, "%02d-%s-%02d".format(level, topic, i + 1), found)
        }
    }

    /** The place of the group in the order of difficulty, from 1 on. */
    private val level: Int get() = all.indexOf(this) + 1

    /** The words of the rule's name after its number. */
    private val topic: String get() = rule.name.substringAfterLast('_')

    /** Returns the first members of the JSON of a scene called [name]. */
    fun members(name: String): String =
        "\"corpus\": ${CorpusFiles.VERSION}, \"name\": \"$name\", \"level\": $level,\n" +
            " \"rule\": \"${rule.number}\", \"intent\": \"${rule.intent}\","

    private fun isUseful(scene: CorpusScene, situation: Situation): Boolean {
        if (around == Surroundings.ANY && scene.hasUsualDepths) return false
        return scene.shows(situation) && Census.traits(scene.frame).let {
            FrameTrait.NOTHING_VISIBLE !in it && it.containsAll(needs)
        }
    }

    private fun scene(case: FrameCase): CorpusScene {
        val raster = Raster(case.frame.raster.width, case.frame.raster.height)
        val polygons = CorpusShapes.polygons(case, raster)
        val first = polygons.firstOrNull()?.contours?.first() ?: IntArray(3)
        val salt = Tint.hash(first[0], first[1], polygons.size, raster.width)
        val alpha = listOf(191, 255, 64, 16)[salt % 4]
        val color = CorpusColor.of(salt, alpha = alpha).takeIf { around != Surroundings.PLAIN && salt / 4 % 4 > 0 }
        val background = color ?: CorpusColor.NONE
        if (around != Surroundings.ANY) return CorpusScene(raster, background, shapes(polygons))
        val test = DepthTest.entries[salt / 16 % 4]
        val depth = listOf(first[2], Int.MAX_VALUE / 2, Rasters.behindAll(test))[salt / 64 % 3]
        val any = Raster(raster.width, raster.height, depthTest = test, backgroundDepth = depth)
        return CorpusScene(any, background, shapes(polygons))
    }

    override fun toString(): String = rule.name

    companion object {
        private const val GENERATOR_SIZE = 1000
        private const val SCENES = 20
        private const val MOST_TRIES = 2000

        private fun rule(name: String, intent: String, look: String, vararg about: Symptom) =
            SuiteRule("rule_$name", Rule(intent = intent, look = look, about = arrayOf(*about), tries = SCENES))

        private fun mix(vararg kinds: FrameKind) = FrameMix.of(*kinds).sized(24, 20).counted(1, 6)

        /** All groups, from what every renderer can draw to what few can. */
        val all: List<CorpusGroup> = listOf(
            CorpusGroup(
                rule(
                    "2_1_triangles", "A triangle covers the samples inside it.",
                    "Compare the position of samples, at the centres of pixels, and which way rows are counted.",
                    Symptom.COVERAGE,
                ),
                mix(FrameKind.SCATTERED, FrameKind.ON_CORNERS, FrameKind.TINY).counted(1, 2),
                shapes = CorpusShapes::coarse,
            ),
            CorpusGroup(
                rule(
                    "2_2_sharedEdges", "A sample on an edge belongs to the area to the right of it, or below it.",
                    "Compare which of >= and > decides at a left edge, a right edge, the upper end and the lower end.",
                    Symptom.COVERAGE,
                ),
                mix(FrameKind.SHARED_EDGES, FrameKind.ON_SAMPLES), needs = setOf(FrameTrait.MEETING),
                situations = Situations.edges + Situations.sharedEdge, shapes = CorpusShapes::coarse,
            ),
            CorpusGroup(
                rule(
                    "5_1_nearest", "The nearest primitive is visible, whatever the order of submission.",
                    "Compare the depth test, and at which point depth is computed.", Symptom.ORDER,
                ),
                mix(FrameKind.INTERPENETRATING, FrameKind.LAYERED, FrameKind.SHARED_EDGES),
                needs = setOf(FrameTrait.HIDDEN, FrameTrait.SEVERAL_VISIBLE), shapes = CorpusShapes::triangles,
            ),
            CorpusGroup(
                rule(
                    "5_2_ties", "Of several primitives with the same depth, the first is visible.",
                    "Compare whether equal depth passes the test, and whether the order of primitives is kept.",
                    Symptom.TIE,
                ),
                mix(FrameKind.COINCIDENT, FrameKind.COPLANAR), situations = listOf({ it.isTie }),
                shapes = CorpusShapes::triangles,
            ),
            CorpusGroup(
                rule(
                    "5_3_depthTests", "Depth test, colour and depth of the background are those of the scene.",
                    "Compare the four depth tests, and what the depth buffer has at the beginning.",
                    Symptom.DEPTH_TEST, Symptom.BACKGROUND,
                ),
                mix(FrameKind.COPLANAR, FrameKind.INTERPENETRATING, FrameKind.SHARED_EDGES), Surroundings.ANY,
                situations = Situations.ties + Situations.backgroundTies, shapes = CorpusShapes::triangles,
            ),
            CorpusGroup(
                rule(
                    "6_4_encoding", "Colours are linear light and become sRGB; alpha is straight, and stays linear.",
                    "Compare the curve of sRGB at dark colours, and a background with an alpha.",
                    Symptom.COLOR, Symptom.BACKGROUND,
                ),
                mix(FrameKind.SCATTERED, FrameKind.ON_CORNERS).counted(1, 3), Surroundings.COLORED,
                situations = listOf({ it.shown != null }, Situations.background), shapes = CorpusShapes::dark,
            ),
            CorpusGroup(
                rule(
                    "2_4_holes", "Concave polygons, combs, holes and islands are filled by the fill rule.",
                    "Compare how windings of all contours are added, for each fill rule.", Symptom.COVERAGE,
                ),
                mix(FrameKind.CONCAVE, FrameKind.HOLES, FrameKind.COMBS),
            ),
            CorpusGroup(
                rule(
                    "2_4_selfCrossing", "Contours that cross themselves are filled by the fill rule.",
                    "Compare bow ties and stars with each fill rule.", Symptom.COVERAGE,
                ),
                mix(FrameKind.SELF_CROSSING, FrameKind.SCATTERED),
            ),
            CorpusGroup(
                rule(
                    "3_6_colors", "Colours change evenly between the vertices of a triangle.",
                    "Compare where colours are evaluated, and the encoding as sRGB.", Symptom.COLOR,
                ),
                mix(FrameKind.SCATTERED, FrameKind.SHARED_EDGES), shapes = { CorpusShapes.mixed(it, 1) },
            ),
            CorpusGroup(
                rule(
                    "3_6_perspective", "Colours are divided by w at the vertices, and multiplied at the sample.",
                    "Compare the weights: each edge function divided by w, then divided by their sum.", Symptom.COLOR,
                ),
                mix(FrameKind.SCATTERED, FrameKind.LAYERED), shapes = { CorpusShapes.mixed(it, 8) },
            ),
            CorpusGroup(
                rule(
                    "9_1_clipped", "Polygons that the near plane has cut are polygons like all others.",
                    "Compare vertices far outside the raster, and polygons with more corners than they had.",
                    Symptom.COVERAGE,
                ),
                mix(FrameKind.NEAR_PLANE, FrameKind.MESHES, FrameKind.POLYGONS_IN_SPACE),
            ),
            CorpusGroup(
                rule(
                    "1_4_guardBand", "Vertices may be as far away as 2^19 pixels.",
                    "Look for products that overflow 32 or 56 bits, and for floats of 24 bits.", Symptom.COVERAGE,
                ),
                mix(FrameKind.GIANT, FrameKind.SCATTERED), situations = Situations.missedEdges,
                shapes = CorpusShapes::large,
            ),
            CorpusGroup(
                rule(
                    "4_4_fineDepths", "Depths are compared in units of 2^-31 of the range.",
                    "Look for a depth buffer of 24 bits, or of floats.", Symptom.DEPTH, Symptom.ORDER,
                ),
                mix(FrameKind.NEARLY_COPLANAR, FrameKind.TOUCHING), needs = setOf(FrameTrait.HIDDEN),
            ),
            CorpusGroup(
                rule(
                    "3_4_slivers", "Slivers that are too steep have one depth; what has no area covers nothing.",
                    "Look for a division by an area of zero, and for depths outside the range.", Symptom.COVERAGE,
                ),
                mix(FrameKind.SLIVERS, FrameKind.TINY, FrameKind.DEGENERATE),
            ),
            CorpusGroup(
                rule(
                    "5_5_translucent", "Translucent primitives are blended in the order of depth, in linear light.",
                    "Compare the order, straight alpha, and that nothing is used after an opaque primitive.",
                    Symptom.TRANSLUCENT,
                ),
                mix(FrameKind.LAYERED, FrameKind.INTERPENETRATING, FrameKind.COPLANAR).counted(2, 8),
                needs = setOf(FrameTrait.TRANSLUCENT), shapes = CorpusShapes::glass,
            ),
            CorpusGroup(
                rule(
                    "2_9_points", "A point is a square around its vertex, with one depth.",
                    "Compare the ends of the square: the left and upper side belong to it.", Symptom.COVERAGE,
                ),
                mix(FrameKind.ON_CORNERS, FrameKind.ON_SAMPLES), situations = Situations.edges,
                shapes = CorpusShapes::points,
            ),
            CorpusGroup(
                rule(
                    "2_10_lines", "A line is a quad with a square at each end; its depth changes along it only.",
                    "Compare the ends, lines without a length, and the depth beyond the ends.",
                    Symptom.COVERAGE,
                ),
                mix(FrameKind.SCATTERED, FrameKind.ON_SAMPLES), situations = Situations.lineEnds,
                shapes = CorpusShapes::lines,
            ),
            CorpusGroup(
                rule(
                    "2_6_spheres", "A sphere has its own outline and depth at each sample.",
                    "Compare the depth of the front half: that of the centre minus the height.", Symptom.COVERAGE,
                ),
                mix(FrameKind.SCATTERED, FrameKind.ON_SAMPLES),
                situations = listOf(Situations.outline, { it.shown != null }), shapes = CorpusShapes::spheres,
            ),
            CorpusGroup(
                rule(
                    "5_5_backdrops",
                    "Everything translucent is blended with what wins against the background, and with it.",
                    "Compare depth tests, what loses against the background, mixed alphas and an alpha of 0.",
                    Symptom.TRANSLUCENT, Symptom.BACKGROUND, Symptom.DEPTH_TEST,
                ),
                mix(FrameKind.LAYERED, FrameKind.COPLANAR, FrameKind.ON_CORNERS).counted(2, 6), Surroundings.ANY,
                situations = Situations.blended, shapes = CorpusShapes::allKinds,
            ),
        )
    }
}
