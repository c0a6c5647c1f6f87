package dev.lazyz.cli.render

import dev.lazyz.cli.argb
import dev.lazyz.cli.image
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.exists
import kotlin.io.path.listDirectoryEntries
import kotlin.io.path.name
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/**
 * `-o NAME.dzi`, and `--resume` where it is an error or has nothing to resume. [dev.lazyz.cli.ResumeTest] interrupts.
 */
class DeepZoomOptionsTest {
    @TempDir
    lateinit var folder: Path

    private val dzi by lazy { folder.resolve("a.dzi") }

    @Test
    fun theLargestLevelIsThePicture() {
        for (options in listOf(emptyList(), listOf("--region", "40,50,200x100"), listOf("--background", "red,blue"))) {
            val words = (listOf("render", "teapot", "--size", "250") + options).toTypedArray()
            zcli(*words, "-o", dzi).done()
            val expected = zcli(*words, "-o", "-").done().image
            val tile = folder.resolve("a_files/8/0_0.png").image
            assertEquals(expected.argb(), tile.argb())
        }
    }

    @Test
    fun aFolderThatIsNoPyramidIsAMistake() {
        val own = folder.resolve("a_files").createDirectories().resolve("notes.txt").apply { writeText("mine") }
        zcli("render", "teapot", "--size", "40", "-o", dzi).mistake("other files than tiles", "another name")
        zcli("render", "teapot", "-o", folder.resolve("b/a.dzi")).mistake("there is no folder")
        assertEquals("mine", own.readText())
        assertFalse(dzi.exists())
    }

    @Test
    fun resumeIsForASinglePyramid() {
        val resumed = arrayOf<Any>("render", "teapot", "--resume")
        zcli(*resumed).mistake("--resume needs -o NAME.dzi")
        zcli(*resumed, "-o", folder.resolve("a.png")).mistake("--resume needs -o NAME.dzi")
        zcli(*resumed, "-o", "-").mistake("--resume needs -o NAME.dzi")
        zcli(*resumed, "-o", dzi, "--depth-out", folder.resolve("d.pfm")).mistake("combined with --depth-out")
        zcli(*resumed, "-o", dzi, "--aov", "depth=${folder.resolve("d.npy")}").mistake("combined with --aov")
        zcli(*resumed, "-o", dzi, "--ref", folder.resolve("r.png")).mistake("combined with --ref")
        zcli(*resumed, "city", "-o", folder.resolve("{stem}.dzi")).mistake("--resume is for a single picture")
        zcli(*resumed, "--turntable", "9", "-o", folder.resolve("a.gif")).mistake("--resume is for a single picture")
        zcli("render", "-", "--format", "obj", "--resume", "-o", dzi).mistake("not standard input")
        assertEquals(emptyList<Path>(), folder.listDirectoryEntries())
    }

    @Test
    fun aChangedModelOrOptionIsRefused() {
        val model = folder.wedge()
        val facts = folder.resolve("a_files.partial").createDirectories().resolve("resume.txt")
        val words = arrayOf<Any>("render", model, "--size", "600", "-o", dzi, "--resume")
        facts.writeText("size: 600x600\nalpha: drop\nzcli: 0\n")
        zcli(*words).mistake("another picture", "zcli: 0", "delete that folder")
        facts.writeText("size: 700x600\n")
        zcli(*words).mistake("another picture", "size: 700x600", "size: 600x600")
        facts.writeText("")
        zcli(*words).done()
        assertTrue(dzi.exists())
    }
}
