package dev.lazyz

import dev.lazyz.strategies.Renderers
import dev.lazyz.world.camera.Camera
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty

/**
 * Which libraries and functions the sources of `core` may import and call, and what a strategy consists of.
 * `PackagesTest` of `cli` checks the dependencies between packages.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class ArchitectureTest {
    private val root: Path = ProjectFiles.root.resolve("core/src/main/kotlin/dev/lazyz")

    private val sources: List<Path> = Files.walk(root).use { paths ->
        paths.filter { it.name.endsWith(".kt") }.sorted().toList()
    }

    private fun imports(source: Path): List<String> =
        source.readLines().filter {
            it.startsWith("import ")
        }.map { it.removePrefix("import ").substringBefore(" as ") }

    /** The package of a source file, without the prefix `dev.lazyz`; empty for that package itself. */
    private fun packageOf(source: Path): String = source.relativeTo(root).parent?.joinToString(".").orEmpty()

    private val allPackages: Set<String> = sources.map(::packageOf).toSet()
    private val page: String = ProjectFiles.root.resolve("docs/architecture.md").readText()

    /** The name of a strategy's package, or null for source files that are not part of a strategy. */
    private fun strategy(source: Path): String? =
        packageOf(source).takeIf { it.startsWith("strategies.") }?.split('.')?.get(1)

    @Test
    fun sourcesAreFound() {
        assertTrue(sources.size > 30) { "only ${sources.size} sources in $root" }
        assertTrue(sources.any { strategy(it) == "zbuffer" })
    }

    /** Every package has a row on the page, and what the row names are files of the package. */
    @Test
    fun thePageShowsThePackages() {
        val rows = page.substringAfter("## Packages of").substringBefore("\n## ").lines()
            .filter { it.startsWith("| `") }
        val shown = rows.associateBy { row -> row.substringAfter('`').substringBefore('`').removePrefix("dev.lazyz") }
        val expected = allPackages.map { if (Regex("strategies\\.\\w+").matches(it)) "strategies.*" else it }
        assertEquals(expected.toSet(), shown.keys)
        for ((name, row) in shown) {
            val files = sources.filter { packageOf(it) == name }.map { it.name.removeSuffix(".kt") }
            for ((file) in Regex("`([A-Z]\\w+)").findAll(row).map { it.destructured }) {
                assertTrue(file in files) { "$name has no $file" }
            }
        }
    }

    @Test
    fun thePageNamesTheFilesOfEachStep() {
        val roots = mapOf(
            "core" to root,
            "scenes" to ProjectFiles.root.resolve("scenes/src/main/kotlin/dev/lazyz/scenes"),
            "cli" to ProjectFiles.root.resolve("cli/src/main/kotlin/dev/lazyz/cli"),
        )
        val named = Regex("`(core|scenes|cli): ([\\w/]+)`").findAll(page).map { it.destructured }.toList()
        assertTrue(named.isNotEmpty())
        for ((module, path) in named) assertTrue(Files.exists(roots.getValue(module).resolve("$path.kt"))) { path }
    }

    @Test
    fun strategiesDoNotImportEachOther() {
        val strategies = sources.mapNotNull(::strategy).toSet()
        val offences = sources.filter { strategy(it) != null }.flatMap { source ->
            val others = strategies - strategy(source)
            source.readLines().filter { line -> others.any { line.contains("dev.lazyz.strategies.$it.") } }
                .map { "${source.name} names another strategy: $it" }
        }
        assertEquals(emptyList<String>(), offences)
    }

    @Test
    fun aStrategyIsOnePackageOneClassOneLineAndOnePage() {
        val packages = sources.mapNotNull(::strategy).distinct().sorted()
        assertEquals(packages, Renderers.builtIn.map { it.id }.sorted())
        val readme = ProjectFiles.root.resolve("README.md").readText()
        for (id in packages) {
            val classes = sources.filter { strategy(it) == id }.flatMap { it.readLines() }
                .filter { it.startsWith("public class") || it.startsWith("public object") }
            assertEquals(1, classes.size) { "$id: $classes" }
            val page = ProjectFiles.root.resolve("docs/algorithms/$id.md")
            assertTrue(Files.exists(page)) { "$page" }
            assertTrue(readme.contains("| [`$id`](docs/algorithms/$id.md) |")) { "README.md does not list $id" }
        }
    }

    @Test
    fun onlyTheNamedLibrariesAreImported() {
        val offences = sources.flatMap { source ->
            imports(source)
                .filterNot { import -> ALLOWED.any { import.startsWith(it) } }
                .filterNot { source.name.removeSuffix(".kt") in VECTORS && it.startsWith("jdk.incubator.vector.") }
                .map { "${source.name} imports $it" }
        }
        assertEquals(emptyList<String>(), offences)
    }

    @Test
    fun theVectorApiIsNamedInClassesThatAreLoadedOnlyWhereItIs() {
        for (kernel in VECTORS) {
            val users = sources.filter { source -> source.readLines().any { kernel in it } }.map { it.name }
            assertEquals(listOf("Kernels.kt", "$kernel.kt"), users)
        }
    }

    @Test
    fun rule_6_3_onlyPermittedArithmeticIsUsed() {
        val offences = sources.flatMap { source ->
            val code = source.readLines().map { it.substringBefore("//") }.filterNot { it.trimStart().startsWith("*") }
                // Vector lanes are rounded like scalar products
                .map { if (source.name.removeSuffix(".kt") in VECTORS) it.replace(".mul(", ".times(") else it }
            code.filter { line -> FORBIDDEN.any { it.containsMatchIn(line) } }.map { "${source.name}: ${it.trim()}" }
        }
        assertEquals(emptyList<String>(), offences)
    }

    @Test
    fun rule_6_3_theSearchFindsWhatIsForbidden() {
        val forbidden = listOf(
            "val s = Math.sin(x)", "val p = a.pow(2)", "import kotlin.math.cos", "x = Math.fma(a, b, c)",
            "kotlin.math.hypot(a, b)", "m.mul(n)", "v.normalize()", "Matrix4d().lookAt(a, b, c)", "m.transform(v)",
            "m.invert(n)", "q.rotateX(a)", "m.perspective(a, b, c, d)", "import kotlin.math.*", "v.fma(a, b)",
        )
        for (line in forbidden) assertTrue(FORBIDDEN.any { it.containsMatchIn(line) }) { line }
        val permitted = listOf(
            "StrictMath.sin(x)", "import kotlin.math.sqrt", "import kotlin.math.floor", "mesh.transformed(m)",
            "Math.floorMod(a, b)", "sqrt(x)",
            "Camera.perspective(a)", "StrictMath.pow(a, b)",
        )
        for (line in permitted) assertTrue(FORBIDDEN.none { it.containsMatchIn(line) }) { line }
    }

    private companion object {
        /** The classes that may import the Vector API. */
        val VECTORS = listOf("VectorBlockKernel", "VectorSmallTriangleKernel", "VectorFragmentKernel")

        /** Prefixes of permitted imports: of `java.`, only packages that a renderer needs. */
        val ALLOWED = listOf(
            "dev.lazyz.", "kotlin.", "kotlinx.coroutines.", "org.joml.", "java.util.", "java.security.", "java.lang.",
            "java.nio.", "java.io.",
        )

        const val INEXACT =
            "sin|cos|tan|asin|acos|atan|atan2|sinh|cosh|tanh|exp|expm1|log|log10|log1p|ln|pow|cbrt|hypot|fma"

        val FORBIDDEN = listOf(
            Regex("""(?<!Strict)Math\.($INEXACT)\("""),
            Regex("""kotlin\.math\.($INEXACT|\*)"""),
            Regex("""(?<!StrictMath)\.(pow|fma)\("""),
            Regex("""(?<!Camera)\.(perspective|ortho|lookAt)\w*\("""),
            Regex("""\.(mul|rotate|rotation|invert|transform|normalize|reflect|lerp|slerp)([A-Z][A-Za-z]*)?\("""),
        )
    }
}
