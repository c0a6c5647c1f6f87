package dev.lazyz.scenes.ply

import dev.lazyz.scenes.Source
import dev.lazyz.scenes.images.SrgbDecoding

/** The vertices of a file: arrays as [dev.lazyz.Mesh] wants them, null for what the file does not have. */
internal class PlyVertices private constructor(
    val positions: FloatArray,
    val normals: FloatArray?,
    val uvs: FloatArray?,
    val colors: FloatArray?,
) {
    /** How many vertices there are. */
    val count: Int get() = positions.size / 3

    companion object {
        private val texturePairs =
            listOf("s", "t", "u", "v", "texture_u", "texture_v", "texture_s", "texture_t").chunked(2)

        /** Reads all rows of [element] from [body]. */
        fun read(source: Source, element: PlyElement, body: PlyBody): PlyVertices {
            val position = listOf("x", "y", "z").map { name ->
                element.column(listOf(name)) ?: source.fail("header", "element vertex has no property $name", "add it")
            }.toIntArray()
            val normal = columns(listOf("nx", "ny", "nz")) { element.column(listOf(it)) }
            val texture = texturePairs.firstNotNullOfOrNull { pair -> columns(pair) { element.column(listOf(it)) } }
            val color = columns(listOf("red", "green", "blue")) { colorColumn(element, it) }
            val alpha = colorColumn(element, "alpha")

            body.announce(element)
            val count = element.count
            source.loading.vertices(source, count.toLong())
            val vertices = PlyVertices(
                FloatArray(3 * count),
                normal?.let { FloatArray(3 * count) },
                texture?.let { FloatArray(2 * count) },
                color?.let { FloatArray(4 * count) },
            )
            val row = PlyRow(element)
            for (i in 0 until count) {
                body.read(row)
                vertices.set(i, row, position, normal, texture)
                if (color != null) vertices.setColor(i, row, color, alpha)
            }
            return vertices
        }

        /** Returns the numbers of the columns with all of [names], or null. */
        private fun columns(names: List<String>, find: (String) -> Int?): IntArray? =
            names.mapNotNull(find).takeIf { it.size == names.size }?.toIntArray()

        private fun colorColumn(element: PlyElement, name: String): Int? =
            element.column(listOf(name, "diffuse_$name", name.substring(0, 1)))
    }

    private fun set(vertex: Int, row: PlyRow, position: IntArray, normal: IntArray?, texture: IntArray?) {
        for (axis in 0 until 3) positions[3 * vertex + axis] = row.numbers[position[axis]].toFloat()
        if (normals != null && normal != null) {
            for (axis in 0 until 3) normals[3 * vertex + axis] = row.numbers[normal[axis]].toFloat()
        }
        if (uvs != null && texture != null) {
            uvs[2 * vertex] = row.numbers[texture[0]].toFloat()
            uvs[2 * vertex + 1] = (1.0 - row.numbers[texture[1]]).toFloat()
        }
    }

    private fun setColor(vertex: Int, row: PlyRow, color: IntArray, alpha: Int?) {
        if (colors == null) return
        for (channel in 0 until 3) colors[4 * vertex + channel] = decoded(row, color[channel])
        colors[4 * vertex + 3] = if (alpha == null) 1f else (row.numbers[alpha] / most(row, alpha)).toFloat()
    }

    private fun decoded(row: PlyRow, column: Int): Float {
        // Codes go by the table, so that they are the colours of the same codes in a texture
        val number = row.numbers[column]
        val isCode = row.element.properties[column].type == PlyType.UCHAR
        if (isCode) return SrgbDecoding.decodeByte(number.toInt().coerceIn(0, 255))
        return SrgbDecoding.decode(number / most(row, column))
    }

    private fun most(row: PlyRow, column: Int): Double = row.element.properties[column].type.most
}
