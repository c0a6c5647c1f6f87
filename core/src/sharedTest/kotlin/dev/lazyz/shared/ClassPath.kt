package dev.lazyz.shared

import java.io.File

/** The class path of the tests, as the build tool made it. */
internal object ClassPath {
    /** Folders of classes and jars. */
    val entries: List<File> = (System.getProperty("surefire.test.class.path") ?: System.getProperty("java.class.path"))
        .split(File.pathSeparator).map(::File)
}
