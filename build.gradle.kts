import com.diffplug.gradle.spotless.SpotlessExtension
import java.time.Duration
import java.util.zip.ZipFile
import org.jetbrains.dokka.gradle.DokkaExtension
import org.jetbrains.kotlin.gradle.dsl.JvmDefaultMode
import org.jetbrains.kotlin.gradle.dsl.JvmTarget
import org.jetbrains.kotlin.gradle.dsl.KotlinJvmProjectExtension
import org.jetbrains.kotlin.gradle.dsl.KotlinVersion

plugins {
    alias(libs.plugins.dokka) apply false
    alias(libs.plugins.kotlin.jvm) apply false
    alias(libs.plugins.kotlin.serialization) apply false
    alias(libs.plugins.spotless) apply false
}

val catalog = libs
val javaRelease = 17

/** A jar that runs alone: its file name and main class, by module. */
val fatJars = mapOf(
    "cli" to ("zcli" to "dev.lazyz.cli.MainKt"),
    "server" to ("lazyz-server" to "dev.lazyz.server.MainKt"),
    "mcp" to ("lazyz-mcp" to "dev.lazyz.mcp.MainKt"),
    "jmh" to ("benchmarks" to "org.openjdk.jmh.Main"),
)

configure(subprojects.filter { it.name != "bom" }) {
    apply(plugin = "java-library")
    apply(plugin = catalog.plugins.kotlin.jvm.get().pluginId)
    apply(plugin = catalog.plugins.kotlin.serialization.get().pluginId)
    apply(plugin = catalog.plugins.spotless.get().pluginId)

    configure<BasePluginExtension> {
        archivesName = "lazyz-${project.name}"
    }

    // The last lists the public API, see PublicApiTest
    dependencies {
        "api"(catalog.kotlin.stdlib)
        "testImplementation"(platform(catalog.junit.bom))
        "testImplementation"(catalog.junit.jupiter)
        "testImplementation"(catalog.jqwik)
        "testRuntimeOnly"(catalog.junit.platform.launcher)
        "testImplementation"(catalog.abi.tools)
    }

    configure<KotlinJvmProjectExtension> {
        // What tests of all modules share, and the tests that each module runs
        sourceSets["test"].kotlin.srcDir(rootProject.file("core/src/sharedTest/kotlin"))
        compilerOptions {
            allWarningsAsErrors = true
            // For users with an older Kotlin: Kotlin 2.1 reads classes of 2.2, and has all functions of 2.1
            languageVersion = KotlinVersion.fromVersion("2.2")
            apiVersion = KotlinVersion.fromVersion("2.1")
            freeCompilerArgs.add("-Xsuppress-version-warnings")
            jvmDefault = JvmDefaultMode.NO_COMPATIBILITY
            moduleName = "lazyz-${project.name}"
            jvmTarget = JvmTarget.fromTarget(javaRelease.toString())
            // The module is for one class of core, which is loaded only where the JVM has it
            freeCompilerArgs.addAll("-Xjdk-release=$javaRelease", "-Xadd-modules=jdk.incubator.vector")
            // Classes of the jar start sooner than ones that Java spins at run time
            freeCompilerArgs.addAll("-Xlambdas=class", "-Xsam-conversions=class", "-Xstring-concat=inline")
        }
    }

    tasks.withType<JavaCompile>().configureEach {
        options.release = javaRelease
        // That core's descriptor requires an incubating module is a warning in any case
        if (name != "descriptor") {
            options.compilerArgs.addAll(listOf("-Xlint:all,-processing,-path,-classfile", "-Werror"))
        }
    }

    tasks.withType<Jar>().configureEach {
        isPreserveFileTimestamps = false
        isReproducibleFileOrder = true
        manifest.attributes(
            "Implementation-Title" to project.name,
            "Implementation-Version" to project.version,
            "Automatic-Module-Name" to "dev.lazyz.${project.name}",
        )
    }

    tasks.withType<Test>().configureEach {
        useJUnitPlatform()
        jvmArgs("--add-modules", "jdk.incubator.vector", "-XX:+UseSerialGC", "-XX:MarkSweepAlwaysCompactCount=1")
        // Many short tests take twice the processor time with the optimizing compiler
        jvmArgs("-XX:TieredStopAtLevel=1", "-XX:CompileThresholdScaling=0.1", "-XX:MaxVectorSize=8")
        maxParallelForks = 1
        include("**/*Test.class", "**/*Properties.class", "**/*Example.class")
        systemProperty("jqwik.database", "")
        systemProperty("jqwik.reporting.onlyfailures", "true")
        systemProperties(providers.systemPropertiesPrefixedBy("lazyz.").get())
        // A test that hangs fails by its name; the last net is for a JVM that does not end
        systemProperty("junit.jupiter.execution.timeout.testable.method.default", "20 m")
        systemProperty("junit.jupiter.execution.timeout.thread.mode.default", "SEPARATE_THREAD")
        timeout = Duration.ofHours(2)
    }

    configure<SpotlessExtension> {
        kotlin {
            target("src/*/kotlin/**/*.kt")
            ktlint(catalog.versions.ktlint.get())
        }
        java {
            palantirJavaFormat(catalog.versions.palantir.get())
        }
    }
}

