package dev.lazyz.scenes.interrupts

import dev.lazyz.scenes.SceneFormat
import dev.lazyz.scenes.threemf.ThreeMfFiles

/**
 * A file that is long because one construct is repeated.
 *
 * @property isStreamed whether it can also be read part by part
 */
internal class LongInput(
    val format: SceneFormat,
    private val construct: String,
    val isStreamed: Boolean = false,
    private val make: () -> ByteArray,
) {
    fun bytes(): ByteArray = make()

    override fun toString(): String = "$format, $construct"
}

/** Files of each format, one for each construct that a file can repeat. */
internal object LongInputs {
    private const val BYTES = 2 shl 20

    val all: List<LongInput> = ply() + obj() + stl() + off() + threeMf() + gltf() + gltf1() + scenes()

    /** Returns [head], then what [unit] returns for 0, 1, 2..., then [tail], of about [bytes] bytes. */
    fun text(head: String, tail: String = "", bytes: Int = BYTES, unit: (Int) -> String): ByteArray {
        val text = StringBuilder(bytes + 1000).append(head)
        var i = 0
        while (text.length < bytes) text.append(unit(i++))
        return text.append(tail).toString().toByteArray(Charsets.ISO_8859_1)
    }

    /** Like [text], without the last character of the last unit: a comma. */
    private fun list(head: String, tail: String, unit: (Int) -> String): ByteArray {
        val text = StringBuilder(String(text(head, "", BYTES, unit), Charsets.ISO_8859_1))
        text.setLength(text.length - 1)
        return text.append(tail).toString().toByteArray(Charsets.ISO_8859_1)
    }

    private fun ply(): List<LongInput> {
        val xyz = "property float x\nproperty float y\nproperty float z\n"
        fun plain(format: String, faces: String = "") =
            "ply\nformat $format 1.0\nelement vertex 3\n$xyz${faces}end_header\n"
        val corners = "0 0 0\n1 0 0\n0 1 0\n"
        val start = "ply\nformat ascii 1.0\nelement vertex 3\n$xyz"
        fun header(name: String, unit: (Int) -> String) =
            LongInput(SceneFormat.PLY, name, isStreamed = true) { text(start, "end_header\n$corners", unit = unit) }
        fun rows(name: String, element: String, unit: (Int) -> String) = LongInput(SceneFormat.PLY, name, true) {
            text("$start$element\nend_header\n$corners", unit = unit)
        }
        fun binary(name: String, faces: String, unit: String) = LongInput(SceneFormat.PLY, name, true) {
            text(plain("binary_little_endian", "$faces\n") + "\u0000".repeat(36)) { unit }
        }
        return listOf(
            header("elements") { "element e$it 0\n" },
            header("properties") { "property int p$it\n" },
            header("comments") { "comment a\n" },
            header("textures") { "comment TextureFile a\n" },
            header("empty lines") { "\n" },
            LongInput(SceneFormat.PLY, "vertices", true) {
                text("ply\nformat ascii 1.0\nelement vertex 99999999\n${xyz}end_header\n") { "$it 0 0\n" }
            },
            rows("faces", "element face 99999999\nproperty list uchar int vertex_indices") { "3 0 1 2\n" },
            rows("one long face", "element face 1\nproperty list int int vertex_indices") {
                if (it == 0) "3000000 " else "0 "
            },
            rows("strips", "element tristrips 1\nproperty list int int vertex_indices") {
                if (it == 0) "3000000 " else "${it % 3} "
            },
            rows("edges", "element edge 99999999\nproperty int vertex1\nproperty int vertex2") { "0 1\n" },
            rows("rows of no use", "element a 99999999\nproperty int b") { "1\n" },
            binary(
                "binary faces",
                "element face 99999999\nproperty list uchar int vertex_indices",
                "\u0003" + "\u0000".repeat(12),
            ),
            binary("binary rows", "element a 99999999\nproperty list uchar char b", "\u0000"),
            binary("a binary list", "element a 1\nproperty list uint char b", "\u0001\u0002\u0003\u0000"),
        )
    }

