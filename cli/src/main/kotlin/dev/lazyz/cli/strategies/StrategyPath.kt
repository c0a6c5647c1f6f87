package dev.lazyz.cli.strategies

import dev.lazyz.Renderer
import dev.lazyz.cli.output.Mistake
import dev.lazyz.scenes.text.EditDistance
import dev.lazyz.strategies.Renderers
import java.io.Closeable
import java.io.File
import java.io.IOException
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipFile

/**
 * Makes strategies from the user's jars available, besides those on the class path of zcli. While this object is open,
 * the class loader of the calling thread includes the jars.
 *
 * @param words jars and folders; a word can contain several, separated by [File.pathSeparator]
 * @throws Mistake if one is missing or is not a jar
 */
internal class StrategyPath(words: List<String>) : Closeable {
    private val thread = Thread.currentThread()
    private val before: ClassLoader? = thread.contextClassLoader
    private val places = words.flatMap { it.split(File.pathSeparator) }.filter { it.isNotEmpty() }.map { checked(it) }
    private val loader = URLClassLoader(
        places.map { it.toUri().toURL() }.toTypedArray(),
        before ?: StrategyPath::class.java.classLoader,
    )

    init {
        thread.contextClassLoader = loader
    }

    /** Returns the strategy called [id]. */
    fun find(id: String): Renderer {
        val all = Strategies.all()
        return all.firstOrNull { it.id == id } ?: throw Mistake(notFound(id, all.map { it.id }))
    }

    private fun notFound(id: String, all: List<String>): String {
        val offered = all - Renderers.builtIn.map { it.id }.toSet()
        val where = when {
            places.isEmpty() -> "Add its jar with --classpath JAR; 'zcli strategies' lists the built-in strategies."
            offered.isEmpty() -> "Nothing on the class path is named in META-INF/services/dev.lazyz.Renderer."
            else -> "The class path offers ${offered.joinToString()}."
        }
        return "no strategy '$id'${EditDistance.hint(id, all)}\n$where"
    }

    override fun close() {
        thread.contextClassLoader = before
        loader.close()
    }

    private fun checked(word: String): Path {
        val path = Path.of(word)
        if (!Files.exists(path)) throw Mistake("--classpath: $path: no such file or folder")
        if (Files.isDirectory(path)) return path
        try {
            ZipFile(path.toFile()).close()
        } catch (bad: IOException) {
            throw Mistake("--classpath: $path is not a jar: ${bad.message}")
        }
        return path
    }

    companion object {
        /** Runs [work] while the strategies of the jars [words], if any, are available. */
        fun <T> with(words: List<String>, work: () -> T): T =
            if (words.isEmpty()) work() else StrategyPath(words).use { work() }
    }
}
