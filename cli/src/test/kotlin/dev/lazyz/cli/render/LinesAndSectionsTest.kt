package dev.lazyz.cli.render

import dev.lazyz.cli.ProjectFiles
import dev.lazyz.cli.argb
import dev.lazyz.cli.zcli
import dev.lazyz.cli.zcliReading
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test

/** `--edges`, `--style`, `--cut` and what belongs to them. */
class LinesAndSectionsTest {
    private val flange = ProjectFiles.root.resolve("docs/images/flange.obj")

    private fun picture(vararg args: String): List<Int> =
        zcli("render", flange, "-o", "-", "--size", "60x50", "--aa", "1", *args).done().image.argb()

    private val black = 0xFF000000.toInt()
    private val white = 0xFFFFFFFF.toInt()

    @Test
    fun linesAreDrawnOverThePicture() {
        val shaded = picture()
        val edges = picture("--edges")
        assertTrue(black !in shaded && black in edges)
        for (i in shaded.indices) if (edges[i] != black) assertEquals(shaded[i], edges[i])
        val wire = picture("--wireframe", "--edge-color", "f00")
        assertTrue(wire.count { it == 0xFFFF0000.toInt() } > edges.count { it == black })
        assertTrue(picture("--edges", "--crease-angle", "180").count { it == black } < edges.count { it == black })
        assertTrue(picture("--edges", "--edge-width", "3").count { it == black } > edges.count { it == black })
        val dashed = picture("--edges", "--hidden-lines", "dashed")
        assertEquals(edges.count { it == black }, dashed.count { it == black })
        val grey = 0xFFA0A0A0.toInt()
        assertTrue(dashed.count { it == grey } > edges.count { it == grey })
        val green = picture("--edges", "--hidden-lines", "dashed", "--hidden-color", "0f0")
        assertEquals(dashed.count { it == grey } - edges.count { it == grey }, green.count { it == 0xFF00FF00.toInt() })
    }

    @Test
    fun theTechnicalStyleIsBlackAndWhite() {
        val plain = picture("--style", "technical")
        assertEquals(setOf(black, white), plain.toSet())
        assertEquals(plain, picture("--style", "technical", "--projection", "orthographic", "--edge-width", "0.75"))
        assertNotEquals(plain, picture("--style", "technical", "--projection", "perspective"))
        assertTrue(picture("--style", "technical", "--background", "0f0").contains(0xFF00FF00.toInt()))
        assertTrue(picture("--style", "technical", "--shading", "phong").toSet().size > 10)
    }

    /** Behind glass, lines are seen; behind the same surface made opaque, they are not. */
    @Test
    fun translucentSurfacesDoNotHideLinesUnlessTheyAreOpaque() {
        fun quad(z: Int, half: Int) = """{"positions": [-$half, -$half, $z, $half, -$half, $z, $half, $half, $z,
            -$half, $half, $z], "triangles": [0, 1, 2, 0, 2, 3]}"""
        val scene = """{"lazyz": 1, "materials": {"glass": {"baseColor": [1, 1, 1, 0.5], "alphaMode": "blend"}},
            "surfaces": [{"mesh": ${quad(0, 1)}}, {"mesh": ${quad(1, 2)}, "material": "glass"}]}"""
        fun lines(vararg args: String) = zcliReading(
            scene, "render", "-", "--format", "scene", "-o", "-", "--size", "60x60", "--aa", "1",
            "--view", "front", "--edges", *args,
        ).done().image.argb().count { it == black }
        assertTrue(lines() > lines("--opaque") + 50)
    }

    @Test
    fun planesCutTheModel() {
        val whole = picture("--view", "top")
        val half = picture("--view", "top", "--cut", "x=0")
        assertNotEquals(whole, half)
        assertEquals(half, picture("--view", "top", "--cut", "x=50%"))
        assertEquals(half, picture("--view", "top", "--cut", "2,0,0,0"))
        assertNotEquals(half, picture("--view", "top", "--cut", "-x=0"))
        assertTrue(0xFFCC3333.toInt() in picture("--cut", "z=0", "--cap-color", "c33", "--shading", "constant"))

        // The axes are those of the input
        assertEquals(
            picture("--up", "z", "--view", "top", "--cut", "z=0.2", "--style", "technical"),
            picture("--up", "z", "--view", "top", "--cut", "0,0,1,0.2", "--style", "technical"),
        )
    }

    @Test
    fun aPlaneThatRemovesNothingCausesAWarning() {
        fun errors(vararg cuts: String): String {
            val run =
                zcli(
                    "render", flange, "-o", "-", "--size", "40x30",
                    *cuts.flatMap {
                        listOf("--cut", it)
                    }.toTypedArray()
                )
            return run.errors.also { assertEquals(0, run.code, it) }
        }
        val whole =
            arrayOf("render", flange, "-o", "-", "--size", "60x50", "--aa", "1", "--cut", "x=100%", "--cut=-y=0%")
        assertEquals(picture(), zcli(*whole).image.argb())
        for (cut in listOf("x=150%", "-y=-1%", "Z=100%", "1,1,0,1000")) {
            assertEquals("zcli: warning: --cut $cut removes nothing: the input is on the other side\n", errors(cut))
        }
        val one = errors("x=50%", "x=150%")
        assertTrue(Regex("removes nothing").findAll(one).count() == 1 && "--cut x=150% removes" in one) { one }
    }

    @Test
    fun openModelsAreCutWithAWarning() {
        val teapot = zcli("render", "teapot", "-o", "-", "--size", "40x30", "--cut", "z=50%")
        assertEquals(0, teapot.code)
        assertTrue("not close" in teapot.errors) { teapot.errors }
    }

    @Test
    fun mistakesAreReported() {
        fun mistake(text: String, vararg args: String) = zcli("render", flange, "-o", "-", *args).mistake(text)
        mistake("--edge-width needs --edges", "--edge-width", "2")
        mistake("--hidden-lines needs --edges", "--hidden-lines", "solid")
        mistake("--crease-angle needs --edges or --style technical", "--crease-angle", "20")
        mistake("--crease-angle has no effect with --wireframe", "--wireframe", "--crease-angle", "20")
        mistake("--wireframe contains", "--edges", "--wireframe")
        mistake("--cap-color needs --cut", "--cap-color", "f00")
        mistake("--hidden-color needs --hidden-lines dashed or solid", "--edges", "--hidden-color", "f00")
        mistake("--hidden-color must be opaque", "--edges", "--hidden-lines", "solid", "--hidden-color", "ff000080")
        mistake("--edge-color must be opaque", "--edges", "--edge-color", "ff000080")
        mistake("not a plane", "--cut", "w=1")
        mistake("not a plane", "--cut", "0,0,0,1")
        mistake("not a plane", "--cut", "x=1e999%%")
        mistake("--crease-angle: must be in", "--edges", "--crease-angle", "200")
    }
}
