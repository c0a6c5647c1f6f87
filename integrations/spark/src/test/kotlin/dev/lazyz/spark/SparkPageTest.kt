package dev.lazyz.spark

import java.nio.file.Path
import kotlin.io.path.readText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** The first lines of `docs/spark.md` are those that [JavaTest] runs, but for its folders and its Spark. */
class SparkPageTest {
    @Test
    fun theFirstLinesAreTested() {
        val root = generateSequence(Path.of("").toAbsolutePath()) {
            it.parent
        }.first { it.resolve("docs/spark.md").toFile().exists() }
        val block = root.resolve("docs/spark.md").readText().substringAfter("```java\n").substringBefore("```")
        val test = root.resolve("integrations/spark/src/test/java/dev/lazyz/spark/JavaTest.java").readText()
        val lines = block.lines().filter { it.isNotBlank() && !it.startsWith("import dev.lazyz") }
        assertTrue(lines.size >= 7, "$lines")
        val missing = lines.map { line ->
            val own = if ("SparkSession spark" in line) "SparkSession spark = TestSpark.getSession();" else line
            own.replace(Regex("""\("(models|pictures)"\)""")) { "(folder.resolve(\"${it.groupValues[1]}\") + \"\")" }
        }.filter { it !in test }
        assertEquals(emptyList<String>(), missing)
    }
}
