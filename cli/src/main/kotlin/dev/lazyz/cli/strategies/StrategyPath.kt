package dev.lazyz.cli.strategies

import dev.lazyz.Renderer
import dev.lazyz.cli.output.Mistake
import dev.lazyz.cli.output.Nearest
import dev.lazyz.strategies.Renderers
import java.io.Closeable
import java.io.File
import java.io.IOException
import java.net.URLClassLoader
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipFile

/**
 * Strategies from jars that the user names, besides those of zcli's own class path. While it is open, this thread sees
 * the jars too.
 *
 * @param words jars and folders, or several of them with [File.pathSeparator] between them
 * @throws Mistake if one is missing or is no jar
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
            places.isEmpty() -> "Where is it? Say --classpath JAR; 'zcli strategies' lists those of zcli's own."
            offered.isEmpty() -> "Nothing on the class path is named in META-INF/services/dev.lazyz.Renderer."
            else -> "The class path offers ${offered.joinToString()}."
        }
        return "no strategy '$id'${Nearest.hint(id, all)}\n$where"
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
            throw Mistake("--classpath: $path is no jar: ${bad.message}")
        }
        return path
    }

    companion object {
        /** Runs [work] with the strategies of the jars called [words], if there are any, besides zcli's own. */
        fun <T> with(words: List<String>, work: () -> T): T =
            if (words.isEmpty()) work() else StrategyPath(words).use { work() }
    }
}
