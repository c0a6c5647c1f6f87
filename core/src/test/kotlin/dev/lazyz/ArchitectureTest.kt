package dev.lazyz

import dev.lazyz.strategies.Renderers
import dev.lazyz.world.Camera
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name
import kotlin.io.path.readLines
import kotlin.io.path.readText
import kotlin.io.path.relativeTo
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** What the sources of `core` may import and call. */
class ArchitectureTest {
    private val root: Path = ProjectFiles.root.resolve("core/src/main/kotlin/dev/lazyz")

    private val sources: List<Path> = Files.walk(root).use { paths ->
        paths.filter { it.name.endsWith(".kt") }.sorted().toList()
    }

    private fun imports(source: Path): List<String> =
        source.readLines().filter {
            it.startsWith("import ")
        }.map { it.removePrefix("import ").substringBefore(" as ") }

    /** The package of a source below `dev.lazyz`; empty for that itself. */
    private fun room(source: Path): String = source.relativeTo(root).parent?.joinToString(".").orEmpty()

    /** The package that an import names, below `dev.lazyz`; null for other libraries. */
    private fun room(import: String): String? {
        if (!import.startsWith("dev.lazyz.")) return null
        val name = import.removePrefix("dev.lazyz.").split('.').takeWhile { it.first().isLowerCase() }.joinToString(".")
        return rooms.filter { name == it || name.startsWith("$it.") }.maxByOrNull(String::length)
    }

    private val rooms: Set<String> = sources.map(::room).toSet()
    private val page: String = ProjectFiles.root.resolve("docs/architecture.md").readText()

    /** The name of a strategy's package, or null for sources that belong to none. */
    private fun strategy(source: Path): String? =
        room(source).takeIf { it.startsWith("strategies.") }?.split('.')?.get(1)

    @Test
    fun sourcesAreFound() {
        assertTrue(sources.size > 30) { "only ${sources.size} sources in $root" }
        assertTrue(sources.any { strategy(it) == "zbuffer" })
    }

    @Test
    fun packagesImportOnlyThoseBelowThem() {
        assertEquals(emptySet<String>(), rooms.filter { it !in FLOORS && !it.startsWith("strategies.") }.toSet())
        val offences = sources.filter { it.relativeTo(root).toString() !in SEAMS }.flatMap { source ->
            val from = room(source)
            imports(source).mapNotNull { import ->
                val to = room(import)
                val isPermitted = to == null || to == from || floor(to) < floor(from)
                if (isPermitted) null else "$from/${source.name} imports $import"
            }
        }
        assertEquals(emptyList<String>(), offences)
    }

    /** How far up a package is; the packages of strategies that are no parts of `tiled` are on one floor. */
    private fun floor(room: String): Int = FLOORS.indexOf(if (room in FLOORS) room else "strategies.*")

    @Test
    fun seamsAreNeeded() {
        for (seam in SEAMS) {
            val source = root.resolve(seam)
            val above = imports(source).mapNotNull(::room).filter { floor(it) > floor(room(source)) }
            assertTrue(above.isNotEmpty()) { "$seam imports nothing from above: take it off the list" }
        }
    }

    /** Every package has a row on the page, which names only what is there. */
    @Test
    fun thePageShowsThePackages() {
        val rows = page.substringAfter("## Packages of").substringBefore("\n## ").lines().filter {
            it.startsWith("| `")
        }
        val shown = rows.associateBy { row -> row.substringAfter('`').substringBefore('`').removePrefix("dev.lazyz") }
        assertEquals(
            rooms.map {
                if (floor(it) ==
                    FLOORS.indexOf("strategies.*")
                ) {
                    "strategies.*"
                } else {
                    it
                }
            }.toSet(),
            shown.keys
        )
        for ((room, row) in shown) {
            val code = sources.filter { room(it) == room }.joinToString("\n") { it.readText() }
            for ((name) in Regex("`([A-Z]\\w+)").findAll(row).map { it.destructured }) {
                assertTrue(Regex("(class|object|interface) $name\\b").containsMatchIn(code)) { "$room has no $name" }
            }
        }
    }

    @Test
    fun thePageNamesTheFilesOfEachStep() {
        val roots = mapOf(
            "core" to root,
            "scenes" to ProjectFiles.root.resolve("scenes/src/main/kotlin/dev/lazyz/scenes")
        )
        val named = Regex("`(core|scenes): ([\\w/]+)`").findAll(page).map { it.destructured }.toList()
        assertTrue(named.size > 20) { "only ${named.size} files" }
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
            for (part in listOf("Source", "Order of evaluation", "Cost", "Where we differ, and why")) {
                assertTrue(page.readLines().any { it.startsWith("## $part") }) { "$page has no part '$part'" }
            }
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
                // A product of vectors' lanes is rounded as one of numbers is
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
            "StrictMath.sin(x)", "import kotlin.math.sqrt", "mesh.transformed(m)", "Math.floorMod(a, b)", "sqrt(x)",
            "Camera.perspective(a)", "StrictMath.pow(a, b)",
        )
        for (line in permitted) assertTrue(FORBIDDEN.none { it.containsMatchIn(line) }) { line }
    }

    private companion object {
        /** The packages from bottom to top: each imports only those before it, see `docs/architecture.md`. */
        val FLOORS = listOf(
            "", "raster", "geometry", "world", "shading", "setup", "setup.planar", "pipeline",
            "strategies.tiled.raster", "strategies.tiled.binning", "strategies.tiled.resolve",
            "strategies.*", "strategies",
        )

        /** The files by which scenes, and drawings on the screen, call set-up, which is above them. */
        val SEAMS = setOf("world/SetUp.kt", "world/FrameBuilder.kt")

        /** `java.` but for desktop and what has no place in a renderer. */
        val VECTORS = listOf("VectorBlockKernel", "VectorCoverageKernel", "VectorFragmentKernel")

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
