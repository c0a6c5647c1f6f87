package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.statIn
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.nio.file.Path
import java.security.MessageDigest
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class StatisticsTest {
    @TempDir
    lateinit var folder: Path

    private val out get() = folder.resolve("out.png")

    private val keys = listOf(
        "input", "strategy", "kernel", "width", "height", "aa", "primitives", "fragments", "overdraw",
        "depthEvaluations", "depthPasses", "shadingCalls", "shadingStarts", "shadingSteps", "longestChain",
        "peakSuspensions", "peakBytes",
        "visible", "coverage", "blank", "cropped", "warnings", "millis", "pixelHash",
    )

    @Test
    fun jsonHasTheseKeysAndOneLine() {
        val json = zcli("render", folder.wedge(), "-o", out, "--size", "40x30", "--stats=json").done().text
        assertEquals(keys, Json.parseToJsonElement(json).jsonObject.keys.toList())
        assertEquals(1, json.count { it == '\n' })
        assertTrue(json.startsWith("{") && json.endsWith("}\n"))
    }

    @Test
    fun kernelIsReportedWhereThereIsAChoice() {
        val size = arrayOf("--size", "40x30", "--stats=json")
        assertTrue(zcli("render", folder.wedge(), "-o", out, *size).done().stat("kernel") in setOf("vector", "scalar"))
        val other = zcli("render", folder.wedge(), "-o", out, *size, "--strategy", "zbuffer").done().text
        assertTrue("kernel" !in other, other)
    }

    @Test
    fun numbersDescribeThePicture() {
        val flags = arrayOf("--size", "40x30", "--aa", "1", "--stats=json", "--view", "front", "--strategy", "zbuffer")
        val run = zcli("render", folder.wedge(), "-o", out, *flags).done()
        val covered = out.image.argb().count { it != -1 }
        assertEquals("zbuffer", run.stat("strategy"))
        assertEquals("40" to "30", run.stat("width") to run.stat("height"))
        assertEquals("4", run.stat("primitives"))
        assertEquals("$covered", run.stat("visible"))
        assertEquals(covered / 1200.0, run.stat("coverage").toDouble())
        assertEquals(run.stat("fragments").toLong() / 1200.0, run.stat("overdraw").toDouble())
        assertEquals("${12 * 1200}", run.stat("peakBytes"))
        assertEquals("false", run.stat("blank"))
        assertEquals("false", run.stat("cropped"))
        assertEquals("0", run.stat("warnings"))
        assertTrue(run.stat("millis").toDouble() >= 0)
        assertTrue(run.stat("shadingCalls").toLong() in covered..run.stat("fragments").toLong())
    }

    @Test
    fun pixelHashIsOfTheDecodedPixels() {
        val hash = zcli("render", folder.wedge(), "-o", out, "--size", "40x30", "--stats=json").done().stat("pixelHash")
        val bytes = out.image.argb().flatMap { listOf(it ushr 24, it ushr 16, it ushr 8, it) }.map { it.toByte() }
        val sha = MessageDigest.getInstance("SHA-256").digest(bytes.toByteArray())
        assertEquals(sha.joinToString("") { "%02x".format(it) }, hash)
    }

    @Test
    fun goToStandardErrorWhenThePictureGoesToStandardOutput() {
        val run = zcli("render", folder.wedge(), "-o", "-", "--size", "40x30", "--stats=json")
        assertEquals(40, run.image.width)
        assertEquals("1200", statIn(run.errors, "width").let { "${it.toInt() * 30}" })
        assertTrue(run.errors.startsWith("{") && run.errors.endsWith("}\n"), run.errors)
    }

    @Test
    fun tableHasTheSameRows() {
        // One thread: with more, peakBytes depends on which of them took which tiles
        val flags = arrayOf("--size", "40x30", "--threads", "1")
        fun reported(option: String) = zcli("render", folder.wedge(), "-o", out, *flags, option).done().text
        val table = reported("--stats")
        val rows = table.lines().filter { it.startsWith("|") }.map { it.split("|")[1].trim() }
        assertEquals(keys, rows)
        assertEquals(table.withoutMillis(), reported("--stats=table").withoutMillis())
    }

    private fun String.withoutMillis(): String = replace(Regex("""\| millis .*"""), "")

    @Test
    fun namesAreEscaped() {
        val odd = folder.wedge("a\"b\\é😀\u007f\u0007\n.obj")
        val json = zcli("render", odd, "-o", out, "--size", "40x30", "--stats=json").text
        assertEquals("$odd", Json.parseToJsonElement(json).jsonObject.getValue("input").jsonPrimitive.content)
        assertTrue(json.trimEnd().all { it in ' '..'~' }, json)
    }
}