    private fun obj(): List<LongInput> {
        val start = "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
        fun of(name: String, head: String = start, unit: (Int) -> String) =
            LongInput(SceneFormat.OBJ, name, true) { text(head, "\nf 1 2 3\n", unit = unit) }
        return listOf(
            of("vertices") { "v $it 0 0\n" },
            of("texture coordinates") { "vt 0 0\n" },
            of("normals") { "vn 0 0 1\n" },
            of("faces") { "f 1 2 3\n" },
            of("one long face", start + "f") { " ${1 + it % 3}" },
            of("one long line", start + "l") { " 1" },
            of("one long number", start + "v ") { "0" },
            of("points") { "p 1\n" },
            of("objects") { "o a\nf 1 2 3\n" },
            of("materials") { "usemtl $it\nf 1 2 3\n" },
            of("groups") { "g $it\n" },
            of("smoothing groups") { "s $it\n" },
            of("libraries") { "mtllib $it\n" },
            of("unknown statements") { "a$it 1\n" },
            of("curves") { "curv 0 1 1 2\n" },
            of("comments") { "# a\n" },
            of("empty lines") { "\n" },
            of("joined lines") { "\\\n" },
            of(
                "faces that cross themselves",
                (0 until 4096).joinToString("") { "v ${it * 7919L % 4096} ${it * 104729L % 4093} 0\n" },
            ) {
                (1..4096).joinToString(" ", "f ", "\n")
            },
        )
    }

    private fun stl(): List<LongInput> {
        val facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"
        fun of(name: String, head: String, tail: String = "", unit: (Int) -> String) =
            LongInput(SceneFormat.STL, name, true) { text(head, tail, unit = unit) }
        return listOf(
            of("facets", "solid a\n") { facet },
            of("solids", "") { "solid a$it\n${facet}endsolid\n" },
            of("one loop", "solid a\nfacet normal 0 0 1\nouter loop\n", "endloop\nendfacet\n") {
                "vertex $it ${it % 7} 0\n"
            },
            of("comments", "solid a\n$facet") { "# a\n" },
            of("padding", "solid a\n${facet}endsolid\n") { "\u0000 " },
            LongInput(SceneFormat.STL, "binary facets", true) {
                val facets = BYTES / 50
                ByteArray(84 + 50 * facets) { i ->
                    if (i in 80..83) (facets ushr 8 * (i - 80)).toByte() else (i / 7).toByte()
                }
            },
        )
    }

