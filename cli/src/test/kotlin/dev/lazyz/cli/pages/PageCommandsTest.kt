package dev.lazyz.cli.pages

import dev.lazyz.cli.ProjectFiles
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.isExecutable
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.DynamicTest
import org.junit.jupiter.api.DynamicTest.dynamicTest
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.TestFactory
import org.junit.jupiter.api.io.TempDir

/**
 * The commands of the pages succeed, each where it says. By default only the first blocks of the pages that a newcomer
 * reads are run, with `-Dlazyz.effort=rest` all pages with others, and with `full` all.
 */
class PageCommandsTest {
    private val commands = FencedBlock.all.filter { it.language == "sh" }

    /** Blocks that `.ci/run` runs as they stand, by page and number. */
    private val ranByScript: List<FencedBlock> =
        Regex("""([\w./-]+\.md) (\d+)""").findAll(ProjectFiles.root.resolve(".ci/run").readText())
            .map { it.destructured }
            .map { (page, number) -> commands.filter { it.page == page }[number.toInt() - 1] }
            .toList()

    private val effort: String? = System.getProperty("lazyz.effort")

    /** Returns those of the [blocks] of [page] that are run. Blocks use files of those before them on their page. */
    private fun run(page: String, blocks: List<FencedBlock>): List<FencedBlock> {
        val usual = if (page in NEWCOMERS) blocks.take(2) else emptyList()
        return when {
            effort == null -> usual
            effort == "rest" && usual.size == blocks.size -> emptyList()
            else -> blocks
        }
    }

    private val here = commands.filter { it !in ranByScript && it.reasons().isEmpty() }

    private fun FencedBlock.reasons() = NOT_RUN.filterKeys { name.startsWith(it) }.values

    @TestFactory
    fun succeed(@TempDir folder: Path): List<DynamicTest> {
        assumeTrue(Path.of("/bin/bash").exists(), "there is no bash")
        assertTrue(here.size >= 30, "${here.map { it.name }}")
        val pages = here.groupBy { it.page }.mapValues { (page, blocks) -> run(page, blocks) }
        return pages.filterValues { it.isNotEmpty() }.map { (page, blocks) ->
            dynamicTest(page) {
                val place = folder.resolve(page.replace('/', '-')).createDirectories()
                val scripts = blocks.map { smaller(it.lines.joinToString("\n")) }
                PageShell(place.resolve("files").createDirectories(), place).use { shell ->
                    shell.fill(scripts.joinToString("\n"))
                    for (script in scripts) shell.run(script)
                }
            }
        }
    }

    private fun smaller(text: String) = SMALLER.entries.fold(text) { all, (big, small) -> all.replace(big, small) }

    /** Blocks are run in a folder that has the program that is built, but no scripts of the project. */
    @Test
    fun scriptsOfTheProjectAreNotRunInOtherFolders() {
        val scripts = here.flatMap { block ->
            block.lines.flatMap { it.split(' ') }
                .filter { '/' in it && "/target/" !in it && ProjectFiles.root.resolve(it).isExecutable() }
                .map { "${block.name}: $it" }
        }
        assertEquals(emptyList<String>(), scripts)
    }

    @Test
    fun commandsAreMarkedAsCommands() {
        val program = Regex("""^(zcli|java|mvn|gradle|curl|python3|pip|git|source|docker|\.?[\w-]+/[\w/-]+)( |$)""")
        val others = FencedBlock.all.filter { it.language.isEmpty() && program.containsMatchIn(it.lines.first()) }
        assertEquals(emptyList<String>(), others.map { it.name })
        val shells = setOf("bash", "shell", "console", "zsh", "shell-session", "sh-session", "terminal")
        assertEquals(emptyList<String>(), FencedBlock.all.filter { it.language.lowercase() in shells }.map { it.name })
    }

    @Test
    fun exceptionsAreForCommandsThatAreThere() {
        assertTrue(ranByScript.size >= 5, "$ranByScript")
        assertEquals(emptyList<String>(), ranByScript.filter { it.reasons().isNotEmpty() }.map { it.name })
        for (name in NOT_RUN.keys) assertEquals(1, commands.count { it.name.startsWith(name) }, name)
        for (big in SMALLER.keys) assertTrue(commands.any { block -> block.lines.any { big in it } }, big)
    }

