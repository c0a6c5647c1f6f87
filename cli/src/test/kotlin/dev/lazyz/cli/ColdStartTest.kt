package dev.lazyz.cli

import java.io.File
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.readLines
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/**
 * Loading classes is most of the time of a start of zcli. Rendering a built-in scene to PNG must not load large
 * libraries.
 */
@EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
class ColdStartTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun renderingABuiltInToPngLoadsLittle() {
        val loaded = loadedBy("render", "teapot", "--size", "256x256", "-o", "teapot.png")
        assertEquals(listOf<String>(), loaded.filter { name -> HEAVY.any { name.startsWith(it) } })

        // Classes generated at run time cannot be archived, or are expensive to generate
        val spun = loaded.filter { name -> name.startsWith("dev.lazyz.") && SPUN.any { it in name } }
        assertEquals(listOf<String>(), spun)

        val count = loaded.count { name -> JAVA.none { name.startsWith(it) } }
        assertTrue(count in 100..MOST_CLASSES, "$count classes besides Java's own")
    }

    /** Returns the names of all classes that a process of zcli loads. */
    private fun loadedBy(vararg args: String): List<String> {
        val log = folder.resolve("classes.txt")
        val java = Path.of(System.getProperty("java.home"), "bin", "java").toString()
        val classPath = System.getProperty("java.class.path").split(File.pathSeparator)
            .joinToString(File.pathSeparator) { Path.of(it).toAbsolutePath().toString() }
        val words = listOf(java, "-Xlog:class+load:file=$log:none", "-cp", classPath, "dev.lazyz.cli.MainKt") + args
        val process = ProcessBuilder(words).directory(folder.toFile()).inheritIO().start()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES), "the process hangs")
        assertEquals(0, process.exitValue())
        return log.readLines().map { it.substringBefore(' ') }
    }

    private companion object {
        /** The measured number plus 5 percent. */
        const val MOST_CLASSES = 868

        val SPUN = listOf("$\$Lambda", "$\$StringConcat")

        val JAVA = listOf("java.", "javax.", "jdk.", "sun.", "com.sun.")

        val HEAVY = listOf(
            "java.awt.", "javax.imageio.", "sun.awt.", "sun.java2d.", "java.security.SecureRandom", "kotlinx.",
            "de.javagl.", "com.fasterxml.", "com.github.ajalt.mordant.", "io.github.earcut4j.", "net.jqwik.",
            "org.joml.Matrix", "org.joml.Options", "org.junit.", "dev.lazyz.conformance.", "dev.lazyz.scenes.gltf.",
            "dev.lazyz.scenes.obj.", "dev.lazyz.scenes.off.", "dev.lazyz.scenes.ply.", "dev.lazyz.scenes.scenefile.",
            "dev.lazyz.scenes.stl.", "dev.lazyz.scenes.threemf.",
        )
    }
}
