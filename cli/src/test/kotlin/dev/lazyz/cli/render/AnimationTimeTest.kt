package dev.lazyz.cli.render

import dev.lazyz.cli.output.ExitCode
import dev.lazyz.cli.zcli
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import java.util.Base64
import kotlin.io.path.readBytes
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertFalse
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class AnimationTimeTest {
    @TempDir
    lateinit var folder: Path

    /** Two triangles, of which one moves away from the other within two seconds. */
    private fun model(): Path {
        val numbers = listOf(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 2, 0, 0, 0, 5, 0, 0)
        val bytes = ByteBuffer.allocate(4 * numbers.size).order(ByteOrder.LITTLE_ENDIAN)
        for (number in numbers) bytes.putFloat(number.toFloat())
        val text = Base64.getEncoder().encodeToString(bytes.array())
        val model = folder.resolve("moving.gltf")
        model.writeText(
            """{"asset":{"version":"2.0"},"nodes":[{"mesh":0},{"mesh":0}],
            "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
            "animations":[{"channels":[{"sampler":0,"target":{"node":1,"path":"translation"}}],
                "samplers":[{"input":1,"output":2}]}],
            "accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},
                {"bufferView":1,"componentType":5126,"count":2,"type":"SCALAR"},
                {"bufferView":1,"byteOffset":8,"componentType":5126,"count":2,"type":"VEC3"}],
            "bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":32}],
            "buffers":[{"byteLength":${bytes.capacity()},"uri":"data:;base64,$text"}]}""",
        )
        return model
    }

    private fun picture(vararg flags: Any): List<Byte> {
        val out = folder.resolve("out.png")
        val result = zcli("render", model(), *flags, "--size", "64x64", "-o", out)
        assertEquals(ExitCode.DONE, result.code, result.errors)
        return out.readBytes().toList()
    }

    @Test
    fun momentsDiffer() {
        val rest = picture()
        assertEquals(rest, picture("--animation-time", 0))
        val moved = picture("--animation-time", 1)
        assertFalse(rest == moved)
        assertFalse(moved == picture("--animation-time=2"))
        assertEquals(picture("--animation-time=2"), picture("--animation-time=1000"))
    }

    @Test
    fun compareTakesItToo() {
        val result = zcli("compare", model(), "--animation-time", 1.5, "--size", "64x64")
        assertEquals(ExitCode.DONE, result.code, result.errors)
        assertFalse("animations are not applied" in result.errors)
        assertTrue("--animation-time" in zcli("compare", model(), "--size", "64x64").errors)
    }

    @Test
    fun timesThatAreNoneAreMistakes() {
        zcli("render", model(), "--animation-time", -1).mistake("--animation-time", "0")
        zcli("render", model(), "--animation-time", "soon").mistake("--animation-time")
    }
}
