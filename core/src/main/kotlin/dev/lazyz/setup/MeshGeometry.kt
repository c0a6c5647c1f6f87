package dev.lazyz.setup

import dev.lazyz.Mesh
import org.joml.Matrix4dc

/** Moves meshes and gives them normals. */
internal object MeshGeometry {
    /** Where more corners than this meet, creases are not looked for: it would cost the square of their number. */
    private const val CROWD = 1024

    fun transformed(mesh: Mesh, m: Matrix4dc): Mesh {
        // The cofactors are the inverse transpose times the determinant; its sign is what mirrors
        val c00 = m.m11() * m.m22() - m.m12() * m.m21()
        val c01 = m.m12() * m.m20() - m.m10() * m.m22()
        val c02 = m.m10() * m.m21() - m.m11() * m.m20()
        val c10 = m.m21() * m.m02() - m.m22() * m.m01()
        val c11 = m.m22() * m.m00() - m.m20() * m.m02()
        val c12 = m.m20() * m.m01() - m.m21() * m.m00()
        val c20 = m.m01() * m.m12() - m.m02() * m.m11()
        val c21 = m.m02() * m.m10() - m.m00() * m.m12()
        val c22 = m.m00() * m.m11() - m.m01() * m.m10()
        val isMirror = m.m00() * c00 + m.m01() * c01 + m.m02() * c02 < 0.0
        val sign = if (isMirror) -1.0 else 1.0

        val positions = FloatArray(mesh.positions.size)
        for (i in positions.indices step 3) {
            val x = mesh.positions[i].toDouble()
            val y = mesh.positions[i + 1].toDouble()
            val z = mesh.positions[i + 2].toDouble()
            positions[i] = (m.m00() * x + m.m10() * y + m.m20() * z + m.m30()).toFloat()
            positions[i + 1] = (m.m01() * x + m.m11() * y + m.m21() * z + m.m31()).toFloat()
            positions[i + 2] = (m.m02() * x + m.m12() * y + m.m22() * z + m.m32()).toFloat()
        }
        val normals = mesh.normals?.let { from ->
            FloatArray(from.size).also { to ->
                for (i in to.indices step 3) {
                    val x = from[i].toDouble()
                    val y = from[i + 1].toDouble()
                    val z = from[i + 2].toDouble()
                    unit(
                        sign * (c00 * x + c10 * y + c20 * z),
                        sign * (c01 * x + c11 * y + c21 * z),
                        sign * (c02 * x + c12 * y + c22 * z),
                        to,
                        i,
                    )
                }
            }
        }
        val triangles = mesh.triangles.copyOf()
        if (isMirror) {
            for (i in triangles.indices step 3) {
                triangles[i + 1] = mesh.triangles[i + 2]
                triangles[i + 2] = mesh.triangles[i + 1]
            }
        }
        return Mesh(positions, triangles, mesh.material, normals, mesh.uvs, mesh.colors)
    }

    fun smoothed(mesh: Mesh, creaseAngle: Double): Mesh {
        require(creaseAngle in 0.0..180.0) { "creaseAngle must be in 0..180 degrees: $creaseAngle" }
        val cosine = StrictMath.cos(creaseAngle * (StrictMath.PI / 180.0))
        val faces = faceNormals(mesh)
        val cornersAt = cornersByPosition(mesh)

        // The normal of each corner: the sum over the corners at its position whose faces differ by less than the crease
        val normals = FloatArray(3 * mesh.triangles.size)
        for (corners in cornersAt) {
            val isCrowded = corners.size > CROWD
            if (isCrowded) mean(corners, faces, normals)
            for (corner in corners) {
                if (isCrowded) continue
                val face = corner / 3
                val length = length(faces, face)
                var x = 0.0
                var y = 0.0
                var z = 0.0
                for (other in corners) {
                    val otherFace = other / 3
                    val dot = dot(faces, face, otherFace)
                    if (otherFace != face && dot <= cosine * length * length(faces, otherFace)) continue
                    x += faces[3 * otherFace]
                    y += faces[3 * otherFace + 1]
                    z += faces[3 * otherFace + 2]
                }
                unit(x, y, z, normals, 3 * corner)
            }
        }
        return split(mesh, normals)
    }

