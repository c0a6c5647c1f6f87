package dev.lazyz.conformance.frames

import dev.lazyz.conformance.cases.CodeReader
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.shared.NotByDefault
import java.util.Random
import net.jqwik.api.Example
import net.jqwik.api.Shrinkable
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue

/**
 * Each kind of frame often has the property that its name says. Frames shrink, and print the code that creates them.
 */
@AddLifecycleHook(NotByDefault::class)
class FrameMixTest {
    @Example
    fun usualMixIsFullOfDifficulties() {
        val traits = some(FrameMix.usual()).map { PictureTrait.of(it.frame) }
        assertTrue(traits.count { PictureTrait.EMPTY in it } < traits.size / 3)
        for (trait in PictureTrait.entries - PictureTrait.TRANSLUCENT) {
            val least = if (trait == PictureTrait.TIED || trait == PictureTrait.INTERPENETRATING) 0.1 else 0.05
            assertTrue(share(traits, trait) > least) { "$trait: ${share(traits, trait)}" }
        }
    }

    @Example
    fun kindsOfPolygonsAreWhatTheyAreNamedAfter() {
        assertPolygons(0.9, FrameKind.ON_SAMPLES) { c -> c.points().all { (x, y) -> isHalf(x) && isHalf(y) } }
        assertPolygons(0.9, FrameKind.ON_CORNERS) { c -> c.points().all { (x, y) -> isWhole(x) && isWhole(y) } }
        assertPolygons(0.9, FrameKind.SLIVERS) { c -> Math.abs(c.area()) < 0.02 * c.length() + 1e-9 }
        assertPolygons(0.9, FrameKind.TINY) { c -> Math.abs(c.area()) < 9.0 }
        assertPolygons(0.9, FrameKind.CONCAVE) { c -> c.turns().let { true in it && false in it } }
        assertPolygons(0.3, FrameKind.GIANT) { c -> c.points().any { (x, y) -> Math.abs(x) + Math.abs(y) > 1e5 } }
        assertPolygons(0.9, FrameKind.COPLANAR) { c ->
            c.indices.filter { it % 3 == 2 }.map { c[it] }.toSet().size == 1
        }
        assertPolygons(0.9, FrameKind.SELF_CROSSING, ::crossesItself)
    }

    @Example
    fun kindsOfGroupsAreWhatTheyAreNamedAfter() {
        assertFrames(0.9, FrameKind.HOLES) { polygons, _ -> polygons.any { it.size >= 2 } }
        assertFrames(0.7, FrameKind.SHARED_EDGES) { polygons, _ ->
            val edges = polygons.flatten().flatMap { it.edges() }
            edges.any { (from, to) -> Pair(to, from) in edges }
        }
        assertFrames(0.8, FrameKind.COINCIDENT) { polygons, _ ->
            polygons.map { p -> p.map { it.toList() } }.let { it.toSet().size < it.size }
        }
        assertFrames(0.4, FrameKind.COINCIDENT) { _, traits -> PictureTrait.TIED in traits }
        assertFrames(0.5, FrameKind.COPLANAR) { _, traits -> PictureTrait.TIED in traits }
        assertFrames(0.5, FrameKind.INTERPENETRATING) { _, traits -> PictureTrait.INTERPENETRATING in traits }
        assertFrames(0.7, FrameKind.LAYERED) { _, traits -> PictureTrait.DEEP in traits }
        assertFrames(0.9, FrameKind.DEGENERATE) { _, traits ->
            PictureTrait.USELESS in traits ||
                PictureTrait.EMPTY in traits
        }
        assertFrames(0.5, FrameKind.CONFETTI) { _, traits -> PictureTrait.SEVERAL_SPANS in traits }
        assertFrames(0.3, FrameKind.HOLES) { _, traits -> PictureTrait.SEVERAL_SPANS in traits }
        assertFrames(0.3, FrameKind.SELF_CROSSING) { _, traits -> PictureTrait.SEVERAL_SPANS in traits }
    }

    @Example
    fun kindsInSpaceAreWhatTheyAreNamedAfter() {
        for ((kind, word) in listOf(
            FrameKind.SPHERES to "Sphere(",
            FrameKind.MESHES to "Mesh(",
            FrameKind.POLYGONS_IN_SPACE to "Polygon(",
            FrameKind.POINTS to "Points(",
            FrameKind.LINES to "Lines(",
        )) {
            val cases = some(FrameMix.of(kind).counted(1, 5))
            assertTrue(cases.all { word in it.code }) { "$kind" }
            assertTrue(cases.count { PictureTrait.EMPTY !in PictureTrait.of(it.frame) } > cases.size / 3) { "$kind" }
        }
        val spheres = some(FrameMix.of(FrameKind.SPHERES)).map { PictureTrait.of(it.frame) }
        assertTrue(share(spheres, PictureTrait.CURVED) > 0.5)
    }

    @Example
    fun nearPlaneIsCrossed() {
        val cases = some(FrameMix.of(FrameKind.NEAR_PLANE).counted(1, 3))
        val crossings = cases.count { case ->
            val eye = Regex("Camera\\.\\w+\\(Vector3d\\(([^)]*)\\)").find(case.code)!!.numbers()
            val length = Math.sqrt(eye.sumOf { it * it })
            val distances = Regex("Vertex\\(([^)]*)\\)").findAll(case.code).map { vertex ->
                val at = vertex.numbers()
                (0 until 3).sumOf { (eye[it] - at[it]) * eye[it] } / length
            }.toList()
            distances.any { it < 0.5 } && distances.any { it > 0.5 }
        }
        assertTrue(crossings > 0.9 * cases.size) { "$crossings of ${cases.size}" }
        assertTrue(cases.count { PictureTrait.EMPTY !in PictureTrait.of(it.frame) } > cases.size / 4)
    }

