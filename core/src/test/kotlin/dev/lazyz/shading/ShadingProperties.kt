package dev.lazyz.shading

import dev.lazyz.Frame
import dev.lazyz.Primitive
import dev.lazyz.SampleScenes
import dev.lazyz.samples
import dev.lazyz.spi.Fragment
import java.util.Random
import java.util.concurrent.Callable
import java.util.concurrent.Executors
import java.util.function.Predicate
import net.jqwik.api.EdgeCasesMode
import net.jqwik.api.ForAll
import net.jqwik.api.Property
import net.jqwik.api.statistics.Statistics
import org.junit.jupiter.api.Assertions.assertEquals

/** Contract rules 6.1 and 3.1: colours and depths are pure functions of primitive and sample. */
class ShadingProperties {
    private class Place(val primitive: Primitive, val x: Int, val y: Int)

    private fun places(frame: Frame): List<Place> = frame.primitives.flatMap { primitive ->
        val covered = primitive.samples(frame.raster)
        val all = ArrayList<Place>()
        for (y in 0 until frame.height) {
            for (x in 0 until frame.width) if (covered[x, y]) all.add(Place(primitive, x, y))
        }
        all
    }

    /** All bits of the colour that [Primitive.shade] stores in a fragment. */
    private fun bits(place: Place, fragment: Fragment): List<Int> {
        fragment.moveTo(place.x, place.y)
        place.primitive.shade(fragment)
        return colour(fragment)
    }

    private fun colour(fragment: Fragment): List<Int> =
        listOf(fragment.red, fragment.green, fragment.blue, fragment.alpha).map { it.toRawBits() } + fragment.toArgb()

    @Property(seed = "1995", tries = 25, edgeCases = EdgeCasesMode.NONE)
    fun rule_6_1_coloursAreTheSameInAnyOrder(@ForAll seed: Long) {
        val places = places(SampleScenes.mixed(Random(seed)).frame(20, 16))
        val fresh = places.map { bits(it, Fragment()) }

        // Interleaved, with one fragment that was used for other primitives
        val fragment = Fragment()
        for (i in places.indices.shuffled(Random(seed))) assertEquals(fresh[i], bits(places[i], fragment))

        // The same primitives set up again, from the last to the first
        val anew = places(SampleScenes.mixed(Random(seed)).frame(20, 16))
        for (i in anew.indices.reversed()) assertEquals(fresh[i], bits(anew[i], fragment))
    }

    @Property(seed = "1995", tries = 5, edgeCases = EdgeCasesMode.NONE)
    fun rule_6_1_coloursAreTheSameFromAnyThread(@ForAll seed: Long) {
        fun colours(places: List<Place>): List<List<Int>> {
            val fragment = Fragment()
            return places.map { bits(it, fragment) }
        }
        val expected = colours(places(SampleScenes.mixed(Random(seed)).frame(20, 16)))

        // Nothing has been shaded yet: both threads must create the edge functions
        val places = places(SampleScenes.mixed(Random(seed)).frame(20, 16))
        val threads = Executors.newFixedThreadPool(2)
        try {
            val answers = threads.invokeAll(List(2) { Callable { colours(places) } })
            for (answer in answers) assertEquals(expected, answer.get())
        } finally {
            threads.shutdown()
        }
    }

    @Property(seed = "1995", tries = 25, edgeCases = EdgeCasesMode.NONE)
    fun rule_3_1_steppedShadingEqualsDirectShading(@ForAll random: Random) {
        val frame = SampleScenes.mixed(random).frame(20, 16)
        val fragment = Fragment()
        var cursors = 0
        for (start in places(frame)) {
            val cursor = start.primitive.shadingCursor(start.x, start.y) ?: continue
            cursors++
            val covered = start.primitive.samples(frame.raster)
            for (x in start.x until minOf(frame.width, start.x + 4)) {
                if (covered[x, start.y]) {
                    fragment.moveTo(x, start.y)
                    cursor.shade(fragment)
                    assertEquals(bits(Place(start.primitive, x, start.y), Fragment()), colour(fragment)) { "column $x" }
                }
                cursor.step()
            }
        }

        // A frame with only constant colours has no steps; most frames have other colours
        Statistics.collect(cursors > 0)
        Statistics.coverage { it.check(true).percentage(Predicate { share -> share > 50.0 }) }
    }
}
