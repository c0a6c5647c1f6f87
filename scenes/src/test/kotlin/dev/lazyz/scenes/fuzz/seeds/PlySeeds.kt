package dev.lazyz.scenes.fuzz.seeds

import dev.lazyz.scenes.ply.PlyFiles
import dev.lazyz.scenes.ply.PlyFormat

/** Meshes in all three forms of PLY. */
internal object PlySeeds {
    private val corners = listOf(listOf(0, 0, 0), listOf(1, 0, 0), listOf(1, 1, 0), listOf(0, 1, 0))

    private fun header(vararg lines: String) =
        "ply\nformat FORMAT 1.0\n" + lines.joinToString("") { "$it\n" } + "end_header\n"

    private val plain = header(
        "element vertex 4", "property float x", "property float y", "property float z",
        "element face 1", "property list uchar int vertex_indices",
    ) to listOf("float float float" to corners, "uchar/int" to listOf(listOf(listOf(0, 1, 2, 3))))

    private val rich = header(
        "comment TextureFile t.png", "obj_info nothing",
        "element vertex 4", "property double x", "property double y", "property double z",
        "property float nx", "property float ny", "property float nz", "property float s", "property float t",
        "property uchar red", "property uchar green", "property uchar blue", "property uchar alpha",
        "element edge 1", "property int a", "property list uchar short b",
        "element face 2", "property float quality", "property list uchar uint vertex_index",
        "property list uchar float texcoord", "property uchar red", "property uchar green", "property uchar blue",
    ) to listOf(
        "double double double float float float float float uchar uchar uchar uchar" to
            corners.map { it + listOf(0, 0, 1, it[0], it[1], 255, 128, 0, 255) },
        "int uchar/short" to listOf(listOf(1, listOf(1, 2, 3))),
        "float uchar/uint uchar/float uchar uchar uchar" to listOf(
            listOf(0.5, listOf(0, 1, 2), listOf(0, 0, 1, 0, 1, 1), 1, 2, 3),
            listOf(0.5, listOf(0, 2, 3), listOf(0, 0, 1, 1, 0, 1), 1, 2, 3),
        ),
    )

    private val strips = header(
        "element vertex 4", "property float x", "property float y", "property float z",
        "property float red", "property float green", "property ushort blue",
        "element tristrips 1", "property list int int vertex_indices",
    ) to listOf(
        "float float float float float ushort" to corners.map { it + listOf(1, 0.5, 9) },
        "int/int" to listOf(listOf(listOf(0, 1, 2, 3, -1, 0, 2, 3))),
    )

    val all: List<ByteArray> = listOf(plain, rich, strips).flatMap { (header, tables) ->
        PlyFormat.entries.map { PlyFiles.of(it, header, tables) }
    }
}
