package dev.lazyz.conformance.report

import dev.lazyz.Image
import dev.lazyz.conformance.cases.FrameCase
import dev.lazyz.conformance.cases.code
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.judgement.differsAt
import dev.lazyz.conformance.report.ReportText.Companion.NO_SCENE_FILE
import dev.lazyz.conformance.results.RuleFailure
import dev.lazyz.conformance.results.SuiteRule
import dev.lazyz.scenes.writers.PngSink
import dev.lazyz.scenes.writers.sendTo
import java.io.ByteArrayOutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardCopyOption.REPLACE_EXISTING
import java.util.UUID

/** Writes a report to disk. */
internal class ReportFiles(private val report: ConformanceReport, private val folder: Path) {
    fun write() {
        val failures = folder.resolve("failures")
        Files.createDirectories(failures)

        // Delete the files of earlier runs, so that they are not mistaken for failures of this one
        for (rule in SuiteRule.all + report.results.map { it.rule }) {
            for (ending in ENDINGS) Files.deleteIfExists(failures.resolve(rule.name + ending))
        }
        for (result in report.results) result.failure?.let { write(it, failures, result.rule) }
        if (Files.list(failures).use { it.findAny().isEmpty }) Files.delete(failures)

        // Write the summaries last: they show that the report is complete
        write(folder.resolve("report.txt"), ReportText(report, isOnDisk = true).text())
        write(folder.resolve("report.json"), report.toJson())
        write(folder.resolve("TEST-lazyz-conformance.xml"), report.toJUnitXml())
        write(folder.resolve("report.html"), report.toHtml())
    }

    /** Writes the files of one [failure] of [rule] to [failures], and returns their names. */
    fun write(failure: RuleFailure, failures: Path, rule: SuiteRule): List<String> {
        val files = LinkedHashMap<String, ByteArray>()
        failure.case?.takeIf { it.corpusScene == null }?.let {
            files["$rule.kt"] = snippet(it, rule, failure).toByteArray()
        }
        failure.sceneFile?.let { files["$rule.json"] = it.toByteArray() }
        failure.before.forEachIndexed { i, it -> files["$rule-before-${i + 1}.kt"] = before(it, rule).toByteArray() }
        for ((name, png) in Pictures.of(failure)?.png().orEmpty()) files["$rule-$name.png"] = png
        for ((name, bytes) in files) write(failures.resolve(name), bytes)
        return files.keys.toList()
    }

    /** Returns a file that compiles with the library and the suite. */
    private fun snippet(case: FrameCase, rule: SuiteRule, failure: RuleFailure): String = buildString {
        appendLine("// ${report.strategy.id} breaks $rule on this frame:")
        for (line in failure.message.substringBefore("\nin\n").lines()) appendLine("// $line".trimEnd())
        appendLine("// ${report.commandFor(rule)}")
        appendLine("// ${if (failure.sceneFile == null) "scene file: $NO_SCENE_FILE" else drawing(case, rule)}")
        append(code(case))
    }

    private fun before(case: FrameCase, rule: SuiteRule): String =
        "// ${report.strategy.id} rendered this frame before it broke $rule\n${code(case)}"

    private fun code(case: FrameCase): String = buildString {
        appendLine()
        for (name in IMPORTS) appendLine("import $name")
        appendLine()
        appendLine("val frame: Frame =")
        appendLine(case.code.prependIndent("    "))
    }

    /** Returns the command that renders the frame. */
    private fun drawing(case: FrameCase, rule: SuiteRule): String {
        val part = case.frame.region
        val isWhole = part == case.frame.raster.region
        val region = if (isWhole) "" else " --region ${part.columnStart},${part.rowStart},${part.width}x${part.height}"
        return "zcli render $rule.json$region --strategy ${report.strategy.id} -o $rule.png"
    }

    private fun write(path: Path, text: String) = write(path, text.toByteArray())

    private fun write(path: Path, bytes: ByteArray) {
        val temporary = path.resolveSibling(".${path.fileName}.${UUID.randomUUID()}.tmp")
        try {
            Files.write(temporary, bytes)
            Files.move(temporary, path, REPLACE_EXISTING)
        } finally {
            Files.deleteIfExists(temporary)
        }
    }

    companion object {
        /** The imports of a frame's code, see [FrameCase.code]. */
        val IMPORTS = listOf(
            "dev.lazyz.*", "dev.lazyz.Raster.DepthConvention", "dev.lazyz.conformance.SuiteFrames",
            "dev.lazyz.conformance.cases.*", "dev.lazyz.conformance.frames.*", "dev.lazyz.geometry.*",
            "dev.lazyz.setup.*", "dev.lazyz.spi.*", "dev.lazyz.world.*", "dev.lazyz.world.camera.*",
            "dev.lazyz.world.light.*", "dev.lazyz.world.light.Light.Falloff",
            "dev.lazyz.world.material.*", "dev.lazyz.world.material.Material.*",
            "dev.lazyz.world.material.Texture.MipFilter",
            "dev.lazyz.world.material.TextureMap.UvTransform", "dev.lazyz.world.surface.*",
            "dev.lazyz.world.surface.Polygon.Vertex", "org.joml.Vector3d",
        )

        private val ENDINGS = listOf(".kt", ".json", "-expected.png", "-actual.png", "-difference.png") +
            (1..RuleFailure.MOST_BEFORE).map { "-before-$it.kt" }
    }
}

/** The pictures of a failure as PNG, magnified so that single samples can be seen. */
internal class Pictures private constructor(private val expected: Image, private val actual: Image) {
    /** PNG files by content: `expected`, `actual` and, unless they are equal, `difference`. */
    fun png(): Map<String, ByteArray> {
        val isDifferent = difference(expected, actual) != null
        return listOfNotNull(
            "expected" to png(expected),
            "actual" to png(actual),
            if (isDifferent) "difference" to png(marked()) else null,
        ).toMap()
    }

    /** White where the pictures are equal, red where colours differ, blue where only depth or primitive differs. */
    private fun marked(): Image {
        val argb = IntArray(expected.argb.size) { i ->
            when {
                !expected.differsAt(actual, i) -> SAME
                expected.argb[i] != actual.argb[i] -> OTHER_COLOR
                else -> OTHER_DEPTH
            }
        }
        return Image(expected.region, argb, expected.depth, expected.primitive, expected.counters)
    }

    private fun png(image: Image): ByteArray {
        val magnified = magnified(image)
        val bytes = ByteArrayOutputStream()
        PngSink(bytes, magnified.width, magnified.height).use { magnified.sendTo(it) }
        return bytes.toByteArray()
    }

    private fun magnified(image: Image): Image {
        val factor = (SIDE / maxOf(image.width, image.height)).coerceIn(1, GREATEST_FACTOR)
        val width = image.width * factor
        val height = image.height * factor
        fun enlarged(values: IntArray) = IntArray(width * height) { i ->
            values[i / width / factor * image.width + i % width / factor]
        }
        return Image(
            width, height, enlarged(image.argb), enlarged(image.depth), enlarged(image.primitive), image.counters,
        )
    }

    companion object {
        private const val SIDE = 240
        private const val GREATEST_FACTOR = 40
        private const val SAME = 0xFFFFFFFF.toInt()
        private const val OTHER_COLOR = 0xFFD02020.toInt()
        private const val OTHER_DEPTH = 0xFF2040D0.toInt()

        /** Returns the pictures of [failure], or null if it has none. */
        fun of(failure: RuleFailure): Pictures? {
            val expected = failure.expected ?: return null
            val actual = failure.actual ?: return null
            return Pictures(expected, actual)
        }
    }
}
