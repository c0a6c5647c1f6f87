package dev.lazyz.testing

import java.nio.file.Path
import kotlin.io.path.invariantSeparatorsPathString

/** Messages that a GitHub workflow shows beside a file: "Workflow commands" in the documentation of GitHub Actions. */
internal object Annotation {
    /**
     * Returns the line that shows [message] as an error of [file].
     *
     * @param workspace the root of the repository; paths below it are relative
     */
    fun of(workspace: Path, file: Path, message: String): String {
        val path = if (file.startsWith(workspace)) workspace.relativize(file) else file
        return "::error file=${property(path.invariantSeparatorsPathString)},title=Golden picture::${data(message)}"
    }

    private fun data(text: String): String = text.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")

    private fun property(text: String): String = data(text).replace(":", "%3A").replace(",", "%2C")
}
