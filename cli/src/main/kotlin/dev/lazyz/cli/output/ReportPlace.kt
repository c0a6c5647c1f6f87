package dev.lazyz.cli.output

import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.name

/**
 * Where a report goes, by the value [path] of [option]: a page `NAME.html` alone, or a folder, in which the page is
 * `report.html`. A folder that does not exist has no extension.
 *
 * @throws Mistake if it is neither, or cannot be written
 */
internal class ReportPlace(path: Path, option: String) {
    private val extension = path.name.drop(1).substringAfterLast('.', "")

    /** The folder, or null if there is only the page. */
    val folder: Path? = path.takeIf { Files.isDirectory(it) || !it.name.endsWith(HTML, ignoreCase = true) }

    val page: Path = folder?.resolve("report$HTML") ?: path

    init {
        // The end of a version, as in report-1.2, is no extension
        if (folder != null && !Files.isDirectory(folder) && extension.any { it.isLetter() }) {
            throw Mistake("$option must be a page, NAME$HTML, or a folder, whose name has no extension: $path")
        }
        if (folder == null) OutputFile.check(page, option, listOf(HTML)) else OutputFile.requireFolderOrPlaceForIt(page)
    }

    companion object {
        private const val HTML = ".html"

        /** The help text of options whose value is such a place. */
        const val HELP: String = "a page, NAME.html; or a folder, in which the page is report.html"
    }
}
