package dev.lazyz.cli

import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Assumptions.assumeTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** What `zcli man` and `zcli completion` print. */
class ShellTest {
    private val commands = listOf(
        "render", "view", "compare", "diff", "report", "trace", "conformance", "scenes", "strategies", "completion",
    )

    @Test
    fun theManualPageHasEachOptionOfTheHelp() {
        val page = zcli("man").done().text.replace("\\-", "-")
        for (command in commands) {
            assertTrue(".SH ${command.uppercase()}\n" in page, command)
            val flags = Regex("(?m)^ {2}(-[^ ,]*)").findAll(zcli(command, "--help").done().text)
            for (flag in flags) assertTrue("\n.B ${flag.groupValues[1]}" in page, flag.value)
        }
        val wrong = page.lines().filter { it.startsWith("'") || (it.startsWith(".") && !MACRO.containsMatchIn(it)) }
        assertEquals(emptyList<String>(), wrong)
    }

    @Test
    fun eachShellHasAScript() {
        for (shell in listOf("bash", "zsh", "fish")) {
            val script = zcli("completion", shell).done().text
            for (word in commands + "ground-shadow") assertTrue(word in script, "$shell: $word")
        }
        zcli("completion", "tcsh").mistake("invalid choice: tcsh. (choose from bash, zsh, fish)")
    }

    @Test
    fun bashCompletesCommandsOptionsValuesAndFiles(@TempDir folder: Path) {
        assumeTrue(Path.of("/bin/bash").toFile().exists())
        folder.resolve("zcli.bash").writeText(zcli("completion", "bash").done().text)
        folder.resolve("part.stl").writeText("")
        assertEquals("completion", completed(folder, "complet"))
        assertEquals("--ground-shadow", completed(folder, "render", "--grou"))
        assertEquals("orthographic", completed(folder, "render", "part.stl", "--projection", "ortho"))
        assertEquals("part.stl", completed(folder, "render", "par"))
        assertEquals("part.stl", completed(folder, "render", "--ref", "par"))
        assertEquals("part.stl", completed(folder, "render", "-o", "par"))
    }

    @Test
    fun bashCompletesNamesOfStrategiesColoursDataAndScenes(@TempDir folder: Path) {
        assumeTrue(Path.of("/bin/bash").toFile().exists())
        folder.resolve("zcli.bash").writeText(zcli("completion", "bash").done().text)
        folder.resolve("teacup.stl").writeText("")
        for (command in listOf("render", "compare", "report", "trace", "conformance")) {
            assertEquals("lazy", completed(folder, command, "--strategy", "la"), command)
        }
        assertEquals("auto", completed(folder, "render", "--strategy", "au"))
        assertEquals("zbuffer,lazy", completed(folder, "compare", "--strategy", "zbuffer,la"))
        assertEquals("iso,front", completed(folder, "render", "--views", "iso,fr"))
        assertEquals("skyblue", completed(folder, "render", "--background", "sky"))
        assertEquals("skyblue,wheat", completed(folder, "render", "--background", "skyblue,whe"))
        for (option in listOf("--color", "--edge-color", "--cap-color")) {
            assertEquals("rebeccapurple", completed(folder, "render", option, "rebec"))
        }
        assertEquals("depth=", completed(folder, "render", "--aov", "dep"))
        assertEquals("depth=", completed(folder, "render", "--aov-picture", "dep"))
        assertEquals("farthest", completed(folder, "render", "--select", "fa"))
        assertEquals("scene", completed(folder, "render", "--camera", "sc"))
        assertEquals("-x -y -z", completed(folder, "render", "--up", "-"))
        for (command in listOf("render", "compare", "report", "trace")) {
            assertEquals("teacup.stl teapot", completed(folder, command, "tea"), command)
        }
    }

    private fun completed(folder: Path, vararg words: String): String {
        val line = "COMP_WORDS=(zcli ${words.joinToString(" ")}); COMP_CWORD=${words.size}; _zcli"
        val process = ProcessBuilder("/bin/bash", "-c", "source ./zcli.bash; $line; echo \"\${COMPREPLY[@]}\"")
            .directory(folder.toFile()).redirectErrorStream(true).start()
        assertTrue(process.waitFor(10, TimeUnit.MINUTES))
        return process.inputReader().readText().trim()
    }

    private companion object {
        val MACRO = Regex("""^\.(TH|SH|SS|PP|TP|B|nf|fi)\b""")
    }
}
