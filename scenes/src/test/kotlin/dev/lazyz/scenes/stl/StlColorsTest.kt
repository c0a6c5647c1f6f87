package dev.lazyz.scenes.stl

import dev.lazyz.Rgba
import dev.lazyz.scenes.loading.TestSources
import dev.lazyz.scenes.loading.corners
import dev.lazyz.scenes.loading.meshes
import dev.lazyz.world.surface.Mesh
import java.nio.ByteBuffer
import java.nio.ByteOrder
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertNull
import org.junit.jupiter.api.Test

class StlColorsTest {
    private val square = listOf(0f, 0f, 0f, 1f, 0f, 0f, 1f, 1f, 0f)
    private val meshLab =
        "COLOR=".toByteArray() + ByteArray(3) { 0x7F } + " MATERIAL=".toByteArray() + ByteArray(11) { 0x7F }
    private val magics = "by hand COLOR=".toByteArray() + byteArrayOf(0, -1, 0, -1) + ",MATERIAL=".toByteArray()

    /** A strip of facets with the given words. */
    private fun file(vararg words: Int, header: ByteArray = ByteArray(0)): ByteArray {
        val buffer = ByteBuffer.allocate(84 + 50 * words.size).order(ByteOrder.LITTLE_ENDIAN)
        buffer.put(header).position(80).putInt(words.size)
        for ((i, word) in words.withIndex()) {
            repeat(3) { buffer.putFloat(0f) }
            for ((at, number) in square.withIndex()) buffer.putFloat(if (at % 3 == 0) number + i else number)
            buffer.putShort(word.toShort())
        }
        return buffer.array()
    }

    private fun mesh(bytes: ByteArray, warnings: List<String> = emptyList()): Mesh {
        val source = TestSources.of(bytes)
        val mesh = StlParser.parse(source).meshes.single()
        assertEquals(warnings, source.warnings)
        return mesh
    }

    /** The colour of each facet, as codes. */
    private fun colors(bytes: ByteArray): List<String> {
        val mesh = mesh(bytes)
        val corners = mesh.triangles.map { mesh.colors!!.slice(4 * it until 4 * it + 4) }
        return corners.chunked(3) { facet -> facet.distinct().single() }
            .map { (r, g, b, a) -> "%08X".format(Rgba(r, g, b, a).toArgb()) }
    }

    @Test
    fun visCamHasRedInTheHighestBits() {
        val codes = colors(file(0xFC00, 0x83E0, 0x801F, 0, 0x8000, 0xC210))
        assertEquals(listOf("FFFF0000", "FF00FF00", "FF0000FF", "FFFFFFFF", "FF000000", "FF848484"), codes)
    }

    @Test
    fun magicsHasRedInTheLowestBitsAndAColourOfTheWhole() {
        val codes = colors(file(0x7C00, 0x03E0, 0x001F, 0x8000, 0xFFFF, 0, header = magics))
        assertEquals(listOf("FF0000FF", "FF00FF00", "FFFF0000", "FF00FF00", "FF00FF00", "FF000000"), codes)
        assertEquals(listOf("FF00FF00", "FF00FF00"), colors(file(0x8000, 0xFFFF, header = magics)))
    }

    @Test
    fun theColourOfTheWholeIsNoneIfNoFacetHasOrWantsOne() {
        for (header in listOf(magics, meshLab)) assertNull(mesh(file(0, 0, header = header)).colors)
        val warning = "test: the attribute words of 1 facets are not used, for they are no colours"
        for (word in listOf(0x8000, 0xFFFF)) {
            assertNull(mesh(file(0, word, header = meshLab), listOf(warning)).colors)
        }
    }

    @Test
    fun meshLabMarksColoursInItsHeadersOwnOrder() {
        val codes = colors(file(0xFC00, 0x83E0, 0x801F, 0, 0x8000, 0xFFFF, header = meshLab))
        assertEquals(listOf("FF0000FF", "FF00FF00", "FFFF0000", "FFFFFFFF", "FF000000", "FFFFFFFF"), codes)
    }

    @Test
    fun facetsOfOneColourShareVertices() {
        assertEquals(7, mesh(file(0xFFFF, 0xFFFF, 0xFFFF)).vertexCount)
        assertEquals(9, mesh(file(0xFFFF, 0x801F, 0xFFFF)).vertexCount)
        assertEquals(mesh(file(0, 0)).corners(), mesh(file(0xFFFF, 0x801F)).corners())
    }

    @Test
    fun theMarkMustHaveItsColourWithinTheHeader() {
        val late = ByteArray(80) { ' '.code.toByte() }.also { "COLOR=".toByteArray().copyInto(it, 71) }
        val noColors = listOf("test: the attribute words of 1 facets are not used, for they are no colours")
        assertNull(mesh(file(0x8000, header = late), noColors).colors)
        val last = ByteArray(80) { ' '.code.toByte() }.also { "COLOR=".toByteArray().copyInto(it, 70) }
        assertEquals(listOf("FF202020"), colors(file(0x8000, header = last)))
    }
}
