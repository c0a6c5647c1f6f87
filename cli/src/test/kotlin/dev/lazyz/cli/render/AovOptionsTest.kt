package dev.lazyz.cli.render

import dev.lazyz.aov.Aov
import dev.lazyz.cli.image
import dev.lazyz.cli.zcli
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.ZipFile
import kotlin.io.path.exists
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** `zcli render` with `--aov` and `--aov-picture`. */
class AovOptionsTest {
    @TempDir
    lateinit var folder: Path

    private fun file(name: String): Path = folder.resolve(name)

    private fun render(input: Any, vararg options: Any) =
        zcli("render", input, "-o", file("picture.png"), "--size", "40x30", *options)

    /** The 32-bit floating-point numbers of an array of NumPy. */
    private fun floats(name: String): List<Float> {
        val bytes = ByteBuffer.wrap(file(name).readBytes()).order(ByteOrder.LITTLE_ENDIAN)
        val start = 10 + bytes.getShort(8)
        return List((bytes.capacity() - start) / 4) { bytes.getFloat(start + 4 * it) }
    }

    private fun names(archive: String): List<String> =
        ZipFile(file(archive).toFile()).use { zip -> zip.entries().toList().map { it.name } }

    @Test
    fun filesAreWrittenInTheFormatsOfTheirNames() {
        render(
            "molecule", "--aov", "depth=${file("d.pfm")}", "--aov", "Depth=${file("d.png")}",
            "--aov=normal=${file("n.npy")}", "--aov", "all=${file("all.npz")}", "--aov", "uv,object=${file("two.npz")}",
            "--aov-picture", "overdraw=${file("o.png")}",
        ).done()
        assertTrue(String(file("d.pfm").readBytes().copyOf(8)) == "Pf\n40 30")
        assertEquals(40 to 30, file("d.png").image.let { it.width to it.height })
        assertEquals(16, file("d.png").image.sampleModel.getSampleSize(0))
        assertEquals(40 * 30 * 3, floats("n.npy").size)
        val arrays = Aov.entries.map { "${it.id}.npy" }.toMutableList()
        arrays.add(Aov.OBJECT.ordinal + 1, "object-names.npy")
        assertEquals(arrays, names("all.npz"))
        assertEquals(listOf("uv.npy", "object.npy", "object-names.npy"), names("two.npz"))
        assertEquals(200, file("o.png").image.width)
        assertTrue(file("picture.png").exists())
    }

    @Test
    fun visiblePartsAreListed() {
        file("car.obj").writeText("v 0 0 0\nv 1 0 0\nv 0 1 0\no car\ng wheel\nf 1 2 3\n")
        render(file("car.obj"), "--color", "red", "--aov", "object=${file("parts.json")}").done()
        val text = file("parts.json").readText()
        assertTrue(Regex(""""name": "car/wheel",\s+"pixels": \d{2,}""").containsMatchIn(text)) { text }
        render("molecule", "--aov", "depth=${file("d.json")}").mistake("lists objects", ".npz")
    }

    @Test
    fun mistakesAreReportedBeforeAnythingIsRead() {
        fun mistake(vararg parts: String, options: List<Any>) {
            zcli("render", "nowhere.obj", "-o", file("picture.png"), *options.toTypedArray()).mistake(*parts)
        }
        mistake("'depht' is not one of all, depth", "depth", options = listOf("--aov", "depht=d.pfm"))
        mistake("'depth' is not AOV=FILE", options = listOf("--aov", "depth"))
        mistake("'=d.pfm' is not AOV=FILE", options = listOf("--aov", "=d.pfm"))
        mistake("--aov must end in .pfm or .npy or .npz or .png", options = listOf("--aov", "depth=d.exr"))
        mistake("--aov-picture must end in .png", options = listOf("--aov-picture", "depth=d.npy"))
        mistake("use .npz for several", options = listOf("--aov", "uv,depth=${file("d.npy")}"))
        mistake("a picture shows one AOV", options = listOf("--aov-picture", "all=${file("d.png")}"))
        mistake("positions have no range", "use .npy", options = listOf("--aov", "position=${file("p.png")}"))
        val data = "depth=${file("d.npy")}"
        mistake("--aov $data is given twice\n", options = listOf("--aov", data, "--aov", data))
        mistake("'depth' is named twice", options = listOf("--aov", "depth,uv,DEPTH=${file("d.npz")}"))
        mistake("there is no folder", options = listOf("--aov", "depth=${file("no/d.pfm")}"))
        val picture = file("picture.png")
        mistake("must be different files", options = listOf("--aov", "depth=$picture"))
        val same = file("same.png")
        mistake("must be different files", options = listOf("--aov", "uv=$same", "--aov-picture", "uv=$same"))
        val pfm = file("same.pfm")
        mistake("must be different files", options = listOf("--aov", "depth=$pfm", "--depth-out", pfm))
    }

    @Test
    fun numbersThatDoNotFitLeaveNoFile() {
        val grid = file("grid.obj")
        val triangle = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        grid.writeText(triangle + "f 1 1 1\n".repeat(70_000) + "f 1 2 3\n")
        render(grid, "--aov", "primitive=${file("p.png")}").mistake("'primitive' reaches 70000", "use .npy")
        assertFalse(file("p.png").exists())
        assertFalse(file("picture.png").exists())
        assertEquals(listOf(grid), Files.list(folder).use { it.toList() })
    }
}
