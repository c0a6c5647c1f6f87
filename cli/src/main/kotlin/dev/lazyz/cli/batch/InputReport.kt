package dev.lazyz.cli.batch

import java.nio.file.Path

/**
 * What there is to say about an input after it was rendered.
 *
 * @property messages warnings and other text for standard error
 * @property output statistics for standard output
 * @property files the files that were written
 * @property failure why a picture is missing, or null
 */
internal class InputReport(
    val input: String,
    val messages: String,
    val output: String,
    val files: List<Path>,
    val failure: Throwable?,
)
