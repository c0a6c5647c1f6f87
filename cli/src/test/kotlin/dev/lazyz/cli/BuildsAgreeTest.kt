package dev.lazyz.cli

import java.nio.file.Path
import javax.xml.parsers.DocumentBuilderFactory
import kotlin.io.path.exists
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.DisabledIfSystemProperty
import org.w3c.dom.Element

/**
 * The Maven build and the Gradle build must be equivalent. Both are read as text, so this test runs in either of them.
 *
 * The test requires a fixed form of Gradle files: a dependency is one line `scope(libs.some.name)`,
 * `scope(project(":module"))` or `scope(platform(libs.some.bom))`, and every version is in the catalog.
 */
@DisabledIfSystemProperty(named = "lazyz.effort", matches = "rest")
class BuildsAgreeTest {
    private val root: Path = ProjectFiles.root

    private val pom = xml("pom.xml")
    private val catalog = Catalog(text("gradle/libs.versions.toml"))
    private val gradleRoot = text("build.gradle.kts")
    private val surefire = pom.child("build").child("plugins").children("plugin")
        .single { it.value("artifactId") == "maven-surefire-plugin" }

    /** The folders of the modules, by their names in Gradle. */
    private val folders = pom.child("modules").children("module").map { it.textContent }
        .associateBy { it.substringAfterLast('/') }
    private val modules = folders.keys.toList() - "bom"
    private val published = quoted(Regex("""for \(module in listOf\((.*)\)\)""").find(gradleRoot)!!.groupValues[1])

    @Test
    fun modules() {
        val included = Regex("""include\((.*?)\)""", RegexOption.DOT_MATCHES_ALL).findAll(text("settings.gradle.kts"))
        assertEquals(folders.keys, included.flatMap { quoted(it.groupValues[1]) }.toSet())
        val moved = Regex("""project\(":(.*)"\).projectDir = file\("(.*)"\)""").findAll(text("settings.gradle.kts"))
            .associate { it.groupValues[1] to it.groupValues[2] }
        assertEquals(folders.filter { (name, folder) -> name != folder }, moved)
    }