    /** Gives all [corners] the sum of their faces' normals, at unit length. */
    private fun mean(corners: IntArray, faces: DoubleArray, normals: FloatArray) {
        var x = 0.0
        var y = 0.0
        var z = 0.0
        for (corner in corners) {
            x += faces[3 * (corner / 3)]
            y += faces[3 * (corner / 3) + 1]
            z += faces[3 * (corner / 3) + 2]
        }
        for (corner in corners) unit(x, y, z, normals, 3 * corner)
    }

    /** Gives each vertex of [mesh] as many copies as it has different normals among its corners. */
    private fun split(mesh: Mesh, cornerNormals: FloatArray): Mesh {
        val copies = HashMap<Copy, Int>()
        val sources = ArrayList<Copy>()
        val triangles = IntArray(mesh.triangles.size) { corner ->
            val copy = Copy(
                mesh.triangles[corner],
                cornerNormals[3 * corner],
                cornerNormals[3 * corner + 1],
                cornerNormals[3 * corner + 2],
            )
            copies.getOrPut(copy) {
                sources.add(copy)
                sources.size - 1
            }
        }

        fun gather(array: FloatArray?, size: Int): FloatArray? =
            array?.let { FloatArray(size * sources.size) { i -> it[size * sources[i / size].vertex + i % size] } }

        val normals = FloatArray(3 * sources.size)
        for ((i, copy) in sources.withIndex()) {
            normals[3 * i] = copy.x
            normals[3 * i + 1] = copy.y
            normals[3 * i + 2] = copy.z
        }
        return Mesh(
            checkNotNull(gather(mesh.positions, 3)),
            triangles,
            mesh.material,
            normals,
            gather(mesh.uvs, 2),
            gather(mesh.colors, 4),
        )
    }

    private data class Copy(val vertex: Int, val x: Float, val y: Float, val z: Float)

    private data class Position(val x: Float, val y: Float, val z: Float)

    /** Lists the corners (three a triangle) that are at one position, in the order of the triangles. */
    private fun cornersByPosition(mesh: Mesh): Collection<IntArray> {
        val lists = LinkedHashMap<Position, ArrayList<Int>>()
        for ((corner, vertex) in mesh.triangles.withIndex()) {
            // Adding 0 makes -0 equal to 0
            val position = Position(
                mesh.positions[3 * vertex] + 0f,
                mesh.positions[3 * vertex + 1] + 0f,
                mesh.positions[3 * vertex + 2] + 0f,
            )
            lists.getOrPut(position) { ArrayList() }.add(corner)
        }
        return lists.values.map { it.toIntArray() }
    }

    /** Each triangle's normal, as long as twice its area; 0 where it is not finite. */
    private fun faceNormals(mesh: Mesh): DoubleArray {
        val normals = DoubleArray(mesh.triangles.size)
        val p = mesh.positions
        for (i in normals.indices step 3) {
            val a = 3 * mesh.triangles[i]
            val b = 3 * mesh.triangles[i + 1]
            val c = 3 * mesh.triangles[i + 2]
            val ux = p[b].toDouble() - p[a]
            val uy = p[b + 1].toDouble() - p[a + 1]
            val uz = p[b + 2].toDouble() - p[a + 2]
            val vx = p[c].toDouble() - p[a]
            val vy = p[c + 1].toDouble() - p[a + 1]
            val vz = p[c + 2].toDouble() - p[a + 2]
            val x = uy * vz - uz * vy
            val y = uz * vx - ux * vz
            val z = ux * vy - uy * vx
            if (x.isFinite() && y.isFinite() && z.isFinite()) {
                normals[i] = x
                normals[i + 1] = y
                normals[i + 2] = z
            }
        }
        return normals
    }

    private fun dot(normals: DoubleArray, a: Int, b: Int): Double =
        normals[3 * a] * normals[3 * b] + normals[3 * a + 1] * normals[3 * b + 1] +
            normals[3 * a + 2] * normals[3 * b + 2]

    private fun length(normals: DoubleArray, face: Int): Double = StrictMath.sqrt(dot(normals, face, face))

    /** Writes (x, y, z) with unit length to three places of [out]; a vector without length stays 0. */
    private fun unit(x: Double, y: Double, z: Double, out: FloatArray, at: Int) {
        val length = StrictMath.sqrt(x * x + y * y + z * z)
        val scale = if (length > 0.0 && length.isFinite()) 1.0 / length else 0.0
        out[at] = (x * scale).toFloat()
        out[at + 1] = (y * scale).toFloat()
        out[at + 2] = (z * scale).toFloat()
    }
}
