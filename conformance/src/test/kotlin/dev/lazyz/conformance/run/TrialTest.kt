package dev.lazyz.conformance.run

import dev.lazyz.Counters
import dev.lazyz.Frame
import dev.lazyz.Raster
import dev.lazyz.Renderer
import dev.lazyz.RowSink
import dev.lazyz.conformance.Conformance
import dev.lazyz.conformance.RendererConformance
import dev.lazyz.conformance.SuiteRun
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.conformance.mutants.Promising
import dev.lazyz.conformance.mutants.WrongColors
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.RuleOutcome
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.setup.FrameBuilder
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.lang.reflect.Proxy
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path
import java.time.LocalDate
import java.util.Optional
import java.util.jar.Attributes
import java.util.jar.JarEntry
import java.util.jar.JarOutputStream
import java.util.jar.Manifest
import java.util.logging.Level
import java.util.logging.Logger
import kotlin.io.path.createDirectories
import kotlin.io.path.outputStream
import net.jqwik.api.lifecycle.FalsifiedSample
import net.jqwik.api.lifecycle.PropertyExecutionResult
import net.jqwik.api.lifecycle.PropertyExecutionResult.Status
import net.jqwik.api.lifecycle.ShrunkFalsifiedSample
import net.jqwik.api.lifecycle.TryExecutionResult
import net.jqwik.api.lifecycle.TryExecutor
import net.jqwik.api.lifecycle.TryLifecycleContext
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotSame
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Assertions.assertThrows
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.opentest4j.TestAbortedException

/** What a run counts, records and ignores. */
class TrialTest {
    private val nearest = "rule_5_1_nearestFragmentIsVisible"
    private val case = FrameCase(FrameBuilder(Raster(2, 1)).build(), "FrameBuilder(Raster(2, 1)).build()")
    private val jqwik = Logger.getLogger("net.jqwik")

    private fun of(make: () -> Renderer) = Conformance(make).rule(nearest).tries(0.05)

    @Test
    fun framesThatAreMadeSmallerAreNotCounted() {
        val result = of { WrongColors() }.run().results.single()
        assertEquals(result.tries.toLong(), result.distribution.frames)
    }

    @Test
    fun frameCountsAnewInEachTry() {
        val frame = case.frame
        val attempt = TryExecutor { parameters ->
            for (it in parameters) Trial.current?.saw(it as FrameCase)
            TryExecutionResult.satisfied()
        }
        val rule = checkNotNull(SuiteRule.find(nearest))
        val types = arrayOf(TryLifecycleContext::class.java)
        val context = Proxy.newProxyInstance(javaClass.classLoader, types) { _, asked, _ ->
            if (asked.name == "targetMethod") rule.method else error("not asked")
        } as TryLifecycleContext
        val census = Census()
        for (i in 1..2) {
            census.nextTry()
            repeat(3) { census.add(frame) }
            assertEquals(i.toLong(), census.distribution().frames)
        }
        val trial = trial()
        Trial.current = trial
        try {
            repeat(2) { Effort().aroundTry(context, attempt, listOf(case, case)) }
        } finally {
            Trial.current = null
        }
        val verdict = trial.verdict(Ended(Status.SUCCESSFUL), LocalDate.now())
        assertEquals(2, verdict.distribution.frames)
    }

    private fun trial() = Trial(checkNotNull(SuiteRule.find(nearest)), null)

    @Test
    fun abortedRuleDoesNotApply() {
        val result = trial().verdict(Ended(Status.ABORTED, TestAbortedException("no GPU")), LocalDate.now())
        assertEquals(RuleOutcome.NOT_SUPPORTED, result.outcome)
        assertEquals("no GPU", result.message)
        assertNull(result.failure)
    }

    @Test
    fun frameOfAnUnexpectedExceptionIsRemembered() {
        val failure = RuleFailure.of(IllegalStateException("lost"), listOf(1, case))
        assertEquals(case.code, failure.code)
        assertEquals("lost", failure.message)
        assertNull(failure.expected)
    }

    @Test
    fun whatTheFirstMakingThrowsIsThrown() {
        val thrown = IllegalStateException("cannot be made")
        assertSame(thrown, assertThrows(IllegalStateException::class.java) { of { throw thrown }.run() })
        assertTrue(of { PlainRenderer() }.run().isConformant)
    }

    @Test
    fun whatALaterMakingThrowsIsReported() {
        var made = 0
        val report = of { if (made++ < 3) PlainRenderer() else error("no more of them") }.run()
        val result = report.results.single()
        assertEquals(RuleOutcome.FAILED, result.outcome)
        assertEquals("no more of them", result.message)
        assertTrue(result.failure?.code.orEmpty().startsWith("FrameBuilder("), "${result.failure?.code}")
    }

    /** Ignored by build tools, because its name does not end in `Test`. */
    class Unborn : RendererConformance() {
        init {
            error("the suite cannot be made")
        }

        override fun renderer(): Renderer = ZBufferRenderer()
    }

