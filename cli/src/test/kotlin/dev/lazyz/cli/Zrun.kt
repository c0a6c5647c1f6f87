package dev.lazyz.cli

import dev.lazyz.cli.output.ExitCode
import java.awt.image.BufferedImage
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals

/** The exit code and output of one run of zcli in this process. */
internal class Zrun(val code: Int, val output: ByteArray, val errors: String) {
    val text: String get() = String(output)

    /** Asserts success without messages, and returns this. */
    fun done(): Zrun = apply { assertEquals("", errors) }.also { assertEquals(ExitCode.DONE, code) }

    /** Asserts that a mistake was reported, in a message that contains all of [parts], and without a stack trace. */
    fun mistake(vararg parts: String): Zrun = apply {
        for (part in parts) check(part in errors) { "'$part' is missing in: $errors" }
        assertEquals(ExitCode.MISTAKE, code, errors)
        check(errors.startsWith("zcli: error: ")) { errors }
        check("\tat " !in errors && "Exception" !in errors) { "a stack trace: $errors" }
        assertEquals("", text)
    }

    val image: BufferedImage get() = ImageIO.read(ByteArrayInputStream(output))

    /** The value of [key] in the JSON on standard output. */
    fun stat(key: String): String = statIn(text, key)
}

internal fun statIn(json: String, key: String): String =
    checkNotNull(Regex("\"$key\": ?(\"[^\"]*\"|[^,}]+)").find(json)) { "no $key in $json" }.groupValues[1].trim('"')

internal fun zcli(vararg args: Any): Zrun = zcliReading("", *args)

/** Runs zcli with [input] on standard input. */
internal fun zcliReading(input: String, vararg args: Any): Zrun {
    val output = ByteArrayOutputStream()
    val (code, errors) = zcliWriting(output, input, *args)
    return Zrun(code, output.toByteArray(), errors)
}

/** Runs zcli with standard output to [output]; returns the exit code and standard error. */
internal fun zcliWriting(output: OutputStream, input: String, vararg args: Any): Pair<Int, String> {
    val errors = ByteArrayOutputStream()
    val words = args.map { it.toString() }.toTypedArray()
    val code = run(words, input.byteInputStream(), output, PrintStream(errors, true))
    return code to errors.toString()
}

internal val Path.image: BufferedImage get() = ImageIO.read(ByteArrayInputStream(readBytes()))

/** Returns all pixels in rows from the top, `0xAARRGGBB`. */
internal fun BufferedImage.argb(): List<Int> = getRGB(0, 0, width, height, null, 0, width).toList()

/** A tetrahedron that looks different from every side. */
internal const val WEDGE = """v 0 0 0
v 4 0 0
v 0 2 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""

internal fun Path.wedge(name: String = "wedge.obj"): Path = resolve(name).apply { writeText(WEDGE) }

/** Writes a model in which there is nothing to see. */
internal fun Path.emptyModel(): Path = resolve("empty.stl").apply { writeText("solid empty\nendsolid empty\n") }