    private companion object {
        val NEWCOMERS = setOf("README.md", "docs/cli.md", "docs/memory.md")

        /** Parts of commands that would take long, and what is run for them. */
        val SMALLER = mapOf(
            "--turntable 120 --size 1920x1080" to "--turntable 12 --size 192x108",
            "--turntable 36 -o" to "--turntable 36 --size 64 -o",
            "--size 4096x4096" to "--size 256x256",
            "--size 20000" to "--size 300",
            "--size 100000" to "--size 300",
            "--size 1024x768" to "--size 256x192",
            "--memory-budget 64k" to "--memory-budget 64k --size 160x120",
            "--minutes 60" to "--minutes 0.01",
            "--tries 10" to "--tries 0.5",
            "my.jar --report report" to "my.jar --report report --tries 0.05 --rule 9.6",
            "--explore" to "--explore --tries 0.05 --rule 9.6",
        )

        private const val MEASURES = "takes minutes to hours on a quiet machine; .ci/run starts each benchmark"
        private const val WRITES = "writes pages of the project; a test compares them with their data"
        private const val NEEDS = "needs programs or meshes that are not part of the project"

        /** Blocks that are run in no build, by the page and the begin of the first line, and why. */
        val NOT_RUN = mapOf(
            "docs/conformance.md: mvn test" to "takes an hour; by default, the suite's tests use one other seed",
            "docs/contact-sheet/README.md: python3 -m pip" to NEEDS,
            "docs/contact-sheet/README.md: python3 docs/contact-sheet" to NEEDS,
            "docs/fuzzing.md: mvn verify" to "takes an hour; .ci/run does the same for a minute",
            "docs/golden-tests.md: mvn test" to "for a project of the reader; .ci/run tests examples/golden-tests",
            "docs/growth.md: mvn" to MEASURES,
            "docs/guides/desktop.md: mvn" to "installs for the user; .ci/run runs examples/desktop/check instead",
            "docs/guides/desktop.md: source ~/" to "needs what is installed; examples/desktop/check reads the file",
            "docs/guides/services.md: examples/lambda/cold-start" to ".ci/run runs it",
            "docs/large-models.md: java -cp jmh" to MEASURES,
            "docs/large-models.md: mvn" to MEASURES,
            "docs/large-pictures.md: java .ci/LargePicture.java" to MEASURES,
            "docs/memory.md: java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.memory.MemoryGrid" to MEASURES,
            "docs/memory.md: java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.memory.MemoryGrowth" to MEASURES,
            "docs/mutation-analysis.md: mvn" to "takes minutes, and downloads a tool that no build needs",
            "docs/performance.md: java -cp jmh" to MEASURES,
            "docs/performance.md: java -jar jmh/target/benchmarks.jar StrategyBenchmark" to MEASURES,
            "docs/performance.md: java -XX:StartFlightRecording" to MEASURES,
            "docs/performance.md: mvn" to NEEDS,
            "docs/performance.md: jmh/peers/whole-job" to NEEDS,
            "docs/performance.md: xvfb-run -a jmh/peers/start" to NEEDS,
            "docs/server.md: mvn" to "starts a service that does not end; examples/docker/check starts it",
            "docs/server.md: curl" to "needs the service; examples/docker/check asks it for a picture",
            "docs/server.md: java" to "takes four minutes; tests of the server try each kind of client",
            "docs/spark-scaling.md: mvn" to MEASURES,
            "examples/third-party-strategy/README.md: mvn install" to "as in docs/conformance.md, in another folder",
            "examples/third-party-strategy/README.md: mvn -q verify" to "as in docs/conformance.md, in another folder",
            "examples/third-party-strategy/README.md: mvn -q package" to "as in docs/conformance.md, in another folder",
            "jmh/README.md: mvn -q -DskipTests package && java -jar" to MEASURES,
            "jmh/README.md: java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.ColdStartPhases" to MEASURES,
            "jmh/README.md: mvn -q -DskipTests package && java -Xmx6g" to MEASURES,
            "jmh/README.md: java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.growth.GrowthPage" to WRITES,
            "jmh/README.md: jmh/peers/run" to NEEDS,
            "jmh/README.md: jmh/peers/start" to NEEDS,
            "jmh/README.md: jmh/peers/whole-job" to NEEDS,
            "jmh/README.md: java -cp jmh/target/benchmarks.jar dev.lazyz.jmh.peers.PeerPage" to WRITES,
        )
    }
}
