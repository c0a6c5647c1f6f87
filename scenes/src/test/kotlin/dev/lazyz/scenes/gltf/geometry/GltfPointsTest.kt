package dev.lazyz.scenes.gltf.geometry

import dev.lazyz.Rgba
import dev.lazyz.scenes.gltf.GltfFiles
import dev.lazyz.scenes.gltf.GltfParser
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.world.surface.Lines
import dev.lazyz.world.surface.Points
import dev.lazyz.world.surface.Surface
import org.junit.jupiter.api.Assertions.assertArrayEquals
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNotEquals
import org.junit.jupiter.api.Test

/** Primitives of modes 0 to 3. */
class GltfPointsTest {
    private val corners = listOf(0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)

    private fun source(mode: Int, indices: List<Int>? = null, more: String = "", node: String = ""): String {
        val files = GltfFiles()
        files.accessor("VEC3", GltfFiles.FLOAT, corners)
        if (indices != null) files.accessor("SCALAR", GltfFiles.USHORT, indices)
        val numbers = if (indices == null) "" else ""","indices":1"""
        val primitive = """{"attributes":{"POSITION":0},"mode":$mode$numbers$more}"""
        return files.json(
            """"nodes":[{"mesh":0$node}],"meshes":[{"primitives":[$primitive]}],"materials":[{"name":"a"}]""",
        )
    }

    private fun surface(json: String): Surface = GltfParser.parse(TestSources.of(json)).surfaces.single()

    @Test
    fun pointsAreVerticesOrThoseThatAreNumbered() {
        val all = surface(source(0)) as Points
        assertEquals(corners.map { it.toFloat() }, all.positions.toList())
        assertNotEquals(Rgba.WHITE, all.material.baseColor)
        val some = surface(source(0, listOf(2, 2, 0))) as Points
        assertArrayEquals(floatArrayOf(1f, 1f, 0f, 1f, 1f, 0f, 0f, 0f, 0f), some.positions)
    }

    @Test
    fun linesAreStrungInThreeWays() {
        fun segments(mode: Int, indices: List<Int>?) = (surface(source(mode, indices)) as Lines).segments.toList()
        assertEquals(listOf(0, 1, 2, 3), segments(1, null))
        assertEquals(listOf(3, 1), segments(1, listOf(3, 1, 2)))
        assertEquals(listOf(0, 1, 1, 2, 2, 3, 3, 0), segments(2, null))
        assertEquals(listOf(2, 0, 0, 1), segments(3, listOf(2, 0, 1)))
        assertEquals(emptyList<Int>(), segments(2, listOf(1)))
    }

    @Test
    fun theFilesMaterialIsTaken() {
        assertEquals("a", (surface(source(3, more = ""","material":0""")) as Lines).material.name)
        assertEquals("a", (surface(source(0, more = ""","material":0""")) as Points).material.name)
    }

    @Test
    fun nodesMoveThem() {
        val moved = ""","translation":[0,0,5]"""
        assertEquals(5f, (surface(source(0, node = moved)) as Points).positions[2])
        assertEquals(5f, (surface(source(1, node = moved)) as Lines).positions[2])
    }
}
