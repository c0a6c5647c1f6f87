package dev.lazyz.cli

import dev.lazyz.cli.PackageGraph.Source
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.extension
import kotlin.io.path.invariantSeparatorsPathString
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

/**
 * The packages of each module: dependencies between them have no cycles, and each file is in the folder of its package.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class PackagesTest {
    private val root: Path = ProjectFiles.root

    private val sources: Map<String, List<Source>> = MODULES.associateWith { module ->
        val folders = listOf("kotlin", "java").map { ProjectFiles.folderOf(module).resolve("src/main/$it") }
        folders.filter { Files.isDirectory(it) }.flatMap { sourcesIn(it) }
    }

    private fun sourcesIn(folder: Path): List<Source> = Files.walk(folder).use { paths ->
        paths.filter { it.extension in listOf("kt", "java") && !it.endsWith("module-info.java") }.sorted().toList()
    }.map { Source(it.relativeTo(root).invariantSeparatorsPathString, it.readText()) }

    private fun graph(module: String) =
        PackageGraph(sources.getValue(module), PackageGraph.packagesOf(sources.values.flatten()))

    @ParameterizedTest
    @ValueSource(strings = ["core", "scenes", "conformance", "cli", "jmh"])
    fun arrowsBetweenPackagesGoOneWay(module: String) {
        assertTrue(sources.getValue(module).size > 20) { "only ${sources.getValue(module)}" }
        val cycles = graph(module).cycles()
        assertTrue(cycles.isEmpty()) { "packages that name each other in a circle:\n${cycles.joinToString("\n")}" }
    }

    @Test
    fun packagesOfCoreNameOnlyThoseBelowThem() {
        val packages = sources.getValue("core").map { it.packageName }.toSet()
        assertEquals(emptyList<String>(), packages.filter { it !in LEVELS && !it.startsWith("dev.lazyz.strategies.") })
        assertEquals(emptyList<String>(), graph("core").upward(::level))
    }

    /** The level of a package of core. All packages of strategies, except the parts of `tiled`, are on one level. */
    private fun level(name: String): Int = LEVELS.indexOf(if (name in LEVELS) name else "dev.lazyz.strategies.*")

    @Test
    fun eachFileLiesInTheFolderOfItsPackage() {
        val lost = sources.values.flatten().filterNot { source ->
            val folder = source.path.substringBeforeLast('/').substringAfter("/src/main/").substringAfter('/')
            folder == source.packageName.replace('.', '/')
        }
        assertEquals(emptyList<Source>(), lost)
    }

    /** A regular expression can take a time that grows with the square of its input, or overflow the stack. */
    @Test
    fun noRegularExpressionSeesInput() {
        val patterns = Regex("""\bRegex\(|\btoRegex\(|\bPattern\.compile\(|\.(replaceAll|matches)\("""")
        val offences = MODULES.filter { it != "jmh" }.flatMap(sources::getValue).flatMap { source ->
            source.text.lines().filter { patterns.containsMatchIn(it.substringBefore(" * ")) }
                .map { "${source.path}: $it" }
        }
        assertEquals(emptyList<String>(), offences)
    }

    /** The formatter checks code, but not comments. */
    @Test
    fun commentsFitInto120Columns() {
        val comment = Regex("""\s*(/\*|\*|//).*""")
        val modules = MODULES.map { ProjectFiles.folderOf(it) }
        val folders =
            modules.flatMap { listOf(it.resolve("src/main"), it.resolve("src/test")) } + root.resolve("examples")
        val long = folders.filter { Files.isDirectory(it) }.flatMap(::sourcesIn).flatMap { source ->
            source.text.lines().withIndex().filter { (_, line) -> line.length > 120 && line.matches(comment) }
                .map { "${source.path}:${it.index + 1}" }
        }
        assertEquals(emptyList<String>(), long)
    }

    /** docs/architecture.md has a row for each package; those of core have a test of their own. */
    @Test
    fun thePageShowsThePackages() {
        val page = root.resolve("docs/architecture.md").readText().substringAfter("## Packages of the other modules")
        val names = Regex("`((?:${MODULES.joinToString("|")})[a-z0-9.]*)`").findAll(page)
        val shown = names.map { "dev.lazyz." + it.groupValues[1] }
        val others = MODULES.filter { it != "core" }.flatMap { sources.getValue(it) }.map { it.packageName }
        assertEquals(others.toSortedSet(), shown.toSortedSet())
    }

    private companion object {
        /** The packages of core from bottom to top: each names only those before it, see `docs/architecture.md`. */
        val LEVELS = listOf(
            "spi", "", "geometry", "raster", "world.material", "world.camera", "world.light", "world.surface",
            "shading.light", "shading.pbr", "shading", "setup", "world",
            "sections", "drawing", "pipeline", "filter",
            "strategies.tiled.raster", "strategies.tiled.binning", "strategies.tiled.resolve",
            "strategies.*", "strategies", "planning", "lighting", "aov",
        ).map { if (it.isEmpty()) "dev.lazyz" else "dev.lazyz.$it" }

        val MODULES =
            listOf("core", "scenes", "conformance", "testing", "server", "spark", "swing", "mcp", "cli", "jmh")
    }
}
