package dev.lazyz.cli.batch

import dev.lazyz.cli.argb
import dev.lazyz.cli.gifFrames
import dev.lazyz.cli.image
import dev.lazyz.cli.wedge
import dev.lazyz.cli.zcli
import java.awt.image.BufferedImage
import java.nio.file.Path
import kotlin.io.path.readBytes
import org.joml.Vector3d
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir
import org.junit.jupiter.params.ParameterizedTest
import org.junit.jupiter.params.provider.ValueSource

class TurntableTest {
    @TempDir
    lateinit var folder: Path

    private val size = arrayOf("--size", "120x90", "--aa", "1")

    /** Renders a turn of a wedge to numbered files, and returns the words of the cameras. */
    private fun turn(steps: Int, vararg args: String): List<List<String>> {
        val wedge = folder.wedge()
        val run = zcli(
            "render", wedge, "--turntable", steps, "-o", "$folder/{frame}.png", "--print-camera", *size, *args,
        )
        assertEquals(0, run.code, run.errors)
        return run.errors.trim().lines().map { it.substringAfter(": ").split(' ') }
    }

    private fun frame(number: Int): BufferedImage = folder.resolve("$number.png").image

    private fun vector(words: List<String>, flag: String): Vector3d {
        val (x, y, z) = words.single { it.startsWith("$flag=") }.substringAfter('=').split(',').map { it.toDouble() }
        return Vector3d(x, y, z)
    }

    /** The columns and rows of pixels that are not background, as fractions of the picture from its middle. */
    private fun reach(image: BufferedImage): Pair<Double, Double> {
        val covered = (0 until image.height).flatMap { y ->
            (0 until image.width).filter { image.getRGB(it, y) != -1 }.map { it to y }
        }
        val across = covered.maxOf { (x, _) -> maxOf(x + 1, image.width - x) } / (image.width / 2.0) - 1
        val along = covered.maxOf { (_, y) -> maxOf(y + 1, image.height - y) } / (image.height / 2.0) - 1
        return across to along
    }

    @ParameterizedTest
    @ValueSource(strings = ["perspective", "orthographic"])
    fun theCameraKeepsItsDistanceAndTheModelFitsInEveryStep(projection: String) {
        val cameras = turn(8, "--projection", projection, "--view", "iso")
        val eyes = cameras.map { vector(it, "--eye") }
        val target = vector(cameras[0], "--target")
        for ((i, camera) in cameras.withIndex()) {
            assertEquals(0.0, vector(camera, "--target").distance(target), 1e-12)
            assertEquals(eyes[0].distance(target), eyes[i].distance(target), 1e-9)
            assertEquals(
                cameras[0].filter { "fov" in it || "height" in it },
                camera.filter {
                    "fov" in it ||
                        "height" in it
                }
            )
            val angle = Math.toDegrees(StrictMath.atan2(eyes[i].x - target.x, eyes[i].z - target.z))
            assertEquals((45.0 + 45 * i) % 360, (angle + 360) % 360, 1e-9)
        }

        // The margin is 5 percent on each side, so the model reaches 90 percent in one step, and no more in any
        val reaches = (1..8).map { reach(frame(it)) }
        val most = reaches.maxOf { maxOf(it.first, it.second) }
        assertTrue(most in 0.87..0.93) { "$reaches" }
        assertEquals(8, (1..8).map { frame(it).argb() }.toSet().size)
    }

    @ParameterizedTest
    @ValueSource(strings = ["top", "bottom", "front"])
    fun viewsFromAboveAndBelowTurnToo(view: String) {
        turn(4, "--view", view)
        for (i in 1..4) assertTrue(reach(frame(i)).let { maxOf(it.first, it.second) } < 0.93)
        assertNotEquals(frame(1).argb(), frame(2).argb())
    }

    /** A step is a picture like others: the flags of its camera give the same bytes. */
    @Test
    fun stepsAreThoseOfSingleRuns() {
        val cameras = turn(3, "--zoom", "1.5")
        val alone = folder.resolve("alone.png")
        for ((i, camera) in cameras.withIndex()) {
            zcli("render", folder.resolve("wedge.obj"), *size, *camera.toTypedArray(), "-o", alone).done()
            assertArrayEquals(alone.readBytes(), folder.resolve("${i + 1}.png").readBytes())
        }
    }

    @Test
    fun animationsHaveTheSameFramesAsFiles() {
        turn(5)
        for (name in listOf("a.gif", "a.apng", "a.png")) {
            val run = arrayOf("render", folder.resolve("wedge.obj"), "--turntable", 5, "-o", folder.resolve(name))
            zcli(*run, *size).done()
        }
        assertArrayEquals(folder.resolve("a.png").readBytes(), folder.resolve("a.apng").readBytes())
        assertEquals(frame(1).argb(), folder.resolve("a.png").image.argb())
        val frames = folder.resolve("a.gif").gifFrames()
        assertEquals(5, frames.size)

        // Faces of one colour, so the palette is exact
        for (i in 0 until 5) assertEquals(frame(i + 1).argb(), frames[i].argb(), "$i")
    }

    @Test
    fun numbersHaveLeadingZeros() {
        turn(10)
        assertEquals(120, folder.resolve("01.png").image.width)
        assertEquals(120, folder.resolve("10.png").image.width)
    }
}
