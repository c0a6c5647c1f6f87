package dev.lazyz.scenes.ply

import dev.lazyz.scenes.SceneFormatException
import dev.lazyz.scenes.loading.Source
import dev.lazyz.scenes.text.ByteWindow
import dev.lazyz.scenes.text.TextLines
import java.io.IOException
import java.io.InputStream
import java.nio.ByteOrder
import org.joml.Vector3d

/**
 * Where the vertices and triangles of a binary PLY file are, if they are records of one length each, so that programs
 * on several machines can read parts of the file. Only for plain triangles: `Scenes` reads every PLY file.
 *
 * All vertices come first, at [start]. They have 32-bit positions, and nothing else that `Scenes` would use: no
 * normals, colours or texture coordinates. The faces follow, [FACE_BYTES] bytes each: the number of corners, one byte,
 * and three 32-bit vertex numbers. Whether the number of corners is 3 and the file has all its bytes is left to the
 * caller. Immutable.
 *
 * @property order order of the bytes of numbers
 * @property start position of the first vertex, in bytes
 * @property vertexBytes length of a vertex, in bytes
 * @property faceCount number of faces
 */
public class PlyRecords private constructor(
    public val order: ByteOrder,
    public val start: Long,
    public val vertexCount: Int,
    public val vertexBytes: Int,
    private val positions: IntArray,
    public val faceCount: Int,
) {
    /** Returns the position of x (0), y (1) or z (2) in a vertex, in bytes. */
    public fun positionOffset(axis: Int): Int = positions[axis]

    override fun toString(): String = "PlyRecords(vertices=$vertexCount, faces=$faceCount, start=$start, order=$order)"

    public companion object {
        /** Length of a face, in bytes. */
        public const val FACE_BYTES: Int = 1 + 3 * Int.SIZE_BYTES

        private const val REMEDY = "load it with Scenes.load, or convert it to binary PLY with plain triangles"

        /**
         * Reads the header at the beginning of [input], which stays open.
         *
         * @param name name of the file in messages
         * @throws SceneFormatException if the header is damaged, or the file is not of this kind
         * @throws IOException if [input] cannot be read
         */
        @JvmStatic
        @Throws(IOException::class)
        public fun read(input: InputStream, name: String): PlyRecords {
            val source = Source(ByteArray(0), name, null)
            val header = PlyHeaderReader(source, TextLines(ByteWindow(source, input))).read()
            fun fail(problem: String): Nothing = source.fail("header", problem, REMEDY)

            // Records of one length, the vertices first
            val order = when (header.format) {
                PlyFormat.ASCII -> fail("is a text file, which cannot be divided")
                PlyFormat.LITTLE_ENDIAN -> ByteOrder.LITTLE_ENDIAN
                PlyFormat.BIG_ENDIAN -> ByteOrder.BIG_ENDIAN
            }
            if (header.elements.map { it.name } != listOf("vertex", "face")) {
                fail("has other elements than vertices and faces, in this order")
            }
            val (vertex, face) = header.elements
            if (vertex.hasLists) fail("vertices have lists, and so no length of their own")

            // Nothing that would change the picture but positions
            val used = PlyVertices(source, vertex, Vector3d())
            val others = (used.columns - used.position.toSet()).sorted().map { "'${vertex.properties[it].name}'" }
            if (others.isNotEmpty()) fail("vertices have ${others.joinToString()}, which tables do not have")
            val double = used.position.map { vertex.properties[it] }.firstOrNull { it.type != PlyType.FLOAT }
            if (double != null) fail("vertices have no 32-bit '${double.name}'")
            val numbers = face.properties[PlyFaces(source, vertex.count).indexColumn(face)]
            val isPlain = face.properties.size == 1 && numbers.countType == PlyType.UCHAR
            if (!isPlain || numbers.type !in listOf(PlyType.INT, PlyType.UINT)) {
                fail("faces are not a list of a byte and 32-bit numbers, and nothing else")
            }
            val places = vertex.properties.runningFold(0) { place, property -> place + property.type.size }
            return PlyRecords(
                order,
                header.bodyPosition,
                vertex.count,
                places.last(),
                IntArray(3) { places[used.position[it]] },
                face.count,
            )
        }
    }
}
