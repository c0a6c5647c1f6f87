package dev.lazyz.cli.render

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

class LimitsTest {
    @TempDir
    lateinit var folder: Path

    private val out by lazy { folder.resolve("out.png") }

    @Test
    fun whatIsBeyondALimitIsAMistakeThatNamesItsFlag() {
        val wedge = folder.wedge()
        val limits = listOf("--max-triangles" to 3, "--max-vertices" to 3, "--max-decoded" to 100, "--max-seconds" to 0)
        for ((flag, value) in limits) {
            zcli("render", wedge, flag, value, "-o", out).mistake("wedge.obj", flag)
            zcli("compare", wedge, flag, value).mistake("wedge.obj", flag)
            assertFalse(out.exists())
        }
        val enough = listOf("--max-triangles=4", "--max-vertices=4", "--max-decoded=1k", "--max-texels=0")
        zcli("render", wedge, *enough.toTypedArray(), "-o", out)
            .let { check(it.code == ExitCode.DONE) { it.errors } }
    }

    @Test
    fun timesAreWholeMilliseconds() {
        val file = folder.resolve("a.obj")
        file.writeText("v 0 0 0\nv 1 0 0\nv 0 1 0\n" + "f 1 2 3\n".repeat(100_000))
        zcli("render", file, "--max-seconds", 0.0001, "-o", out).mistake("takes more than 0.001 s to read")
        zcli("render", file, "--max-seconds", 0, "-o", out).mistake("takes more than 0 s to read")
    }

    /** Many layers that cover the picture take minutes, although the file is small. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun theTimeIsThatOfReadingAndRendering() {
        val scene = folder.resolve("layers.json")
        scene.writeText(
            """{"lazyz": 1, "surfaces": [{"mesh": {"positions": [-9, -9, 0, 9, -9, 0, 0, 9, 0], "triangles": [""" +
                List(2_000) { "0, 1, 2" }.joinToString() +
                """]}, "material": {"baseColor": [1, 0.5, 0.2, 0.01], "alphaMode": "blend"}}]}""",
        )
        val message = "layers.json: takes more than 1 s to read and render; raise --max-seconds"
        val limit = arrayOf<Any>("--max-seconds", 1)
        zcli("render", scene, *limit, "-o", out).mistake(message)
        zcli("render", scene, *limit, "--strategy", "lists", "-o", out).mistake(message)
        zcli("compare", scene, *limit).mistake(message)

        // With several inputs, one that takes too long does not stop the others
        val batch = zcli("render", scene, folder.wedge(), *limit, "--size", 256, "-o", "$folder/{stem}.png")
        batch.mistake(message, "1 of 2 inputs failed")
        assertTrue(folder.resolve("wedge.png").exists())
        val files = folder.listDirectoryEntries().map { it.name }.filterNot { "out.png" in it }
        assertEquals(setOf("layers.json", "wedge.obj", "wedge.png"), files.toSet())
        assertFalse(out.exists())
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun limitsApplyToModelsThatAreReadPartByPart() {
        val model = folder.resolve("hills.stl").apply { writeBytes(Hills(2).stl()) }
        for ((flag, enough) in listOf("--max-triangles" to 8, "--max-vertices" to 24)) {
            zcli("render", model, "--stream", flag, enough - 1, "-o", out).mistake("hills.stl", flag)
            check(zcli("render", model, "--stream", flag, enough, "-o", out).code == ExitCode.DONE)
        }
        val decoded = zcli("render", model, "--stream", "--max-decoded", "1g", "-o", out)
        decoded.mistake("--max-decoded has no effect with --stream", "--max-triangles, --max-vertices or --max-spool")
    }

    @Test
    fun nestingHasALimit() {
        val scene = folder.resolve("a.json").apply { writeText("""{"lazyz": 1, "surfaces": [[]]}""") }
        zcli("render", scene, "--max-nesting", 2, "-o", out).mistake("nested more than 2 deep", "--max-nesting")
    }

    @Test
    fun numbersThatAreNoLimitsAreMistakes() {
        val wedge = folder.wedge()
        zcli("render", wedge, "--max-triangles", -1).mistake("--max-triangles", "0 or more")
        zcli("render", wedge, "--max-decoded", "much").mistake("--max-decoded", "not an amount of memory")
        zcli("render", wedge, "--max-nesting", 1001).mistake("--max-nesting", "1..1000")
    }

    @Test
    fun filesOutsideAreReadOnlyIfThatIsAllowed() {
        folder.wedge()
        val scene = folder.resolve("inner").createDirectory().resolve("a.json")
        scene.writeText("""{"lazyz": 1, "surfaces": [{"mesh": "../wedge.obj"}]}""")
        zcli("render", scene, "-o", out).mistake("../wedge.obj lies outside", "--allow-outside")
        check(zcli("render", scene, "--allow-outside", "-o", out).code == ExitCode.DONE)
    }
}
