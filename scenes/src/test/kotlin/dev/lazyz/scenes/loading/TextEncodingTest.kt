package dev.lazyz.scenes.loading

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.FormatSniffer
import dev.lazyz.scenes.obj.ObjParser
import dev.lazyz.scenes.ply.PlyParser
import dev.lazyz.scenes.stl.StlParser
import java.nio.file.Files
import java.nio.file.Path
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertSame
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

class TextEncodingTest {
    private val encodings = listOf(Charsets.UTF_8, Charsets.UTF_16LE, Charsets.UTF_16BE)

    private fun marked(text: String) = encodings.map { ("\uFEFF" + text).toByteArray(it) }

    private fun utf8(bytes: ByteArray) = String(TextEncoding.utf8(TestSources.of(bytes)))

    @Test
    fun marksTellTheEncoding() {
        for (bytes in marked("v ä\uD83D\uDE00")) assertEquals("v ä\uD83D\uDE00", utf8(bytes))
        val plain = TestSources.of(byteArrayOf(1, 2))
        assertSame(plain.bytes, TextEncoding.utf8(plain))

        // Half a pair with half a character behind it is replaced
        val broken = byteArrayOf(0xFF.toByte(), 0xFE.toByte(), 0x3D, 0xD8.toByte(), 7)
        assertEquals("\uFFFD", utf8(broken))
    }

    @Test
    fun textFormatsAreReadInAllEncodings() {
        val obj = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n"
        val stl =
            "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n" +
                "endsolid a\n"
        val ply = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n" +
            "element face 1\nproperty list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
        val texts = listOf<Triple<SceneFormat, SceneParser, String>>(
            Triple(SceneFormat.OBJ, ObjParser, obj),
            Triple(SceneFormat.STL, StlParser, stl),
            Triple(SceneFormat.PLY, PlyParser, ply),
        )
        for ((format, parser, text) in texts) {
            val expected = listOf(listOf(0f, 0f, 0f), listOf(1f, 0f, 0f), listOf(0f, 1f, 0f))
            for (bytes in marked(text)) {
                assertEquals(format, FormatSniffer.format(bytes))
                assertEquals(expected, parser.parse(TestSources.of(bytes)).meshes.single().corners(), "$format")
            }
        }
    }

    @Test
    fun materialLibrariesAreReadInAllEncodings(@TempDir folder: Path) {
        for (bytes in marked("newmtl größe\nKd 0 0 0\n")) {
            Files.write(folder.resolve("m.mtl"), bytes)
            val source = TestSources.of("mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl größe\nf 1 2 3\n", folder)
            assertEquals(0f, ObjParser.parse(source).meshes.single().material.baseColor.red)
            assertEquals(emptyList<String>(), source.warnings)
        }
    }
}
