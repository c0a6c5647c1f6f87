package dev.lazyz.conformance.run

import dev.lazyz.Renderer
import dev.lazyz.conformance.RendererConformance
import dev.lazyz.conformance.SuiteRun
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.platform.commons.JUnitException
import org.junit.platform.engine.discovery.DiscoverySelectors.selectClass
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder
import org.junit.platform.launcher.core.LauncherFactory

/** Options of Maven that select some of the rules: those rules are run, or the build fails. */
class SelectedRulesTest {
    /** Use of the suite, as shown in docs/conformance.md. Build tools ignore it, because it is in another class. */
    class ZBufferConformanceTest : RendererConformance() {
        override fun renderer(): Renderer = ZBufferRenderer()
    }

    private fun discover(test: String) {
        val request = LauncherDiscoveryRequestBuilder.request()
            .selectors(selectClass(ZBufferConformanceTest::class.java))
        SuiteRun.withProperty(SelectedRules.PROPERTY, test) { LauncherFactory.create().discover(request.build()) }
    }

    @Test
    fun rulesOfASubclassCannotBeSelectedByItsNameAlone() {
        val thrown = assertThrows(Exception::class.java) { discover("ZBufferConformanceTest#rule_5*") }
        val message = generateSequence<Throwable>(thrown) { it.cause }.first { it !is JUnitException }.message.orEmpty()
        assertTrue(message.endsWith("use -Dtest='ZBufferConformanceTest,*Rules#rule_5*'"), message)
    }

    @Test
    fun otherSelectionsAreLeftAlone() {
        for (test in listOf("ZBufferConformanceTest", "ZBufferConformanceTest,*Rules#rule_5*", "Other#rule_5*", "")) {
            discover(test)
        }
    }
}
