package dev.lazyz.spark.triangles

import dev.lazyz.Region
import java.util.Random
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

class FragmentRunsTest {
    private val region = Region(10, 20, 110, 90)

    @Test
    fun fragmentsSurvive() {
        val random = Random(1)
        for (density in listOf(0.0, 0.01, 0.5, 1.0)) {
            for (isShaded in listOf(true, false)) {
                val given = ArrayList<List<Long>>()
                val runs = FragmentRuns.Builder(isShaded)
                for (sample in 0 until region.size.toInt()) {
                    if (random.nextDouble() >= density) continue
                    val key = random.nextLong() and Long.MAX_VALUE
                    val color = random.nextInt()
                    runs.add(sample, key, color)
                    given += listOf(10L + sample % 100, 20L + sample / 100, key, if (isShaded) color.toLong() else 0L)
                }
                val found = ArrayList<List<Long>>()
                runs.build().forEach(region) { x, y, key, color ->
                    found += listOf(x.toLong(), y.toLong(), key, color.toLong())
                }
                assertEquals(given, found)
            }
        }
    }

    @Test
    fun smoothRunsTakeFewBytes() {
        val runs = FragmentRuns.Builder(isShaded = false)
        for (sample in 0 until 7000) runs.add(sample, (1_000_000L + 5 * sample) shl 32 or 77L, 0)
        assertTrue(runs.build().size < 15_000)
    }
}
