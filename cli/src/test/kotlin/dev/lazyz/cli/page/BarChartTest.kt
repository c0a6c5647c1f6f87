package dev.lazyz.cli.page

import dev.lazyz.cli.page.Html.Companion.elements
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test

class BarChartTest {
    private fun chart(vararg bars: BarChart.Bar) = Html.xml(BarChart("Calls", bars.asList(), "discarded").svg())

    @Test
    fun barsAreInProportionAndBeginAtZero() {
        val svg = chart(
            BarChart.Bar("a", 100.0, "100", part = 60.0),
            BarChart.Bar("b", 25.0, "25"),
            BarChart.Bar("c", 0.0, "0"),
            BarChart.Bar("<d>", null, "failed"),
        )
        val all = svg.getElementsByTagName("rect").elements
        val bars = all.filter { it.getAttribute("class") != "track" }
            .map { listOf("class", "x", "width").map { name -> it.getAttribute(name) } }
        val expected = listOf(
            listOf("bar", "0.00%", "40.00%"),
            listOf("part", "40.00%", "60.00%"),
            listOf("bar", "0.00%", "25.00%"),
            listOf("bar", "0.00%", "0.00%"),
        )
        assertEquals(expected, bars)
        assertEquals(4, all.count { it.getAttribute("class") == "track" })
        val words = svg.getElementsByTagName("text").elements.map { it.textContent }
        assertEquals(listOf("a", "100", "b", "25", "c", "0", "<d>", "failed"), words)
        val rows = all.map { it.getAttribute("y").toInt() }.distinct()
        assertEquals(listOf(36, 36, 36), rows.zipWithNext { a, b -> b - a })
        assertEquals("144", svg.getAttribute("height"))
    }

    @Test
    fun nothingIsAChartToo() {
        val svg = chart(BarChart.Bar("a", 0.0, "0"), BarChart.Bar("b", null, "failed"))
        assertEquals(
            listOf("100.00%", "0.00%", "100.00%"),
            svg.getElementsByTagName("rect").elements.map {
                it.getAttribute("width")
            }
        )
    }
}
