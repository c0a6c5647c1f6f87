package dev.lazyz.cli.output

/** The version of zcli, from the manifest of the jar. */
internal object Version {
    val text: String get() = Version::class.java.`package`?.implementationVersion ?: "(development)"
}
