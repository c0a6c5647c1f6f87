package dev.lazyz.conformance.cases

import dev.lazyz.Frame
import dev.lazyz.Image
import dev.lazyz.Region
import dev.lazyz.Renderer
import dev.lazyz.conformance.frames.MixedCases
import dev.lazyz.conformance.frames.TranslucentCases
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.shared.NotByDefault
import dev.lazyz.strategies.Renderers
import java.util.Random
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.lifecycle.AddLifecycleHook
import org.junit.jupiter.api.Assertions.assertEquals

/**
 * Contract rule 5.1: a frame may be rendered in parts, by primitives or by regions, by several renderers, and merged in
 * any order. Tests the laws of the minimum of a total order over random splits.
 */
@AddLifecycleHook(NotByDefault::class)
class PartsProperties {
    @Property(tries = 200, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_1_partsByPrimitivesMergeInAnyOrder(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val random = Random(salt)
        val frame = case.frame
        assertEquals(whole(frame), merge(byPrimitives(frame, random), frame, random)) { "$case" }
    }

    @Property(tries = 200, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_1_partsByRegionsMergeInAnyOrder(
        @ForAll(supplier = MixedCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val random = Random(salt)
        val frame = case.frame
        val parts = split(frame.region, random, 4).map { renderer(random).render(frame.within(it)) }
        assertEquals(whole(frame), merge(parts, frame, random)) { "$case" }
    }

    @Property(tries = 100, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_5_translucentFramesMergeByRegions(
        @ForAll(supplier = TranslucentCases::class) case: FrameCase,
        @ForAll salt: Long,
    ) {
        val random = Random(salt)
        val frame = case.frame
        val parts = split(frame.region, random, 4).map { ReferenceRenderer().render(frame.within(it)) }
        assertEquals(ReferenceRenderer().render(frame), merge(parts, frame, random)) { "$case" }
    }

    @Property(tries = 100, seed = SEED, edgeCases = EdgeCasesMode.NONE)
    fun rule_5_1_mergingHasItsLaws(@ForAll(supplier = MixedCases::class) case: FrameCase, @ForAll salt: Long) {
        val random = Random(salt)
        val frame = case.frame
        val (a, b, c) = List(3) { byPrimitives(frame.within(split(frame.region, random, 2)[0]), random)[0] }
        fun and(x: Image, y: Image) = Image.merge(x, y, frame.raster)

        val nothing = renderer(random).render(frame.within(a.region).keeping { false })
        assertEquals(a, and(a, nothing)) { "identity\n$case" }
        assertEquals(a, and(nothing, a)) { "identity\n$case" }
        assertEquals(a, and(a, a)) { "idempotence\n$case" }
        assertEquals(and(a, b), and(b, a)) { "commutativity\n$case" }
        assertEquals(and(and(a, b), c), and(a, and(b, c))) { "associativity\n$case" }
    }

    /** Parts that together have all primitives, some in several of them, each rendered by another renderer. */
    private fun byPrimitives(frame: Frame, random: Random): List<Image> {
        val count = 1 + random.nextInt(4)
        val owners = List(frame.primitives.size) { List(1 + random.nextInt(2)) { random.nextInt(count) } }
        return List(count) { part -> renderer(random).render(frame.keeping { part in owners[it] }) }
    }

    /** Splits a region in two, and the parts again, up to [depth] times. */
    private fun split(region: Region, random: Random, depth: Int): List<Region> {
        if (depth == 0 || random.nextInt(5) == 0) return listOf(region)
        val isWide = random.nextBoolean()
        val side = if (isWide) region.width else region.height
        if (side == 1) return listOf(region)
        val cut = 1 + random.nextInt(side - 1)
        val parts = with(region) {
            if (isWide) {
                val column = columnStart + cut
                listOf(Region(columnStart, rowStart, column, rowEnd), Region(column, rowStart, columnEnd, rowEnd))
            } else {
                val row = rowStart + cut
                listOf(Region(columnStart, rowStart, columnEnd, row), Region(columnStart, row, columnEnd, rowEnd))
            }
        }
        return parts.flatMap { split(it, random, depth - 1) }
    }

    /** Merges any two parts, until only one is left. */
    private fun merge(parts: List<Image>, frame: Frame, random: Random): Image {
        val open = ArrayList(parts)
        while (open.size > 1) {
            val first = open.removeAt(random.nextInt(open.size))
            val second = open.removeAt(random.nextInt(open.size))
            open.add(Image.merge(first, second, frame.raster))
        }
        return open.single()
    }

    private fun whole(frame: Frame): Image = Renderers.builtIn.first().render(frame)

    private fun renderer(random: Random): Renderer = Renderers.builtIn[random.nextInt(Renderers.builtIn.size)]

    private companion object {
        const val SEED = "1995"
    }
}
