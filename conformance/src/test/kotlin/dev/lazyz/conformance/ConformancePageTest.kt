package dev.lazyz.conformance

import dev.lazyz.conformance.fuzz.DifferentialFuzzing
import dev.lazyz.conformance.mutants.PlainRenderer
import dev.lazyz.scenes.formats.Scenes
import dev.lazyz.strategies.zbuffer.ZBufferRenderer
import java.nio.file.Files
import java.nio.file.Path
import java.time.Duration
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** Code of docs/conformance.md that no other test has. */
class ConformancePageTest {
    @Test
    fun programDrawsTheSceneOfAFailure(@TempDir folder: Path) {
        val path = folder.resolve("rule.json")
        path.writeText("""{"lazyz": 1, "size": [3, 2], "camera": {"screen": {}}, "surfaces": []}""")
        val loaded = Scenes.load(path)
        val frame = loaded.scene.frame(loaded.raster(loaded.size!!.width, loaded.size!!.height))
        assertEquals(6, frame.raster.size)
    }

    private class MyRenderer : PlainRenderer("mine")

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "full")
    fun programJudges(@TempDir folder: Path) {
        val report = Conformance { MyRenderer() }.tries(0.1).output(folder).run()
        check(report.isConformant) { report.toText() }
        assertTrue(Files.exists(folder.resolve("report.html")))
    }

    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun programComparesTwoRenderers(@TempDir folder: Path) {
        val fuzzing = DifferentialFuzzing({ ZBufferRenderer() }, { MyRenderer() })
        val report = fuzzing.time(Duration.ofSeconds(1)).corpus(folder).run()
        check(report.isEqual) { report.toText() }

        // A busy machine may need the whole second for the first frame
        assertTrue(report.frames > 0)
    }
}
