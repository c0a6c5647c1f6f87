package dev.lazyz.conformance.probes

import java.util.Locale
import java.util.SimpleTimeZone
import java.util.TimeZone

/**
 * A setting that a renderer shares with its caller.
 *
 * @param mark a value that no renderer would set, given the usual value
 */
private class SharedSetting<T>(
    val name: String,
    private val get: () -> T,
    private val set: (T) -> Unit,
    private val mark: (usual: T) -> T,
) {
    /** Sets the mark. */
    fun marked(): Marked = Marked(get())

    inner class Marked(private val usual: T) {
        private val mark: T = mark(usual).also { set(it) }

        /** The name of the setting, if it is not the mark any longer; otherwise null. */
        val changed: String? get() = name.takeIf { get() != mark }

        fun restore(): Unit = set(usual)
    }
}

/** Settings of the process, and of the calling thread. */
private fun settings(): List<SharedSetting<*>> {
    val thread = Thread.currentThread()
    val locales = Locale.Category.entries
    return listOf(
        SharedSetting(
            "default locale",
            { listOf(Locale.getDefault()) + locales.map { Locale.getDefault(it) } },
            { all ->
                Locale.setDefault(all.first())
                locales.zip(all.drop(1)).forEach { (category, locale) -> Locale.setDefault(category, locale) }
            },
            { all -> all.map { Locale.Builder().setLocale(it).setRegion(NO_REGION).build() } },
        ),
        SharedSetting(
            "default time zone",
            { TimeZone.getDefault() },
            { TimeZone.setDefault(it) },
            { SimpleTimeZone(it.rawOffset, NAME) },
        ),
        SharedSetting(
            "handler of uncaught exceptions",
            { Thread.getDefaultUncaughtExceptionHandler() },
            { Thread.setDefaultUncaughtExceptionHandler(it) },
            { usual -> handlerLike(usual) },
        ),
        SharedSetting("name of the calling thread", { thread.name }, { thread.name = it }, { NAME }),
        SharedSetting("priority of the calling thread", { thread.priority }, { thread.priority = it }, { LOW }),
        SharedSetting(
            "context class loader of the calling thread",
            { thread.contextClassLoader },
            { thread.contextClassLoader = it },
            { usual -> object : ClassLoader(usual) {} },
        ),
    )
}

/** A handler that does what [usual] does, or what the JVM does without one. */
private fun handlerLike(usual: Thread.UncaughtExceptionHandler?) = Thread.UncaughtExceptionHandler { thread, failure ->
    if (usual != null) usual.uncaughtException(thread, failure) else failure.printStackTrace()
}

/** Returns the setting that [block] changes, even to the value that it had before; null if there is none. */
internal fun settingChangedBy(block: () -> Unit): String? {
    val marked = settings().map { it.marked() }
    return try {
        block()
        marked.firstNotNullOfOrNull { it.changed }
    } finally {
        for (it in marked) it.restore()
    }
}

private const val NAME = "lazyz-conformance-caller"

/** A code that ISO leaves to its users. */
private const val NO_REGION = "XZ"
private const val LOW = Thread.NORM_PRIORITY - 1
