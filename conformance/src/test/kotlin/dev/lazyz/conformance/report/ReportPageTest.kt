package dev.lazyz.conformance.report

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.Throwing
import dev.lazyz.conformance.results.Waivers
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `report.html`: its order, its contents, and its escaping of markup. */
class ReportPageTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val promise = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept"

    private fun waiver(rule: String) = "rule: $rule\nreason: <i> & \"so\" 'on'\nlink: none\nexpires: 9999-01-01\n\n"

    private fun report(renderer: PlainRenderer, waived: List<String>, vararg rules: String): ConformanceReport {
        val waivers = Waivers.parse(waived.joinToString("") { waiver(it) })
        val conformance = Conformance { renderer }.tries(0.05).waivers(waivers)
        for (rule in rules) conformance.rule(rule)
        return conformance.run()
    }

    @Test
    fun nothingIsTakenForMarkup() {
        val html = report(PlainRenderer("<b>\"a\" & b"), listOf(promise), nearest).toHtml()
        assertTrue("<h1>&lt;b&gt;&quot;a&quot; &amp; b: Lazy Z conformance</h1>" in html)
        assertTrue("<td>&lt;i&gt; &amp; &quot;so&quot; &#39;on&#39;</td>" in html)
        assertFalse("<b>" in html || "<i>" in html)
        val section = report(Throwing(), emptyList(), nearest).toHtml()
            .substringAfter("<pre>").substringBefore("</pre>")
        assertTrue("no &lt;primitives&gt; &amp; no &quot;wonder&quot;\uFFFD\nin\n" in section, section)
    }
}
