package dev.lazyz.cli.output

/** Which zcli this is: the version in the jar's manifest. */
internal object Version {
    val text: String get() = Version::class.java.`package`?.implementationVersion ?: "(development)"
}
