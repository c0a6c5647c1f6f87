package dev.lazyz.conformance

import dev.lazyz.Renderer
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.mutants.DisruptiveRenderers
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.mutants.wrappers.PromiseMistakes
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.conformance.results.Waivers
import dev.lazyz.scenes.formats.Scenes
import java.nio.file.Path
import kotlin.io.path.exists
import kotlin.io.path.writeText
import kotlin.reflect.KClass
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertNotNull
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir
import org.junit.platform.engine.TestExecutionResult
import org.junit.platform.engine.TestExecutionResult.Status
import org.junit.platform.engine.discovery.DiscoverySelectors.selectClass
import org.junit.platform.engine.discovery.DiscoverySelectors.selectMethod
import org.junit.platform.engine.reporting.ReportEntry
import org.junit.platform.engine.support.descriptor.MethodSource
import org.junit.platform.launcher.EngineFilter.includeEngines
import org.junit.platform.launcher.TestExecutionListener
import org.junit.platform.launcher.TestIdentifier
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder
import org.junit.platform.launcher.core.LauncherFactory

/** The suite as run by a build tool: a class that extends [RendererConformance], and system properties. */
class AsATestTest {
    /** Ignored by build tools, because its name does not end in `Test`. */
    class Wrong : RendererConformance() {
        override fun renderer(): Renderer = WrongColors()
    }

    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val promise = "rule_8_2_promiseToShadeOnlyTheVisibleIsKept"
    private val counts = "rule_8_1_countersEqualTheObservedCalls"

    /** Also ignored by build tools. */
    class Secretive : RendererConformance() {
        override fun renderer(): Renderer = PromiseMistakes.reportsNoMemory()
    }

    /** Never ends, but runs a little now and then, so that it is not known whether it is too slow. */
    class Dozing : RendererConformance() {
        override fun renderer(): Renderer = DisruptiveRenderers.dozes()
    }

    /** What rules publish, by their names. */
    private val published = LinkedHashMap<String, MutableList<String>>()

    /** Runs the rules named [rules], or all. */
    private fun run(
        vararg rules: String,
        subject: KClass<out RendererConformance> = Wrong::class,
        tries: String = "0.05",
    ): Map<String, TestExecutionResult> {
        val results = LinkedHashMap<String, TestExecutionResult>()
        val listener = object : TestExecutionListener {
            override fun executionFinished(test: TestIdentifier, result: TestExecutionResult) {
                (test.source.orElse(null) as? MethodSource)?.let { results[it.methodName] = result }
            }

            override fun reportingEntryPublished(test: TestIdentifier, entry: ReportEntry) {
                val name = (test.source.get() as MethodSource).methodName
                published.getOrPut(name) { ArrayList() } += entry.keyValuePairs.values
            }
        }
        val request = LauncherDiscoveryRequestBuilder.request()
            .selectors(
                rules.map { selectMethod(subject.java, SuiteRule.find(it)!!.method) }
                    .ifEmpty { listOf(selectClass(subject.java)) },
            )
            .filters(includeEngines("jqwik"))
            .configurationParameter("jqwik.database", "")
            .configurationParameter("jqwik.shrinking.default", "OFF")
            .configurationParameter("jqwik.reporting.usejunitplatform", "true")
            .build()
        SuiteRun.withProperty(RendererConformance.TRIES, tries) { LauncherFactory.create().execute(request, listener) }
        return results
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun oneTestARule() {
        val results = run()
        assertEquals(SuiteRun.rules, results.keys)
        assertEquals(Status.FAILED, results.getValue(nearest).status)
        assertEquals(Status.SUCCESSFUL, results.getValue(counts).status)
        val skipped = results.getValue(promise)
        assertEquals(Status.ABORTED, skipped.status)
        assertEquals("SHADES_ONLY_VISIBLE is not declared", skipped.throwable.get().message)
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun whatFailsIsKept(@TempDir folder: Path) {
        val scenes = "rule_5_1_nearestFragmentIsVisibleInScenes"
        SuiteRun.withProperty(RendererConformance.OUTPUT, "$folder") {
            val message = run(nearest, scenes).getValue(scenes).throwable.get().message.orEmpty()
            val kept = folder.resolve("Wrong")
            val files = listOf(".kt", ".json", "-expected.png", "-actual.png", "-difference.png").map { scenes + it }
            val words = "\nsaved in $kept: ${files.joinToString()}\nseed 1995; again: zcli conformance "
            assertTrue(words in message, message)
            for (file in files) assertTrue(kept.resolve(file).exists(), file)
            assertTrue(kept.resolve("$nearest.kt").exists())

            // The scene file shows the failure that the message describes
            val loaded = Scenes.load(kept.resolve("$scenes.json"))
            val frame = loaded.scene.frame(loaded.raster(loaded.size!!.width, loaded.size!!.height))
            assertNotNull(difference(ReferenceRenderer().render(frame), WrongColors().render(frame)))
        }
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun skippedRuleHasOneLine() {
        assertEquals(Status.ABORTED, run(promise).getValue(promise).status)
        assertEquals(mapOf(promise to listOf("not supported: SHADES_ONLY_VISIBLE is not declared")), published)
    }

    /** Build tools count an exception that is no `AssertionError` as an error, not as a failure. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun inconclusiveRuleIsAnError() {
        SuiteRun.withProperty(RendererConformance.DEADLINE, "1") {
            val result = run(nearest, subject = Dozing::class).getValue(nearest)
            val thrown = result.throwable.get()
            assertEquals(Status.FAILED, result.status)
            assertFalse(thrown is AssertionError)
            assertTrue(thrown.message.orEmpty().startsWith("inconclusive: was not over after 10 s"), thrown.message)
            assertTrue("-Dlazyz.conformance.deadline=" in thrown.message.orEmpty(), thrown.message)
        }
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun whatIsNotFollowedIsAbortedWithTheReason() {
        val memory = "rule_8_3_workingMemoryIsReported"
        val results = run(memory, nearest, counts, subject = Secretive::class, tries = "0.3")
        val result = results.getValue(memory)
        assertEquals(Status.ABORTED, result.status)
        assertTrue("a primitive is visible, but peakBytes is 0" in result.throwable.get().message.orEmpty())
        assertTrue(results.values.none { it.status == Status.FAILED })
    }

    @Test
    @DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
    fun waiversAreHeeded(@TempDir folder: Path) {
        val waivers = listOf(nearest, counts).joinToString("\n") {
            "rule: $it\nreason: red\nlink: https://example.org/7\nexpires: 9999-01-01\n"
        }
        val file = folder.resolve("waivers.txt").apply { writeText(waivers) }
        SuiteRun.withProperty(Waivers.PROPERTY, "$file") {
            val results = run(nearest, counts)
            assertEquals(Status.ABORTED, results.getValue(nearest).status)
            val reason = results.getValue(nearest).throwable.get().message
            assertEquals("waived until 9999-01-01: red (https://example.org/7)", reason)
            assertEquals(Status.FAILED, results.getValue(counts).status)
        }
        SuiteRun.withProperty(Waivers.PROPERTY, "$folder/none.txt") {
            val results = run(nearest, counts)
            assertTrue(results.values.all { it.status == Status.FAILED })
            assertTrue("none.txt" in results.getValue(nearest).throwable.get().message.orEmpty())
        }
    }
}
