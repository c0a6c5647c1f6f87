package dev.lazyz.conformance.broken

import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.broken.gallery.RuleNames
import org.junit.jupiter.api.Test

class ProbeTest {
    @Test
    fun probe() {
        val all = listOf(BrokenMaps::stepsForgetAttributes)
        val out = StringBuilder()
        for (make in all) {
            val names = with(RuleNames) {
                listOf(scenes, lit, turned, flecks, options, together, blended, stepping, points, lines, halves, order)
            }
            val seen = names.filter { it in SuiteRun.ofRules(names, make).failures.keys }
            out.append("PROBE ${make().id}: ${seen.joinToString { n -> n }}\n")
        }
        println(out)
        java.io.File(System.getProperty("probe.out") ?: "/tmp/probe2.txt").writeText(out.toString())
    }
}
