package dev.lazyz.scenes.loading

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.formats.Scenes
import java.nio.file.Path
import kotlin.io.path.writeText
import org.junit.jupiter.api.Assertions.assertEquals
import org.junit.jupiter.api.Assertions.assertTrue
import org.junit.jupiter.api.Test
import org.junit.jupiter.api.io.TempDir

/** Warnings of one kind are one, in all formats. */
class WarningsTest {
    @TempDir
    lateinit var folder: Path

    @Test
    fun theFirstAndSomeOfTheOthersAreNamed() {
        val warnings = Warnings()
        for (name in listOf("a", "b", "a")) warnings.add("m: material ", name, " is white")
        for (name in listOf("a", "b", "c", "d", "e", "f")) warnings.add("m: texture ", name, " is missing")
        warnings.add("m: alone", "", "")
        val expected = listOf(
            "m: material a is white (the same for 1 more: b)",
            "m: texture a is missing (the same for 5 more: b, c, d, ...)", "m: alone",
        )
        assertEquals(expected, warnings.toList())
    }

    @Test
    fun aHundredOfEachKindInAnObjFile() {
        folder.resolve("m.mtl").writeText(many { "newmtl textured$it\nmap_Kd none$it.png\nnewmtl hidden$it\nd 0\n" })
        val text = "mtllib m.mtl\n" + many { "mtllib none$it.mtl\n" } + "v 0 0 0\nv 1 0 0\nv 0 1 0\n" +
            many {
                "usemtl undefined$it\nf 1 2 3\nusemtl textured$it\nf 1 2 3\nusemtl hidden$it\nf 1 2 3\nf 1 2\nl 1\n"
            }
        val file = folder.resolve("m.obj").apply { writeText(text) }
        val warnings = Scenes.load(file).warnings
        for (part in listOf(
            "material library none0.mtl ", "texture none0.png ", "material undefined0 is not defined",
            "material hidden0: d 0", ": a face of 2 corners", ": a line of 1 vertices",
        )) {
            val warning = warnings.single { part in it }
            assertTrue("(the same for 99 more: " in warning && warning.endsWith(", ...)"), warning)
        }
        assertEquals(6, warnings.size, "$warnings")
    }

    @Test
    fun aHundredOfEachKindInAGltfFile() {
        fun objects(text: (Int) -> String) = List(100, text).joinToString(",")
        val json = """{"asset": {"version": "2.0"}, "scene": 0,
            "scenes": [{"nodes": [0, ${objects { "${it + 1}" }}]}],
            "nodes": [{"mesh": 0}, ${objects { """{"camera": $it}""" }}],
            "cameras": [${objects { """{"type": "perspective", "perspective": {"yfov": -1, "znear": 1}}""" }}],
            "images": [${objects { """{"uri": "none$it.png"}""" }}],
            "textures": [${objects { """{"source": $it}""" }}],
            "materials": [${objects {
            """{"alphaMode": "ODD", "pbrMetallicRoughness": {"baseColorTexture": {"index": $it}}}"""
        }}],
            "meshes": [{"primitives": [${objects { """{"attributes": {"POSITION": 0}, "material": $it}""" }},
                ${objects { """{"attributes": {}}""" }}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                "min": [0, 0, 0], "max": [1, 1, 0]}],
            "bufferViews": [{"buffer": 0, "byteLength": 36}],
            "buffers": [{"byteLength": 36, "uri":
                "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}]}"""
        val warnings = Scenes.load(json.toByteArray(), SceneFormat.GLTF, "m.gltf").warnings
        for (part in listOf("images[0] (none0.png)", "there are no positions", "cameras[0] is passed")) {
            val warning = warnings.single { part in it }
            assertTrue("(the same for 99 more: " in warning, warning)
        }
        assertEquals(5, warnings.size, "$warnings")
    }

    private fun many(text: (Int) -> String): String = List(100, text).joinToString("")
}