    @Example
    fun numbersAreObeyed() {
        val mix = FrameMix.of(FrameKind.SCATTERED).sized(7, 5).counted(2, 4).layered(3)
        for (case in some(mix)) {
            assertTrue(case.frame.width <= 7 && case.frame.height <= 5)
            assertTrue(case.frame.primitives.size in 5..7)
            assertTrue(PictureTrait.DEEP in PictureTrait.of(case.frame)) { case.code }
        }
        val depths = some(FrameMix.of(FrameKind.SCATTERED).levels(3)).flatMap { read(it).polygons.flatten() }
            .flatMap { c -> c.indices.filter { it % 3 == 2 }.map { c[it] } }.toSet()
        assertEquals(setOf(0.0, 0.5, 1.0), depths)
        val glazed = some(FrameMix.usual().counted(1, 8).translucent(50)).count { it.frame.hasTranslucency }
        assertTrue(glazed in 60..160) { "$glazed" }
    }

    @Example
    fun printedCodeMakesTheSameFrame() {
        val onScreen = FrameKind.entries.filter { !it.isInSpace }.toTypedArray()
        val mixed = some(FrameMix.of(*onScreen).translucent(30))
        for (case in mixed + some(Frames.screen(), 200) + some(Frames.tied(), 200)) {
            val frame = CodeReader(case.code).frame()
            assertEquals(ReferenceRenderer().render(case.frame), ReferenceRenderer().render(frame)) { case.code }
        }
    }

    @Example
    fun framesShrinkToWhatIsReadable() {
        val random = Random(1995)
        val frames = Frames.of(FrameMix.usual().with(FrameKind.CONFETTI, 0)).generator(1000)
        var longest = 0
        repeat(2) {
            var smallest = generateSequence { frames.next(random) }.first { isTied(it) }
            repeat(200) { smallest = smallest.shrink().filter(::isTied).findFirst().orElse(smallest) }
            val case = smallest.value()
            assertTrue(case.frame.primitives.size <= 3) { case.code }
            longest = maxOf(longest, case.code.lines().size)
        }
        assertTrue(longest <= 10) { "$longest lines" }
    }

    private fun isTied(case: Shrinkable<FrameCase>) = PictureTrait.TIED in PictureTrait.of(case.value().frame)

    @Example
    fun nonsenseIsRefused() {
        for (wrong in listOf<() -> Unit>(
            { FrameMix.of() },
            { FrameMix.usual().sized(0, 1) },
            { FrameMix.usual().counted(3, 2) },
            { FrameMix.usual().with(FrameKind.TINY, -1) },
            { FrameMix.usual().translucent(101) },
            { Frames.of(FrameMix.of(FrameKind.TINY).with(FrameKind.TINY, 0)) },
        )) {
            assertThrows(IllegalArgumentException::class.java) { wrong() }
        }
    }

    private fun some(mix: FrameMix): List<FrameCase> = some(Frames.of(mix), 200)

    private fun read(case: FrameCase) = CodeReader(case.code).also { it.frame() }

    private fun share(traits: List<Set<PictureTrait>>, trait: PictureTrait): Double =
        traits.count { trait in it }.toDouble() / traits.size

    private fun assertPolygons(part: Double, kind: FrameKind, property: (DoubleArray) -> Boolean) {
        val contours = some(FrameMix.of(kind)).flatMap { read(it).polygons.flatten() }
        val count = contours.count(property)
        assertTrue(count >= part * contours.size) { "$kind: $count of ${contours.size}" }
    }

    private fun assertFrames(
        part: Double,
        kind: FrameKind,
        property: (List<List<DoubleArray>>, Set<PictureTrait>) -> Boolean,
    ) {
        val cases = some(FrameMix.of(kind).counted(2, 8))
        val count = cases.count { property(read(it).polygons, PictureTrait.of(it.frame)) }
        assertTrue(count >= part * cases.size) { "$kind: $count of ${cases.size}" }
    }

    private fun MatchResult.numbers(): List<Double> = groupValues[1].split(", ").take(3).map { it.toDouble() }

    private fun isWhole(x: Double) = x == Math.rint(x)

    private fun isHalf(x: Double) = isWhole(x - 0.5)

    private fun DoubleArray.points(): List<Pair<Double, Double>> = (0 until size / 3).map {
        this[3 * it] to
            this[3 * it + 1]
    }

    private fun DoubleArray.edges(): List<Pair<Pair<Double, Double>, Pair<Double, Double>>> =
        points().let { p -> p.indices.map { p[it] to p[(it + 1) % p.size] } }

    private fun DoubleArray.area(): Double =
        edges().sumOf { (a, b) ->
            (a.first - this[0]) * (b.second - this[1]) -
                (b.first - this[0]) * (a.second - this[1])
        }

    private fun DoubleArray.length(): Double = edges().sumOf { (a, b) ->
        Math.hypot(b.first - a.first, b.second - a.second)
    }

    /** Returns whether the contour turns right, for each vertex. */
    private fun DoubleArray.turns(): Set<Boolean> = edges().let { e ->
        e.indices.map { side(e[it].first, e[it].second, e[(it + 1) % e.size].second) > 0 }.toSet()
    }

    private fun side(a: Pair<Double, Double>, b: Pair<Double, Double>, p: Pair<Double, Double>): Double =
        (b.first - a.first) * (p.second - a.second) - (b.second - a.second) * (p.first - a.first)

    private fun crossesItself(contour: DoubleArray): Boolean {
        val edges = contour.edges()
        return edges.any { (a, b) ->
            edges.any { (c, d) ->
                side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0
            }
        }
    }
}