    @Test
    fun faultOfTheSuiteIsNoVerdict() {
        val conformance = of { PlainRenderer() }.subject(Unborn::class.java)
        val message = assertThrows(IllegalStateException::class.java) { conformance.run() }.message.orEmpty()
        assertTrue("not run: $nearest; " in message && "the suite cannot be made" in message, message)
    }

    @Test
    fun seedThatIsNoNumberIsRefused() {
        SuiteRun.withProperty(RendererConformance.SEED, "seven") {
            val refusal = assertThrows(IllegalArgumentException::class.java) { of { PlainRenderer() }.run() }
            assertEquals("system property lazyz.conformance.seed must be a whole number: seven", refusal.message)
        }
    }

    @Test
    fun loggersSayNothingDuringARunAndAreAsBeforeAfterIt() {
        val before = jqwik.level
        var isLoud = false
        jqwik.level = Level.FINE
        try {
            of {
                isLoud = isLoud || jqwik.isLoggable(Level.WARNING)
                PlainRenderer()
            }.run()
            assertTrue(isLoud, "the first renderer is made before the run")
            isLoud = false
            of { Listening { isLoud = isLoud || jqwik.isLoggable(Level.WARNING) } }.run()
            assertEquals(false, isLoud)
            assertEquals(Level.FINE, jqwik.level)
        } finally {
            jqwik.level = before
        }
    }

    private class Listening(private val listen: () -> Unit) : PlainRenderer("listening") {
        override fun render(frame: Frame, sink: RowSink): Counters {
            listen()
            return super.render(frame, sink)
        }
    }

    @Test
    fun settingsOfTheBuildDoNotReachARun() {
        val database = Path.of(".jqwik-database")
        fun time() = if (Files.exists(database)) Files.getLastModifiedTime(database) else null
        val before = time()
        val usual = of { WrongColors() }.run().results.single()
        SuiteRun.withProperty("jqwik.shrinking.default", "OFF") {
            assertEquals(usual.message, of { WrongColors() }.run().results.single().message)
        }
        assertEquals(before, time())
    }

    @Test
    fun reportIsInTheFolderThatIsAskedFor(@TempDir folder: Path) {
        of { PlainRenderer() }.output(folder.resolve("new/report")).run()
        assertTrue(Files.exists(folder.resolve("new/report/report.html")))
    }

    @Test
    fun commandNamesTheJarUnlessTheRendererIsOurs(@TempDir folder: Path) {
        val own = of { ZBufferRenderer() }.run()
        val options = "--seed 1995 --tries 0.05 --rule $nearest"
        assertEquals("zcli conformance --strategy zbuffer $options", own.commandFor(own.results.single().rule))

        // A renderer from a separate jar, in a folder with a blank in its name
        val jar = folder.resolve("a folder").createDirectories().resolve("mine.jar")
        val name = Promising::class.java.name
        jarOf(jar, name)
        ChildFirst(jar, name).use { loader ->
            val renderer = loader.loadClass(name).getConstructor().newInstance() as Renderer
            assertNotSame(Promising::class.java, renderer.javaClass)
            val report = of { renderer }.run()
            assertEquals("2.7", report.strategy.version)
            val command = "zcli conformance --strategy promising --classpath '$jar' $options"
            assertEquals(command, report.commandFor(report.results.single().rule))
        }
    }

    private fun jarOf(path: Path, name: String) {
        val manifest = Manifest()
        manifest.mainAttributes[Attributes.Name.MANIFEST_VERSION] = "1.0"
        manifest.mainAttributes[Attributes.Name.IMPLEMENTATION_VERSION] = "2.7"
        val entry = name.replace('.', '/') + ".class"
        JarOutputStream(path.outputStream(), manifest).use { jar ->
            jar.putNextEntry(JarEntry(entry))
            jar.write(checkNotNull(javaClass.classLoader.getResourceAsStream(entry)).use { it.readBytes() })
            jar.closeEntry()
        }
    }

    /** Loads the class [own] from the jar, even if another loader has a class of that name. */
    private class ChildFirst(jar: Path, private val own: String) :
        URLClassLoader(arrayOf(jar.toUri().toURL()), ChildFirst::class.java.classLoader) {
        override fun loadClass(name: String, resolve: Boolean): Class<*> =
            if (name == own) findLoadedClass(name) ?: findClass(name) else super.loadClass(name, resolve)
    }

    /** jqwik's result of a property. */
    private class Ended(private val status: Status, private val thrown: Throwable? = null) : PropertyExecutionResult {
        override fun seed(): Optional<String> = Optional.empty()

        override fun falsifiedParameters(): Optional<List<Any>> = Optional.empty()

        override fun status(): Status = status

        override fun throwable(): Optional<Throwable> = Optional.ofNullable(thrown)

        override fun countChecks(): Int = 1

        override fun countTries(): Int = 1

        override fun originalSample(): Optional<FalsifiedSample> = Optional.empty()

        override fun shrunkSample(): Optional<ShrunkFalsifiedSample> = Optional.empty()

        override fun mapTo(newStatus: Status, throwable: Throwable?) = Ended(newStatus, throwable)
    }
}