    private fun off(): List<LongInput> {
        fun of(name: String, head: String, unit: (Int) -> String) =
            LongInput(SceneFormat.OFF, name) { text(head, unit = unit) }
        return listOf(
            of("comments", "OFF\n") { "# a\n" },
            of("vertices", "OFF\n700000 0 0\n") { "0 0 0\n" },
            of("faces", "OFF\n3 9999999 0\n0 0 0\n1 0 0\n0 1 0\n") { "3 0 1 2\n" },
            of("one long face", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3000000") { " ${it % 3}" },
        )
    }

    private fun threeMf(): List<LongInput> {
        val item = "<item objectid=\"1\"/>"
        val thing = "<object id=\"1\">${ThreeMfFiles.TRIANGLE}</object>"
        fun of(name: String, unit: (Int) -> String, model: (String) -> String) = LongInput(SceneFormat.THREE_MF, name) {
            ThreeMfFiles.of(model(String(text("", unit = unit))))
        }
        val mesh = ThreeMfFiles.TRIANGLE
        return listOf(
            of("objects", { "<object id=\"${it + 2}\"/>" }) { ThreeMfFiles.model(thing + it, item) },
            of("items", { item }) { ThreeMfFiles.model(thing, it) },
            of("components", { "<component objectid=\"1\"/>" }) {
                val parts = "$thing<object id=\"2\"><components>$it</components></object>"
                ThreeMfFiles.model(parts, "<item objectid=\"2\"/>")
            },
            of("vertices", { "<vertex x=\"0\" y=\"0\" z=\"0\"/>" }) {
                ThreeMfFiles.model("<object id=\"1\">${mesh.replace("</vertices>", "$it</vertices>")}</object>", item)
            },
            of("triangles", { "<triangle v1=\"0\" v2=\"1\" v3=\"2\"/>" }) {
                val more = mesh.replace("</triangles>", "$it</triangles>")
                ThreeMfFiles.model("<object id=\"1\">$more</object>", item)
            },
            of("groups", { "<basematerials id=\"${it + 2}\"/>" }) { ThreeMfFiles.model(it + thing, item) },
            of("colours", { "<m:color color=\"#123456\"/>" }) {
                ThreeMfFiles.model("<m:colorgroup id=\"2\">$it</m:colorgroup>$thing", item)
            },
            of("text", { "abcdefgh" }) { ThreeMfFiles.model(thing + it, item) },
            of("comments", { "<!--a-->" }) { ThreeMfFiles.model(thing + it, item) },
            of("attributes", { " a$it=\"1\"" }) { ThreeMfFiles.model("$thing<a$it/>", item) },
            LongInput(SceneFormat.THREE_MF, "files") {
                val empty = Array(60_000) { "a$it" to ByteArray(0) }
                ThreeMfFiles.of(ThreeMfFiles.model(thing, item), *empty)
            },
        )
    }

    private fun json(format: SceneFormat, name: String, head: String, tail: String, unit: (Int) -> String) =
        LongInput(format, name) { list(head, tail, unit) }

    private fun gltf(): List<LongInput> {
        fun of(name: String, head: String, tail: String = "", unit: (Int) -> String) =
            json(SceneFormat.GLTF, name, """{"asset": {"version": "2.0"}, $head""", "$tail}", unit)
        val mesh = """"meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
            "accessors": [{"componentType": 5126, "count": 3, "type": "VEC3"}],"""
        return listOf(
            of("equal keys", "") { """"a":1,""" },
            of("unknown keys", "") { """"a$it":1,""" },
            of("unknown keys of a node", """"nodes": [{""", "}]") { """"a$it":1,""" },
            of("nodes", """"nodes": [""", "]") { "{}," },
            of("nodes with meshes", """$mesh "nodes": [""", "]") { """{"mesh":0},""" },
            of("children", """"nodes": [{"children": [""", "]}, {}]") { "1," },
            of("meshes", """"meshes": [""", "]") { """{"primitives":[]},""" },
            of(
                "primitives",
                """"accessors": [{"componentType": 5126, "count": 3, "type": "VEC3"}], "nodes": [{"mesh": 0}],
                "meshes": [{"primitives": [""",
                "]}]"
            ) { """{"attributes":{"POSITION":0}},""" },
            of("attributes", """"meshes": [{"primitives": [{"attributes": {""", "}}]}]") { """"A$it":0,""" },
            of("accessors", """"accessors": [""", "]") { "{}," },
            of("materials", """"materials": [""", "]") { """{"alphaMode":"X$it"},""" },
            of("textures", """"textures": [""", "]") { "{}," },
            of("animations", """"animations": [""", "]") { "{}," },
            of("extensions", """"extensionsUsed": [""", "]") { """"A$it",""" },
            of("wrong values", """"nodes": [""", "]") { """{"scale":[1]},""" },
            of("numbers", """"extras": [""", "]") { "0.$it," },
            of("lists", """"extras": [""", "]") { "[]," },
            of("spaces", """"extras": 1 """) { "  " },
            of("one text", """"extras": """") { "abcdefgh\"".dropLast(1) + "a" },
        )
    }

    private fun gltf1(): List<LongInput> {
        fun of(name: String, unit: (Int) -> String) =
            json(SceneFormat.GLTF, "1.0, $name", """{"asset": {"version": "1.0"}, "$name": {""", "}}", unit)
        val kinds = listOf("nodes", "meshes", "accessors", "bufferViews", "materials", "textures", "images", "scenes")
        return (kinds + "techniques")
            .map { name -> of(name) { """"a$it":{},""" } }
    }

    private fun scenes(): List<LongInput> {
        fun of(name: String, head: String, tail: String = "", unit: (Int) -> String) =
            json(SceneFormat.SCENE, name, """{"lazyz": 1, $head""", "$tail}", unit)
        return listOf(
            of("equal keys", """"surfaces": [""", "]") { """{"sphere":{"center":[0,0,0],"radius":1}},""" },
            of("materials", """"materials": {""", "}") { """"a$it":{},""" },
            of("unknown keys", """"materials": {"a": {""", "}}") { """"a$it":1,""" },
            of("positions", """"surfaces": [{"mesh": {"triangles": [], "positions": [""", "]}}]") { "0,0,1," },
            of("triangles", """"surfaces": [{"mesh": {"positions": [0, 0, 0], "triangles": [""", "]}}]") { "0,0,0," },
            of("corners", """"surfaces": [{"polygon": {"contours": [[""", "]]}}]") { "[0,0,$it]," },
            of("lights", """"lights": [""", "]") { """{"directional":{"direction":[0,0,1]}},""" },
            of("transforms", """"surfaces": [{"sphere": {"center": [0, 0, 0], "radius": 1}, "transform": [""", "]}]") {
                """{"scale":1},"""
            },
            of("lists", """"surfaces": [""", "]") { "[]," },
            of("spaces", """"surfaces": [] """) { "  " },
            of("one text", """"background": "#""") { "abcdefghi" },
        )
    }
}
