package dev.lazyz.cli.render

import dev.lazyz.cli.WEDGE
import dev.lazyz.cli.image
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Path
import javax.imageio.ImageIO
import kotlin.io.path.createDirectory
import kotlin.io.path.createSymbolicLinkPointingTo
import kotlin.io.path.isSymbolicLink
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.condition.EnabledIfSystemProperty
import org.junit.jupiter.api.io.TempDir

/** What outputs replace, and what they never do. */
class OverwritingTest {
    @TempDir
    lateinit var folder: Path

    private val out by lazy { folder.resolve("x.png") }

    @Test
    fun noOutputReplacesTheModel() {
        val model = folder.wedge("model.png")
        val input = arrayOf<Any>("render", model, "--format", "obj")
        val message = "would replace an input: $model"
        zcli(*input, "-o", model).mistake("-o $message")
        zcli(*input, "-o", folder.resolve("./model.png")).mistake(message)
        zcli(*input, "-o", folder.resolve("l.png").createSymbolicLinkPointingTo(model)).mistake(message)
        zcli(*input, "-o", out, "--aov", "depth=$model").mistake("--aov depth=$model $message")
        zcli(*input, "-o", out, "--aov-picture", "depth=$model").mistake(message)
        zcli("trace", model, "--format", "obj", "-o", model).mistake("-o $message")
        val pfm = folder.wedge("model.pfm")
        val words = arrayOf<Any>("render", pfm, "--format", "obj", "-o", out)
        zcli(*words, "--depth-out", pfm).mistake("--depth-out would replace an input: $pfm")
        assertEquals(listOf(WEDGE, WEDGE), listOf(model, pfm).map { it.readText() })
    }

    @Test
    fun noOutputReplacesAFileOfAnOption() {
        val picture = folder.resolve("picture.png").apply { writeText("picture") }
        for (option in listOf("--texture", "--matcap")) {
            val message = "would replace the input of $option: $picture"
            zcli("render", "teapot", option, picture, "-o", picture).mistake("-o $message")
            zcli("trace", "teapot", option, picture, "-o", picture).mistake("-o $message")
        }
        val words = arrayOf<Any>("render", "teapot", "--texture", picture, "--ref", out, "--diff", picture)
        zcli(*words).mistake("--diff would replace the input of --texture: $picture")
        assertEquals("picture", picture.readText())
    }

    @Test
    fun noOutputReplacesWhatTheModelRefersTo() {
        val texture = folder.resolve("maps").createDirectory().resolve("wood.png")
        ImageIO.write(BufferedImage(3, 3, BufferedImage.TYPE_INT_RGB), "png", texture.toFile())
        folder.resolve("m.mtl").writeText("newmtl m\nmap_Kd maps/wood.png\n")
        val model = folder.resolve("m.obj")
        model.writeText("mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
        val scene = folder.resolve("s.json")
        scene.writeText("{\"lazyz\": 1, \"surfaces\": [{\"mesh\": \"m.obj\"}]}")
        for (input in listOf(model, scene)) {
            for (command in listOf("render", "trace")) {
                val run = zcli(command, input, "--size", "9", "-o", texture)
                run.mistake("-o would replace a file that $input refers to: $texture")
            }
        }
        assertEquals(3, texture.image.width)
    }

    /** The folder of the tiles is replaced as a whole. */
    @Test
    @EnabledIfSystemProperty(named = "lazyz.effort", matches = "rest|full")
    fun noPyramidReplacesWhatIsReadFromItsTiles() {
        val dzi = folder.resolve("x.dzi")
        zcli("render", "teapot", "--size", "9", "-o", dzi).done()
        val tile = folder.resolve("x_files/4/0_0.png")
        val before = tile.readBytes()
        val link = folder.resolve("link.png").createSymbolicLinkPointingTo(tile)
        for (option in listOf("--texture", "--matcap")) {
            val message = "-o would replace the input of $option: $tile"
            zcli("render", "teapot", option, tile, "-o", dzi).mistake(message)
        }
        zcli("render", "teapot", "--matcap", link, "-o", dzi).mistake("-o would replace the input of --matcap: $link")
        zcli("render", "teapot", "--ref", tile, "-o", dzi).mistake("-o would replace the file of --ref: $tile")
        zcli("render", tile, "--format", "obj", "-o", dzi).mistake("-o would replace an input: $tile")
        folder.resolve("m.mtl").writeText("newmtl m\nmap_Kd x_files/4/0_0.png\n")
        val model = folder.resolve("x.obj")
        model.writeText("mtllib m.mtl\nusemtl m\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/1\n")
        val message = "-o would replace a file that $model refers to: $tile"
        zcli("render", model, "-o", dzi).mistake(message)
        zcli("render", model, "city", "-o", folder.resolve("{stem}.dzi")).mistake(message)
        assertArrayEquals(before, tile.readBytes())
    }

    /** The link stays, and the file that it names is written, whether it existed or not. */
    @Test
    fun linksAreFollowed() {
        val old = folder.resolve("old.png").apply { writeText("old") }
        val none = folder.resolve("sub").createDirectory().resolve("none.png")
        for ((name, target) in listOf("a.png" to old, "b.png" to none)) {
            val link = folder.resolve(name).createSymbolicLinkPointingTo(folder.relativize(target))
            zcli("render", "teapot", "--size", "9x8", "-o", link).done()
            assertTrue(link.isSymbolicLink(), name)
            assertEquals(9, target.image.width)
        }
    }
}
