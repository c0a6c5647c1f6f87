package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.zcli
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Sizes of points and lines, `--point-size` and `--line-width`. */
class PixelSizesTest {
    @TempDir
    lateinit var folder: Path

    private val scene = """
        {"lazyz": 1, "size": [20, 20], "camera": {"screen": {}}, "background": "white", "surfaces": [
          {"points": {"positions": [4.5, 4.5, 0.5], "size": 3}, "material": {"baseColor": "black"}},
          {"lines": {"positions": [4.5, 12.5, 0.5, 14.5, 12.5, 0.5], "segments": [0, 1]},
           "material": {"baseColor": "#f00"}}
        ]}
    """.trimIndent()

    /** Returns the number of black pixels, and of red ones. */
    private fun count(vararg options: String): Pair<Int, Int> {
        val file = Files.writeString(folder.resolve("dots.json"), scene)
        val pixels = zcli("render", file, "-o", "-", *options).image.argb()
        return Pair(pixels.count { it == 0xFF000000.toInt() }, pixels.count { it == 0xFFFF0000.toInt() })
    }

    @Test
    fun sizesReplaceTheScenes() {
        assertEquals(Pair(9, 11), count())
        assertEquals(Pair(25, 11), count("--point-size", "5"))
        assertEquals(Pair(9, 3 * 13), count("--line-width", "3"))
        assertEquals(Pair(1, 11), count("--point-size", "0.5", "--line-width", "0.5"))
    }
}
