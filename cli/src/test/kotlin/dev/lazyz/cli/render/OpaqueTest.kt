package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** What `--opaque` does to all that makes a surface translucent. */
class OpaqueTest {
    @TempDir
    lateinit var folder: Path

    private fun argb(scene: Path, vararg words: String): List<Int> {
        val out = folder.resolve("out.png")
        zcli("render", scene, "--size", "40x30", "--aa", "1", "--opaque", "-o", out, *words).done()
        return out.image.argb()
    }

    private fun scene(surfaces: String): Path = folder.resolve("scene.json").apply {
        val camera = """{"eye": [0, 0, 9], "target": [0, 0, 0], "height": 2, "near": 1, "far": 20}"""
        writeText(
            """{"lazyz": 1, "background": "transparent", "camera": {"orthographic": $camera}, "surfaces": [$surfaces]}""",
        )
    }

    private fun square(z: Int, members: String, material: String) = """{"mesh": {
        "positions": [-1, -1, $z, 1, -1, $z, 1, 1, $z, -1, 1, $z], "triangles": [0, 1, 2, 0, 2, 3], $members},
        "material": {"alphaMode": "blend", $material}}"""

    @Test
    fun blendingNeedsTranslucentMaterials() {
        val blend = arrayOf("--opaque", "--select", "blend", "-o", "x.png")
        zcli("render", "teapot", *blend).mistake("--select blend has no effect with --opaque")
    }

    /** What the user chooses on the command line is opaque, too. */
    @Test
    fun coloursAndLitSpheresAreOpaque() {
        val file = scene(square(0, """"uvs": [0, 1, 1, 1, 1, 0, 0, 0]""", """"baseColor": [1, 0.5, 0.25, 0.5]"""))
        val ball = folder.resolve("ball.png")
        ImageIO.write(BufferedImage(8, 8, BufferedImage.TYPE_INT_RGB), "png", ball.toFile())
        for (words in listOf(arrayOf("--color", "ff000080"), arrayOf("--color", "ff000080", "--matcap", "$ball"))) {
            val pixels = argb(file, *words)
            assertEquals(setOf(0, 0xFF), pixels.map { it ushr 24 }.toSet())
        }
    }
}
