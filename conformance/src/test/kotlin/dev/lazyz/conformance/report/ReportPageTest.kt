package dev.lazyz.conformance.report

import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.Throwing
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.scenes.html.Html.escaped
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `report.html`: its order, its contents, and its escaping of markup. */
class ReportPageTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val promise = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept"
    private val rows = "rule_7_3_rowsArriveInOrderEachOnce"
    private val background = "rule_4_3_backgroundIsVisibleWhereNoFragmentPasses"

    private fun waiver(rule: String) = "rule: $rule\nreason: <i> & \"so\" 'on'\nlink: none\nexpires: 9999-01-01\n\n"

    private fun report(renderer: PlainRenderer, waived: List<String>, vararg rules: String): ConformanceReport {
        val waivers = Waivers.parse(waived.joinToString("") { waiver(it) })
        val conformance = Conformance { renderer }.tries(0.05).waivers(waivers)
        for (rule in rules) conformance.rule(rule)
        return conformance.run()
    }

    private fun all(pattern: String, text: String) = Regex(pattern).findAll(text).map { it.groupValues[1] }.toList()

    @Test
    fun waiversAreFirstThenFailuresThenTheRest() {
        val report = report(WrongColors(), listOf(nearest, rows), nearest, promise, rows, background)
        val html = report.toHtml()
        val headings = listOf("Likely cause", "Waivers", "Failures", "What was run", "Rules", "Frames")
        assertEquals(headings, all("<h2>(.*)</h2>", html))
        assertTrue("""<p class="bad">${ReportText(report).verdict()}</p>""" in html)

        // Failures come before waived rules, and each has a section and a link to it
        assertEquals(listOf(background, rows, nearest), all("<h3 id=\"(.*?)\">", html))
        assertEquals(listOf(background, background, rows, nearest), all("<li><a href=\"#(.*?)\">", html))
        assertEquals(listOf(background, nearest, rows), all("<tr><td><a href=\"#(.*?)\">", html))
        assertTrue("<tr><td>$promise</td>" in html)

        // Why, where to look, and how to reproduce it
        for (result in report.results.filter { it.rule.name != promise }) {
            val section = html.substringAfter("<h3 id=\"${result.rule.name}\">").substringBefore("</section>")
            assertTrue("<dt>Why (MUST)</dt><dd>${escaped(result.rule.intent)}</dd>" in section, section)
            assertTrue("<dt>Look at</dt><dd>${escaped(result.rule.look)}</dd>" in section, section)
            assertTrue("<code>${escaped(report.commandFor(result.rule))}</code>" in section, section)
            assertTrue(">${result.outcome.words}</span>" in section, section)
            if (result.outcome != RuleOutcome.FAILED) assertTrue("<p>${escaped(result.message)}</p>" in section)
            assertEquals(result.failure != null, "Red: the colour differs" in section, section)
        }
    }

    @Test
    fun pageOfWhoConformsIsShort() {
        val report = report(PlainRenderer(), emptyList(), nearest)
        val html = report.toHtml()
        assertEquals(listOf("What was run", "Rules", "Frames"), all("<h2>(.*)</h2>", html))
        assertTrue("""<p class="good">plain conforms: 1 rule, 1 passed""" in html, html)
        assertTrue("<tr><td>seed</td><td>1995</td></tr>" in html)
        assertTrue("<tr><td>all</td><td>${report.distribution.frames}</td></tr>" in html)
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
