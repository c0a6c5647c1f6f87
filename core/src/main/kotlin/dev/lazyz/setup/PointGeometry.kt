package dev.lazyz.setup

import dev.lazyz.Lines
import dev.lazyz.Points
import org.joml.Matrix4dc

/** Moves points and lines. */
internal object PointGeometry {
    fun transformed(points: Points, m: Matrix4dc): Points {
        val origin = MeshGeometry.origin(points.bounds, m)
        val positions = MeshGeometry.positions(points.positions, points.origin, m, origin)
        val normals = points.normals?.let { MeshGeometry.normals(it, m) }
        return Points(positions, points.size, points.material, normals, points.colors, origin)
    }

    fun transformed(lines: Lines, m: Matrix4dc): Lines {
        val origin = MeshGeometry.origin(lines.bounds, m)
        val positions = MeshGeometry.positions(lines.positions, lines.origin, m, origin)
        return Lines(positions, lines.segments, lines.width, lines.material, lines.colors, origin)
    }
}