    @Test
    fun coordinatesAndDescriptions() {
        val gradle = properties("gradle.properties")
        assertEquals(pom.value("groupId"), gradle["group"])
        assertEquals(pom.value("version"), gradle["version"])
        assertTrue("""artifactId = "lazyz-${'$'}{project.name}"""" in gradleRoot, "artifactId in build.gradle.kts")
        for (module in folders.keys) {
            val modulePom = modulePom(module)
            assertEquals("lazyz-$module", modulePom.value("artifactId"))
            val versioned = modulePom.childOrNull("parent") ?: modulePom
            assertEquals(pom.value("version"), versioned.value("version"), "version of $module")
            val description = Regex("""^description = "(.*)"$""", RegexOption.MULTILINE).find(gradleFile(module))
            assertEquals(modulePom.value("description"), description?.groupValues?.get(1), "description of $module")
        }
    }

    @Test
    fun versions() {
        val maven = pom.child("properties").children()
            .filter { it.tagName.endsWith(".version") }
            .associate { it.tagName.removeSuffix(".version") to it.textContent }
        // Spotless has a plugin for each build tool, each with its own version
        assertEquals(maven, catalog.versions - "spotless")
    }

    @Test
    fun librariesAndTheirVersions() {
        val managed = pom.child("dependencyManagement").child("dependencies").children("dependency")
            .associate { it.coordinates() to it.value("version") }
        for ((name, library) in catalog.libraries) {
            // A library without a version takes it from a BOM
            val version = library.version ?: continue
            val expected = managed[library.module] ?: continue
            assertEquals("\${$version.version}", expected, name)
        }
        val versioned = catalog.libraries.values.filter { it.version != null }.map { it.module }
        val own = managed.keys.filter { it.startsWith("dev.lazyz:") }
        val pinned = managed.filterValues { !it.startsWith("\${") }.keys
        assertEquals(managed.keys - own.toSet() - pinned, versioned.toSet())
    }

    @Test
    fun dependencies() {
        val inherited = pom.child("dependencies").children("dependency").map(::mavenDependency).toSet()
        val given = gradleDependencies(gradleRoot)
        assertEquals(inherited, given - LAUNCHER, "every module")
        for (module in modules) {
            val maven = modulePom(module).child("dependencies").children("dependency").map(::mavenDependency)
            assertEquals(maven.toSet(), gradleDependencies(gradleFile(module)), module)
        }
    }

    @Test
    fun compilerSettings() {
        val properties = pom.child("properties")
        assertTrue("val javaRelease = ${properties.value("java.release")}\n" in gradleRoot, "Java release")
        val compiler = pom.child("build").child("plugins").textContent
        assertEquals("-Werror" in compiler, "allWarningsAsErrors = true" in gradleRoot, "warnings as errors")
        for (version in listOf("languageVersion", "apiVersion")) {
            val gradle = Regex("""\b$version = KotlinVersion.fromVersion\("(.*)"\)""").find(gradleRoot)
            assertEquals(properties.value("kotlin.compiler.$version"), gradle?.groupValues?.get(1), version)
        }
        assertEquals("-Xsuppress-version-warnings" in compiler, "\"-Xsuppress-version-warnings\"" in gradleRoot)
        assertEquals("-jvm-default=no-compatibility" in compiler, "JvmDefaultMode.NO_COMPATIBILITY" in gradleRoot)
        val lint = Regex("""-Xlint:[\w,-]+""")
        assertEquals(lint.find(compiler)?.value, lint.find(gradleRoot)?.value, "javac's lint")
        for (module in modules) {
            val strict = modulePom(module).childOrNull("properties")?.valueOrNull("explicit.api") == "strict"
            assertEquals(strict, "explicitApi()" in gradleFile(module), "explicit API of $module")
        }
    }

    @Test
    fun moduleNames() {
        assertTrue("\"Automatic-Module-Name\" to \"dev.lazyz.\${project.name}\"" in gradleRoot)
        for (module in modules) {
            assertEquals("dev.lazyz.$module", modulePom(module).child("properties").value("module.name"))
        }
    }

    /** A module exports the packages that have a text, which are those with public types. */
    @Test
    fun moduleDescriptors() {
        val withDescriptor = modules.filter { folder(it).resolve("src/main/module/module-info.java").exists() }
        assertTrue("core" in withDescriptor)
        val gradle = Regex("""(?m)^// Descriptors.*\nfor \(module in listOf\((.*)\)\)""").find(gradleRoot)!!
        assertEquals(withDescriptor, quoted(gradle.groupValues[1]))
        for (module in modules) {
            val skip = modulePom(module).child("properties").valueOrNull("descriptor.skip")
            assertEquals(if (module in withDescriptor) "false" else null, skip, module)
        }
        for (module in withDescriptor) {
            val descriptor = text("${folders.getValue(module)}/src/main/module/module-info.java")
            assertTrue("module dev.lazyz.$module {" in descriptor, module)
            val exported = Regex("""(?m)^ +exports (.*);$""").findAll(descriptor).map { it.groupValues[1] }
            val texts = Regex("""(?m)^# Package (.*)$""").findAll(text("${folders.getValue(module)}/api/packages.md"))
            assertEquals(texts.map { it.groupValues[1] }.toSet(), exported.toSet(), module)
        }
    }

    /** The BOM has no parent, so it repeats what users see of it. It lists what is published. */
    @Test
    fun bom() {
        val bom = xml("bom/pom.xml")
        assertTrue(bom.childOrNull("parent") == null)
        for (fact in listOf("groupId", "version", "url", "inceptionYear", "licenses", "developers", "scm")) {
            fun text(pom: Element) = pom.value(fact).replace(Regex("""\s+"""), " ")
            assertEquals(text(pom), text(bom), fact)
        }
        val managed = bom.child("dependencyManagement").child("dependencies").children("dependency")
        assertEquals(setOf("\${project.version}"), managed.map { it.value("version") }.toSet())
        assertEquals(published.map { "dev.lazyz:lazyz-$it" }, managed.map { it.coordinates() })
        val constraints = Regex("""api\(project\(":(.*)"\)\)""").findAll(gradleFile("bom")).map { it.groupValues[1] }
        assertEquals(published, constraints.toList())

        val plugins = pom.child("build").child("pluginManagement").child("plugins").children("plugin")
        for (plugin in bom.child("build").child("pluginManagement").child("plugins").children("plugin")) {
            val same = plugins.single { it.coordinates() == plugin.coordinates() }
            assertEquals(same.value("version"), plugin.value("version"), plugin.coordinates())
        }
        fun signatures(pom: Element) = pom.child("profiles").children("profile")
            .single { it.value("id") == "release" }.child("build").child("plugins").children("plugin")
            .single { it.value("artifactId") == "maven-gpg-plugin" }.textContent
        assertEquals(signatures(pom), signatures(bom))
    }

    @Test
    fun testClasses() {
        val included = surefire.child("configuration").child("includes").children("include").map { it.textContent }
        val gradle = Regex("""\binclude\((.*)\)""").find(gradleRoot)!!
        assertEquals(included, quoted(gradle.groupValues[1]))
    }

    @Test
    fun parametersOfTests() {
        val maven = surefire.child("configuration").child("properties").value("configurationParameters").lines()
            .associate { it.substringBefore('=').trim() to it.substringAfter('=').trim() }
        val gradle = Regex("""\bsystemProperty\("(.*)", "(.*)"\)""").findAll(gradleRoot)
        assertEquals(maven, gradle.associate { it.groupValues[1] to it.groupValues[2] })
    }

    @Test
    fun sharedTests() {
        val maven = Regex("""<sourceDir>\$\{project.parent.basedir}/(.*)</sourceDir>""")
        val gradle = Regex("""kotlin.srcDir\(rootProject.file\("(.*)"\)\)""").find(gradleRoot)!!.groupValues[1]
        assertEquals(maven.find(text("pom.xml"))!!.groupValues[1], gradle)
        assertTrue(root.resolve(gradle).exists(), gradle)
    }

    @Test
    fun jvmsOfTests() {
        val properties = pom.child("properties")
        val maven = properties.value("test.jvms")
        assertEquals(maven, Regex("""maxParallelForks = (\d+)""").find(gradleRoot)?.groupValues?.get(1))
        val options = Regex("""\bjvmArgs\((.*)\)""").findAll(gradleRoot).flatMap { quoted(it.groupValues[1]) }
        assertEquals(listOf("test.options", "test.quick").flatMap { properties.value(it).split(" ") }, options.toList())
    }

    @Test
    fun javaSources() {
        // Gradle compiles src/main/java in every module, Maven only if the POM names it
        for (module in modules) {
            val named = modulePom(module).childOrNull("build")?.valueOrNull("sourceDirectory") == "src/main/java"
            if (folder(module).resolve("src/main/java").exists()) assertTrue(named, "src/main/java of $module")
        }
    }

    @Test
    fun fatJarsAndPublications() {
        for (module in modules) {
            val properties = modulePom(module).childOrNull("properties")
            assertEquals(
                properties?.valueOrNull("maven.deploy.skip") != "true",
                module in published,
                "$module published"
            )
            val name = properties?.valueOrNull("fat.jar.name")
            val jar = Regex(""""$module" to \("(.*)" to "(.*)"\)""").find(gradleRoot)
            assertEquals(name, jar?.groupValues?.get(1), "fat jar of $module")
            assertEquals(properties?.valueOrNull("fat.jar.main"), jar?.groupValues?.get(2), "main class of $module")
            val exports = Regex(""""Add-Exports" to "(.*)"""").find(gradleFile(module))?.groupValues?.get(1)
            assertEquals(properties?.valueOrNull("fat.jar.exports"), exports, "exports to $module")
            assertEquals(VectorModule.EXPORT.takeIf { module == "cli" }, exports, "exports to $module")
        }
    }

    private fun mavenDependency(element: Element): String {
        val scope = when (val scope = element.valueOrNull("scope") ?: "compile") {
            "provided" -> if (element.value("artifactId").endsWith("annprocess")) "processor" else scope
            else -> scope
        }
        val module = when (element.value("groupId")) {
            "dev.lazyz" -> element.value("artifactId").replace("lazyz-", ":")
            else -> element.coordinates()
        }
        val exclusions = element.childOrNull("exclusions")?.children("exclusion").orEmpty().map { it.coordinates() }
        return "$scope $module" + exclusions.sorted().joinToString("") { " without $it" }
    }

    private fun gradleDependencies(build: String): Set<String> {
        val excluded = Regex("""exclude\(group = "(.*)", module = "(.*)"\)""").findAll(build)
            .map { it.groupValues[1] + ":" + it.groupValues[2] }.sorted().toList()
        val block =
            Regex("""^( *)dependencies \{\n(.*?)\n\1}""", setOf(RegexOption.MULTILINE, RegexOption.DOT_MATCHES_ALL))
        val lines = block.findAll(build).flatMap {
            it.groupValues[2].lines()
        }.map { it.trim() }.filter { it.isNotEmpty() }
        return lines.filterNot { "(platform(" in it }.map { line ->
            val (configuration, what) = checkNotNull(DEPENDENCY.matchEntire(line)) {
                "not understood: $line"
            }.destructured
            val scope = checkNotNull(SCOPES[configuration]) { "not understood: $line" }
            val project = Regex("""project\("(.*)"\)""").matchEntire(what)?.groupValues?.get(1)
            if (project != null) {
                "$scope $project"
            } else {
                val module = catalog.library(what)
                val hasExcluded = EXCLUDING.any { module.startsWith("$it:") }
                val without = if (hasExcluded) excluded else emptyList()
                "$scope $module" + without.joinToString("") { " without $it" }
            }
        }.toSet()
    }

    private fun folder(module: String) = root.resolve(folders.getValue(module))

    private fun modulePom(module: String) = xml("${folders.getValue(module)}/pom.xml")

    private fun gradleFile(module: String) = text("${folders.getValue(module)}/build.gradle.kts")

    private fun text(path: String) = root.resolve(path).readText()

    private fun xml(path: String): Element =
        DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(root.resolve(path).toFile()).documentElement

    private fun properties(path: String): Map<String, String> =
        text(path).lines().filter { " = " in it }.associate { it.substringBefore(" = ") to it.substringAfter(" = ") }

    /** The contents of gradle/libs.versions.toml, read line by line. */
    private class Catalog(toml: String) {
        class Library(val module: String, val version: String?)

        private val tables = toml.split(Regex("""^\[""", RegexOption.MULTILINE)).drop(1).associate { table ->
            val entries = table.lines().drop(1).filter { " = " in it }
            table.substringBefore("]") to entries.associate { it.substringBefore(" = ") to it.substringAfter(" = ") }
        }

        val versions = tables.getValue("versions").mapValues { it.value.trim('"') }

        val libraries = tables.getValue("libraries").mapValues { (_, value) ->
            fun field(name: String) = Regex("""\b$name = "(.*?)"""").find(value)?.groupValues?.get(1)
            Library(checkNotNull(field("module")), field("version.ref"))
        }

        fun library(accessor: String): String {
            val name = accessor.substringAfter("libs.").substringAfter("catalog.").replace('.', '-')
            return checkNotNull(libraries[name]) { "not in the catalog: $accessor" }.module
        }
    }

    private companion object {
        /** Groups of libraries that a build takes without some of what they need. */
        val EXCLUDING = listOf("com.github.ajalt.clikt", "com.github.ajalt.mordant", "io.modelcontextprotocol.sdk")

        val DEPENDENCY = Regex(""""?(\w+)"?\((.*)\)""")
        val SCOPES = mapOf(
            "api" to "compile", "implementation" to "compile", "compileOnly" to "provided", "runtimeOnly" to "runtime",
            "annotationProcessor" to "processor", "testImplementation" to "test", "testRuntimeOnly" to "test",
        )

        /** Surefire includes the launcher. */
        const val LAUNCHER = "test org.junit.platform:junit-platform-launcher"

        fun quoted(text: String) = Regex(""""(.*?)"""").findAll(text).map { it.groupValues[1] }.toList()

        fun Element.children(name: String? = null): List<Element> =
            (0 until childNodes.length).mapNotNull { childNodes.item(it) as? Element }
                .filter { name == null || it.tagName == name }

        fun Element.childOrNull(name: String) = children(name).singleOrNull()

        fun Element.child(name: String) = checkNotNull(childOrNull(name)) { "no <$name> in <$tagName>" }

        fun Element.valueOrNull(name: String) = childOrNull(name)?.textContent?.trim()

        fun Element.value(name: String) = child(name).textContent.trim()

        fun Element.coordinates() = "${value("groupId")}:${value("artifactId")}"
    }
}
