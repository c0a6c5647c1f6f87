package dev.lazyz.setup

import dev.lazyz.Box
import dev.lazyz.Mesh
import kotlin.math.sqrt
import org.joml.Matrix4dc
import org.joml.Vector3d
import org.joml.Vector3dc

/** Moves meshes. */
internal object MeshGeometry {
    /** Returns [mesh] at the same place with positions relative to [origin]. */
    fun relativeTo(mesh: Mesh, origin: Vector3dc): Mesh {
        val way = Vector3d(
            mesh.origin.x() - origin.x(),
            mesh.origin.y() - origin.y(),
            mesh.origin.z() - origin.z(),
        )
        val positions = FloatArray(mesh.positions.size)
        for (i in positions.indices step 3) {
            positions[i] = (mesh.positions[i] + way.x).toFloat()
            positions[i + 1] = (mesh.positions[i + 1] + way.y).toFloat()
            positions[i + 2] = (mesh.positions[i + 2] + way.z).toFloat()
        }
        return Mesh(positions, mesh.triangles, mesh.material, mesh.normals, mesh.uvs, mesh.colors, origin)
    }

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

        val origin = originOf(mesh, m)
        val from = mesh.origin
        val positions = FloatArray(mesh.positions.size)
        for (i in positions.indices step 3) {
            val x = mesh.positions[i] + from.x()
            val y = mesh.positions[i + 1] + from.y()
            val z = mesh.positions[i + 2] + from.z()
            positions[i] = (m.m00() * x + m.m10() * y + m.m20() * z + m.m30() - origin.x).toFloat()
            positions[i + 1] = (m.m01() * x + m.m11() * y + m.m21() * z + m.m31() - origin.y).toFloat()
            positions[i + 2] = (m.m02() * x + m.m12() * y + m.m22() * z + m.m32() - origin.z).toFloat()
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
        return Mesh(positions, triangles, mesh.material, normals, mesh.uvs, mesh.colors, origin)
    }

    /** Returns the origin that [mesh] should have when it was moved by [m]. */
    private fun originOf(mesh: Mesh, m: Matrix4dc): Vector3d {
        val box = mesh.bounds ?: return Vector3d()
        val corners = List(8) { box.corner(it) }
        val moved = Box.around(8) { corner, axis ->
            val at = corners[corner]
            m.get(0, axis) * at.x + m.get(1, axis) * at.y + m.get(2, axis) * at.z + m.get(3, axis)
        }
        return moved?.origin() ?: Vector3d()
    }

    /** Writes (x, y, z) with unit length to three places of [out]; a vector without length stays 0. */
    fun unit(x: Double, y: Double, z: Double, out: FloatArray, at: Int) {
        val length = sqrt(x * x + y * y + z * z)
        val scale = if (length > 0.0 && length.isFinite()) 1.0 / length else 0.0
        out[at] = (x * scale).toFloat()
        out[at + 1] = (y * scale).toFloat()
        out[at + 2] = (z * scale).toFloat()
    }
}