// The libraries that go to Maven Central, with sources and documentation.
for (module in listOf("core", "scenes", "conformance", "testing", "server", "spark", "swing")) {
    project(":$module") {
        apply(plugin = catalog.plugins.dokka.get().pluginId)

        configure<JavaPluginExtension> {
            withSourcesJar()
        }
        configure<DokkaExtension> {
            moduleName = "lazyz-$module"
            dokkaPublications.configureEach { failOnWarning = true }
            dokkaSourceSets.configureEach {
                jdkVersion = javaRelease
                includes.from("api/packages.md")
                // Links to other libraries' pages would need a network
                enableJdkDocumentationLink = false
                enableKotlinStdLibDocumentationLink = false
            }
        }
        val javadocJar = tasks.register<Jar>("javadocJar") {
            archiveClassifier = "javadoc"
            from(tasks.named("dokkaGeneratePublicationHtml"))
        }
        publish("java", "Lazy Z $module") { artifact(javadocJar) }
    }
}

// Descriptors of modules go into the jar only, so that compilers and tests go on without modules.
for (module in listOf("core", "scenes")) {
    project(":$module") {
        val main = the<SourceSetContainer>()["main"]
        val modulePath = files(configurations.named("runtimeClasspath"))
        val descriptor = tasks.register<JavaCompile>("descriptor") {
            source("src/main/module")
            classpath = files()
            destinationDirectory = layout.buildDirectory.dir("descriptor")
            inputs.files(modulePath, main.output.classesDirs)
            options.compilerArgumentProviders.add {
                val classes = "dev.lazyz.$module=${main.output.classesDirs.asPath}"
                listOf("--module-path", modulePath.asPath, "--patch-module", classes)
            }
        }
        tasks.named<Jar>("jar") { from(descriptor) }
    }
}

// The versions that belong together.
project(":bom") {
    apply(plugin = "java-platform")
    publish("javaPlatform", "Lazy Z BOM")
}

/** Publishes a component, with what Maven Central demands of a POM. */
fun Project.publish(component: String, title: String, more: MavenPublication.() -> Unit = {}) {
    apply(plugin = "maven-publish")

    configure<PublishingExtension> {
        repositories {
            maven {
                name = "folder"
                url = uri(rootProject.layout.buildDirectory.dir("publication"))
            }
        }
        publications.create<MavenPublication>("maven") {
            from(components[component])
            more()
            artifactId = "lazyz-${project.name}"
            pom {
                name = title
                description = provider { project.description }
                url = "https://github.com/lazyz/lazyz"
                inceptionYear = "2026"
                licenses {
                    license {
                        name = "Apache-2.0"
                        url = "https://www.apache.org/licenses/LICENSE-2.0.txt"
                        distribution = "repo"
                    }
                }
                developers {
                    developer {
                        name = "Lazy Z developers"
                        url = "https://github.com/lazyz/lazyz"
                    }
                }
                scm {
                    connection = "scm:git:https://github.com/lazyz/lazyz.git"
                    developerConnection = "scm:git:https://github.com/lazyz/lazyz.git"
                    url = "https://github.com/lazyz/lazyz"
                }
            }
        }
    }
}

for ((module, jar) in fatJars) {
    project(":$module") {
        val main = the<SourceSetContainer>()["main"]
        val runtimeClasspath = configurations.named("runtimeClasspath")

        // Service files and licences of the same name become one
        val mergeTexts = tasks.register("mergeTexts") {
            val jars = files(runtimeClasspath)
            val folder = layout.buildDirectory.dir("merged-texts")
            inputs.files(jars)
            outputs.dir(folder)
            doLast {
                val merged = Regex("META-INF/(services/.+|LICENSE|NOTICE)")
                val root = folder.get().asFile
                root.deleteRecursively()
                for (jar in jars.files.filter { it.isFile }) {
                    ZipFile(jar).use { zip ->
                        for (entry in zip.entries().asSequence().filter { it.name.matches(merged) }) {
                            val text = zip.getInputStream(entry).reader().readText().trimEnd()
                            root.resolve(entry.name).apply { parentFile.mkdirs() }.appendText("$text\n")
                        }
                    }
                }
            }
        }
        val fatJar = tasks.register<Jar>("fatJar") {
            archiveFileName = "${jar.first}.jar"
            manifest.attributes("Main-Class" to jar.second, "Multi-Release" to "true")
            duplicatesStrategy = DuplicatesStrategy.EXCLUDE
            from(mergeTexts)
            // The bill of materials, see BillOfMaterialsTest
            from("src/main/sbom") { into("META-INF/sbom") }
            from(main.output)
            from(runtimeClasspath.map { files -> files.map { if (it.isDirectory) it else zipTree(it) } })
            exclude("META-INF/*.DSA", "META-INF/*.RSA", "META-INF/*.SF")
            exclude("META-INF/kotlin-project-structure-metadata.json", "META-INF/maven/**", "*Main/default/**")
            exclude("module-info.class", "META-INF/versions/*/module-info.class")
        }
        tasks.named("assemble") { dependsOn(fatJar) }
    }
}
