package dev.lazyz.conformance.probes

import java.util.Locale
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
    fun marked(): Watched = get().let { usual -> Watched(usual, mark(usual).also { set(it) }) }

    /** Leaves the setting as it is. */
    fun kept(): Watched = get().let { Watched(it, it) }

    /** This setting, which had the value [usual], and now has the value [current] unless something changes it. */
    inner class Watched(private val usual: T, private val current: T) {
        /** The name of the setting, if it has changed; otherwise null. */
        val changed: String? get() = name.takeIf { get() != current }

        fun restore(): Unit = set(usual)
    }
}

private val locales = Locale.Category.entries

/** Valid zones, because other threads of the process may ask for the time. */
private val rareZones = listOf("Antarctica/Troll", "Pacific/Chatham").map { TimeZone.getTimeZone(it) }

/** Settings of the process. */
private val settingsOfTheProcess: List<SharedSetting<*>> = listOf(
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
        { usual -> rareZones.first { it.id != usual.id } },
    ),
    SharedSetting(
        "handler of uncaught exceptions",
        { Thread.getDefaultUncaughtExceptionHandler() },
        { Thread.setDefaultUncaughtExceptionHandler(it) },
        { usual -> handlerLike(usual) },
    ),
)

private fun settingsOf(thread: Thread): List<SharedSetting<*>> = listOf(
    SharedSetting("name of the calling thread", { thread.name }, { thread.name = it }, { NAME }),
    SharedSetting("priority of the calling thread", { thread.priority }, { thread.priority = it }, { LOW }),
    SharedSetting(
        "context class loader of the calling thread",
        { thread.contextClassLoader },
        { thread.contextClassLoader = it },
        { usual -> object : ClassLoader(usual) {} },
    ),
)

/** A handler that does what [usual] does, or what the JVM does without one. */
private fun handlerLike(usual: Thread.UncaughtExceptionHandler?) = Thread.UncaughtExceptionHandler { thread, failure ->
    if (usual != null) usual.uncaughtException(thread, failure) else failure.printStackTrace()
}

/** Returns the setting that [block] changes, even to the value that it had before; null if there is none. */
internal fun settingChangedBy(block: () -> Unit): String? {
    val marked = (settingsOfTheProcess + settingsOf(Thread.currentThread())).map { it.marked() }
    return try {
        block()
        marked.firstNotNullOfOrNull { it.changed }
    } finally {
        for (it in marked) it.restore()
    }
}

/** The settings of the process when this object was made. */
internal class SettingsBefore {
    private val kept = settingsOfTheProcess.map { it.kept() }
    private var restored: String? = null

    /** The name of a setting that has been changed since then; null if there is none. */
    val changed: String? get() = restored ?: kept.firstNotNullOfOrNull { it.changed }

    /** Restores the settings, because some changes would disturb the suite itself. */
    fun restore() {
        restored = changed
        for (it in kept) it.restore()
    }
}

private const val NAME = "lazyz-conformance-caller"

/** A code that ISO leaves to its users. */
private const val NO_REGION = "XZ"
private const val LOW = Thread.NORM_PRIORITY - 1
