package dev.lazyz.cli.render

import dev.lazyz.cli.ChildZcli
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** The memory that a refusal names is accepted, whichever step was refused. */
class NamedMemoryTest {
    @TempDir
    lateinit var folder: Path

    private val models: List<String> by lazy {
        folder.resolve("hills.stl").writeBytes(Hills(150).stl())
        folder.resolve("hills.ply").writeText(Hills(200).ply())
        folder.resolve("hills.obj").writeText(Hills(120).obj())
        listOf("hills.stl", "hills.ply", "hills.obj", "city", "teapot")
    }

    /** The amount of memory that a message says to use, in MiB. */
    private fun named(errors: String): Int =
        checkNotNull(Regex("se --memory (\\d+)m").find(errors)) { errors }.groupValues[1].toInt()

    private fun words(model: String, size: String, aa: Int, shading: String) = listOf(
        "render", model, "--size", size, "--aa", "$aa", "--shading", shading, "-o", "$folder/a.png",
    )

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun theNamedAmountIsAcceptedInALargeHeap() {
        for ((model, shading) in models.flatMap { listOf(it to "flat", it to "phong") }) {
            val words = words(if ('.' in model) "$folder/$model" else model, "300x200", 2, shading).toTypedArray()
            val refused = zcli(*words, "--memory", "1m")
            assertEquals(2, refused.code, refused.errors)
            val amount = named(refused.errors)
            zcli(*words, "--memory", "${amount}m").done()
            val less = zcli(*words, "--memory", "${amount / 4 * 3}m")
            assertEquals(2, less.code, "${words.asList()}: $amount MiB is much more than necessary")
        }
    }

    /** Runs a command in a Java whose heap has [mebibytes], as the launcher does. */
    private fun run(words: List<String>, mebibytes: Int): Pair<Int, String> {
        val child = ChildZcli(folder)
        val process = child.start(words + listOf("--memory", "${mebibytes}m"), listOf("-Xmx${mebibytes}m", SERIAL))
        return child.code(process) to child.errors
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun theNamedAmountIsAcceptedAsHeapToo() {
        val words = words("${folder.resolve(models[0])}", "200x5000", 1, "phong")
        for (small in listOf(12, 15)) {
            val (code, errors) = run(words, small)
            assertEquals(2, code, errors)
            val (next, later) = run(words, named(errors))
            assertEquals(0, next, "$errors\n$later")
        }
    }

    private companion object {
        /** The garbage collector that the launcher chooses. */
        const val SERIAL = "-XX:+UseSerialGC"
    }
}
