package dev.lazyz.setup

import dev.lazyz.Lines
import dev.lazyz.Points
import org.joml.Matrix4dc

/** Moves points and lines. */
internal object PointGeometry {
    fun transformed(points: Points, m: Matrix4dc): Points {
        val normals = points.normals?.let { MeshGeometry.normals(it, m) }
        return Points(MeshGeometry.positions(points.positions, m), points.size, points.material, normals, points.colors)
    }

    fun transformed(lines: Lines, m: Matrix4dc): Lines =
        Lines(MeshGeometry.positions(lines.positions, m), lines.segments, lines.width, lines.material, lines.colors)
}
