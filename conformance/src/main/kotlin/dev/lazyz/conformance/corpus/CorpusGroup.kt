package dev.lazyz.conformance.corpus

import dev.lazyz.Depth
import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.Rgba
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.frames.FrameKind
import dev.lazyz.conformance.frames.FrameMix
import dev.lazyz.conformance.frames.Frames
import dev.lazyz.conformance.oracle.ExactPolygon
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.rules.Rule
import dev.lazyz.conformance.rules.Symptom
import java.util.Random
import net.jqwik.api.Shrinkable

/** A scene of the corpus with its name, which can be shrunk. */
internal class CorpusCase(val group: CorpusGroup, val name: String, val shrinkable: Shrinkable<CorpusScene>) {
    val scene: CorpusScene = shrinkable.value()

    /** The scene as JSON. */
    fun json(): String = scene.json(group.members(name))
}

/**
 * Scenes of the corpus for the same rule of the contract, which the suite's generators make.
 *
 * @param mix what the frames are made of
 * @param isPlain whether all have the usual depth test and a transparent background
 * @param needs traits that each frame has
 * @param shapes makes the primitives
 */
internal class CorpusGroup private constructor(
    val rule: SuiteRule,
    private val mix: FrameMix,
    private val isPlain: Boolean = true,
    private val needs: Set<FrameTrait> = emptySet(),
    private val shapes: (List<ExactPolygon>) -> List<CorpusShape> = CorpusShapes::flat,
) {
    /** The scenes: [tries] times the usual number, made from the [suite]'s seed. */
    fun cases(suite: Long, tries: Double): List<CorpusCase> {
        val generator = Frames.of(mix).map(::scene).generator(GENERATOR_SIZE)
        val count = (rule.tries * tries).toInt().coerceAtLeast(1)
        return generateSequence(rule.seed(suite)) { it + 1 }.take(MOST_TRIES * count)
            .map { generator.next(Random(it)) }.filter { isUseful(it.value()) }.take(count)
            .mapIndexed { i, it -> CorpusCase(this, "%02d-%s-%02d".format(level, topic, i + 1), it) }.toList()
    }

    /** The place of the group in the order of difficulty, from 1 on. */
    private val level: Int get() = all.indexOf(this) + 1

    /** The words of the rule's name after its number. */
    private val topic: String get() = rule.name.substringAfterLast('_')

    /** Returns the first members of the JSON of a scene called [name]. */
    fun members(name: String): String =
        "\"corpus\": ${CorpusFiles.VERSION}, \"name\": \"$name\", \"level\": $level,\n" +
            " \"rule\": \"${rule.number}\", \"intent\": \"${rule.intent}\","

    private fun isUseful(scene: CorpusScene): Boolean {
        val traits = Census.traits(scene.frame)
        val isUsual = scene.raster.depthTest == DepthTest.LESS && scene.raster.backgroundDepth == Int.MAX_VALUE
        return FrameTrait.NOTHING_VISIBLE !in traits && traits.containsAll(needs) && (isPlain || !isUsual)
    }

    private fun scene(case: FrameCase): CorpusScene {
        val given = case.frame.raster
        val raster = if (isPlain) {
            Raster(given.width, given.height)
        } else {
            Raster(given.width, given.height, depthTest = given.depthTest, backgroundDepth = given.backgroundDepth)
        }
        val background = CorpusColor.near(if (isPlain) Rgba.TRANSPARENT else given.background)
        return CorpusScene(raster, background, shapes(CorpusShapes.polygons(case, raster)))
    }

    override fun toString(): String = rule.name

    companion object {
        private const val GENERATOR_SIZE = 1000
        private const val SCENES = 20
        private const val MOST_TRIES = 200

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
                shapes = CorpusShapes::triangles,
            ),
            CorpusGroup(
                rule(
                    "2_2_sharedEdges", "A sample on an edge belongs to the area to the right of it, or below it.",
                    "Compare which of >= and > decides at a left edge, a right edge, the upper end and the lower end.",
                    Symptom.COVERAGE,
                ),
                mix(FrameKind.SHARED_EDGES, FrameKind.ON_SAMPLES), needs = setOf(FrameTrait.MEETING),
                shapes = CorpusShapes::triangles,
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
                mix(FrameKind.COINCIDENT, FrameKind.COPLANAR), needs = setOf(FrameTrait.TIE),
                shapes = CorpusShapes::triangles,
            ),
            CorpusGroup(
                rule(
                    "5_3_depthTests", "Depth test, colour and depth of the background are those of the scene.",
                    "Compare the four depth tests, and what the depth buffer has at the beginning.",
                    Symptom.DEPTH_TEST, Symptom.BACKGROUND,
                ),
                mix(FrameKind.COPLANAR, FrameKind.INTERPENETRATING, FrameKind.SHARED_EDGES), isPlain = false,
                shapes = CorpusShapes::triangles,
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
                    "Look for products that overflow 32 bits, and for floats of 24 bits.", Symptom.COVERAGE,
                ),
                mix(FrameKind.GIANT),
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
                    "Compare the order, straight alpha, and what is used after an opaque primitive.",
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
                mix(FrameKind.SCATTERED, FrameKind.ON_SAMPLES), shapes = CorpusShapes::points,
            ),
            CorpusGroup(
                rule(
                    "2_10_lines", "A line covers one run of samples in each row; depth changes along it only.",
                    "Compare the run from the first to the last sample of the quad and of the squares at the ends.",
                    Symptom.COVERAGE,
                ),
                mix(FrameKind.SCATTERED, FrameKind.ON_SAMPLES), shapes = CorpusShapes::lines,
            ),
            CorpusGroup(
                rule(
                    "2_6_spheres", "A sphere has its own outline and depth at each sample.",
                    "Compare the depth of the front half: that of the centre minus the height.", Symptom.COVERAGE,
                ),
                mix(FrameKind.SCATTERED, FrameKind.ON_SAMPLES), shapes = CorpusShapes::spheres,
            ),
        )
    }
}
