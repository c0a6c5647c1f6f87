package dev.lazyz.conformance.corpus

import dev.lazyz.DepthTest
import dev.lazyz.Raster
import dev.lazyz.conformance.assertSamePicture
import dev.lazyz.conformance.census.Census
import dev.lazyz.conformance.census.FrameTrait
import dev.lazyz.conformance.judgement.difference
import dev.lazyz.conformance.oracle.ReferenceRenderer
import dev.lazyz.world.Scene
import dev.lazyz.world.camera.Camera
import dev.lazyz.world.material.Material
import dev.lazyz.world.material.Material.Shading
import dev.lazyz.world.surface.Polygon
import dev.lazyz.world.surface.Polygon.Vertex
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.fileSize
import kotlin.io.path.name
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** The scenes for programs in other languages. */
class CorpusTest {
    private val hash = Path.of("../docs/corpus/SHA256")

    /** `-Dlazyz.update=true` writes the hash of the list of hashes. */
    @Test
    fun everyMachineMakesTheSameFiles(@TempDir folder: Path) {
        val scenes = CorpusFiles.write(folder)
        val sums = folder.resolve(CorpusFiles.SUMS)
        val files = Files.list(folder).use { it.toList() }
        assertEquals(19 * 20, scenes)
        assertEquals(5 * scenes + 1, files.size)
        assertTrue(files.sumOf { it.fileSize() } < 20_000_000)
        for (line in sums.readText().trim().lines()) {
            val (sum, name) = line.split("  ")
            assertEquals(sum, CorpusFiles.sha256(folder.resolve(name).readBytes()), name)
        }
        val all = "${CorpusFiles.sha256(sums.readBytes())}  ${sums.name}\n"
        if (System.getProperty("lazyz.update") == "true") hash.writeText(all)
        assertEquals(hash.readText(), all, "the corpus has changed, which needs a new version")
    }

    @Test
    fun everyGroupHasWhatItIsFor() {
        val cases = CorpusFiles.cases(tries = 0.5)
        for (case in cases) {
            val traits = Census.traits(case.scene.frame)
            assertTrue(FrameTrait.NOTHING_VISIBLE !in traits, case.name)
            assertTrue(case.scene.isOpen.count { it } < case.scene.isOpen.size, "${case.name} compares nothing")
            if ("ties" in case.name) assertTrue(FrameTrait.TIE in traits, case.name)
            val isBlended = "translucent" in case.name || "backdrops" in case.name
            assertEquals(isBlended, FrameTrait.TRANSLUCENT in traits, case.name)
        }
        val tags = cases.flatMap { it.scene.tags }.toSet()
        val page = Path.of("../docs/corpus.md").readText()
        for (tag in tags) assertTrue("`$tag`" in page, tag)
        assertEquals(12, tags.size, "$tags")
    }

    /** What a program draws that mistakes a depth test, or whose background wins or loses other ties. */
    @Test
    fun mistakesInDepthTestsAreSeen() {
        val rules = CorpusGroup.all.map { it.rule }.filter { "depthTests" in it.name }.toSet()
        val scenes = CorpusFiles.cases(rules).map { it.scene }
        fun seen(mistake: (Raster) -> Pair<DepthTest, Int>): Int = scenes.count { scene ->
            val (test, depth) = mistake(scene.raster)
            val raster = Raster(scene.raster.width, scene.raster.height, depthTest = test, backgroundDepth = depth)
            val mistaken = CorpusScene(raster, scene.background, scene.shapes).expected
            difference(scene.expected, scene.tolerated(mistaken)) != null
        }
        for ((right, wrong) in DepthTest.entries.flatMap { a -> DepthTest.entries.map { a to it } }) {
            val count = seen { (if (it.depthTest == right) wrong else it.depthTest) to it.backgroundDepth }
            assertTrue(count >= 3 || right == wrong, "$wrong instead of $right: $count")
        }
        for (step in listOf(-1, 1)) {
            val count = seen { it.depthTest to (it.backgroundDepth.toLong() + step).coerceIn(0, 0x7FFFFFFF).toInt() }
            assertTrue(count >= 3, "$step: $count")
        }
    }

    /** Mixed colours are those of the library where w is 1. */
    @Test
    fun mixedColoursAreThoseOfTheLibrary() {
        for (case in CorpusFiles.cases(CorpusGroup.all.map { it.rule }.filter { "colors" in it.name }.toSet())) {
            val surfaces = case.scene.scene.surfaces.map { (it as Polygon) }
            val polygons = surfaces.map { polygon ->
                val colors = (polygon.material.shader as MixedColors).colors
                val corners = polygon.contours.single().mapIndexed { i, v -> Vertex(v.x, v.y, v.z, 0f, 0f, colors[i]) }
                Polygon(listOf(corners), Material(shading = Shading.CONSTANT), polygon.fillRule)
            }
            val frame = Scene(polygons, viewpoint = Camera.screen()).frame(case.scene.raster)
            assertSamePicture(case.scene.expected, ReferenceRenderer().render(frame))
        }
    }
}
